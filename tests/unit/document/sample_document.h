// SPDX-License-Identifier: MIT
#pragma once

/// Documents and random edits for the tests of engine/document.

#include <cstdint>
#include <vector>

#include "document/edits.h"

namespace patina::test_support {

/// Two materials with fills, a masked one, a group with a group in it, one image, one light, and a
/// mesh of two parts, each with one of the materials.
Document sample_document();

/// The image of sample_document.
ImageAssetPtr sample_image();

/// Decisions drawn from a list of numbers; 0 for ever when it is used up, so that a shorter list is
/// a simpler case.
class Choices {
  public:
    explicit Choices(std::vector<std::uint32_t> numbers) : numbers_(std::move(numbers)) {}

    bool used_up() const { return next_ >= numbers_.size(); }
    /// 0 to count - 1.
    int below(int count);
    bool coin() { return below(2) == 1; }
    /// Mostly in low..high, at times its ends, at times outside, at times NaN.
    float number(float low, float high);

  private:
    std::uint32_t draw() { return used_up() ? 0 : numbers_[next_++]; }
    std::vector<std::uint32_t> numbers_;
    std::size_t next_ = 0;
};

/// Some edit of some part of the document: any function of edits.h, with values that may be bad.
Edit random_edit(const Document& document, Choices& choices);

/// All layers of a stack, groups before their children.
std::vector<LayerPtr> all_layers(const std::vector<LayerPtr>& stack);

/// Every id of layers and mask entries in the document.
std::vector<std::uint64_t> all_ids(const Document& document);

}  // namespace patina::test_support

// SPDX-License-Identifier: MIT
#pragma once

/// The work item of the composite's benchmarks: a base and ten layers of images with masks, made
/// from integer hashes, the same bytes on every machine; and what it is measured against.

#include <array>
#include <cstdint>
#include <vector>

#include "composite/image_provider.h"
#include "document/material.h"

namespace patina::bench {

inline constexpr int kLayers = 10;

/// The images of one size, as they are stored: interleaved bytes.
struct Stack10 {
    int size = 0;
    ImagePtr base;                            ///< RGB
    std::array<ImagePtr, kLayers> color;      ///< RGBA
    std::array<ImagePtr, kLayers> mask;       ///< grey
    std::array<ImagePtr, kLayers> roughness;  ///< grey

    std::size_t texels() const {
        return static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    }
};

enum class StackMode { Normal, Multiply, Screen, Overlay, Add, SoftLight };
StackMode mode_of(int layer);
float opacity_of(int layer);
float metalness_of(int layer);

/// Made when first asked for and kept until another size is asked for.
const Stack10& stack10(int size);

/// Both outputs, interleaved RGB bytes: base colour, and occlusion, roughness, metalness.
struct StackOutput {
    std::vector<std::uint8_t> base_color;
    std::vector<std::uint8_t> packed;
};

/// Only reads and writes the bytes of the work item, as fast as one thread can.
void touch(const Stack10& stack, StackOutput& out);
/// What a first attempt looks like: one pass per layer over a canvas of floats, a switch per texel.
void composite_naively(const Stack10& stack, StackOutput& out);
/// In double precision, texel by texel; only rows of which y % `stride` is 0.
void composite_reference(const Stack10& stack, int stride, StackOutput& out);

/// The work item as a document has it: fill layers whose masks have two entries, multiplied (the
/// mask image and the colour's alpha), over the images of the last stack10().
Material stack10_material(BlendSpace space);

/// Hands out the images of the last stack10().
ImageProvider& stack10_images();

}  // namespace patina::bench

// SPDX-License-Identifier: MIT
#pragma once

/// Stacks made at random from a seed: all modes, masks, groups, blend spaces and kinds of image.

#include <random>

#include "composite/image_table.h"
#include "document/material.h"

namespace patina {

/// ConstantsAndImages: what a reference in double precision can follow to the last byte; modes that
/// divide or have a step are left out as well.
enum class RandomSources { ConstantsAndImages, All };

class RandomStack {
  public:
    /// @param size  side of the maps that are meant; some images have it, so that they are read row
    ///              by row, others are a little larger or smaller
    RandomStack(std::uint32_t seed, int size, RandomSources sources);

    Material material();
    /// A layer anywhere in the stack changed in one respect.
    Material edited(const Material& material);

    ImageTable images;

  private:
    int index(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
    bool chance(int percent) { return index(100) < percent; }
    float number(float low = 0.0f, float high = 1.0f) {
        return low + (high - low) * static_cast<float>(index(1025)) / 1024.0f;
    }
    Hash128 image(int channels);
    ImageSource image_source(Channel channel);
    ProceduralSource procedural();
    Source source(Channel channel);
    Mask mask();
    BlendMode mode(Channel channel);
    BlendMode combine();
    AdjustmentSettings mask_adjustment();
    AdjustmentSettings adjustment();
    Layer layer(int depth);
    std::vector<LayerPtr> stack(int layers, int depth);

    std::mt19937 random_;
    int size_;
    RandomSources sources_;
    std::uint64_t next_id_ = 1;
    std::vector<LayerId> finished_;  ///< layers that those to come can refer to
};

}  // namespace patina

// SPDX-License-Identifier: MIT
#pragma once

/// Hashes of what layers do: equal ones, equal texels.

#include "composite/stack_terms.h"

namespace patina {

/// Hash of a procedural's pattern at its UVs, before contrast and ramp.
Hash128 pattern_hash(const ProceduralSource& source);

/// Hash of what a layer does to `channels`, its children, its mask and what it refers to included.
Hash128 layer_hash(const LayerTerms& terms, ChannelBits channels, ReferredLayers& referred);

}  // namespace patina

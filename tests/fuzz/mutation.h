// SPDX-License-Identifier: MIT
#pragma once

/// Damage done at random to models, the same for the same seed.

#include <random>
#include <vector>

#include "io/sample_gltf.h"

namespace patina::io::test {

using Random = std::mt19937_64;

/// A GLB made from the model with one to four changes: bytes of the data, characters and numbers of
/// the text (also inside the record of a material), or whole values of the JSON that are replaced,
/// taken away, doubled or put in another's place.
Bytes mutant(const SampleGltf& model, Random& random);

/// What mutants are made of: a file that holds one of nearly everything, the same with the layers
/// that Patina saves, and small real models where ../shared/assets is there.
std::vector<SampleGltf> models_to_mutate();

}  // namespace patina::io::test

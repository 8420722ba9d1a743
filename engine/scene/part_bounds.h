// SPDX-License-Identifier: MIT
#pragma once

/// How much of the world parts of a model take.

#include <set>

#include "scene/scene.h"

namespace patina {

/// Of all instances of the parts; empty where none is shown.
Bounds bounds_world_of(const Scene& scene, const std::set<PartRef>& parts);

}  // namespace patina

// SPDX-License-Identifier: MIT
#pragma once

/// Edits of what belongs to no material: images, environment, lights. See edits.h for what holds
/// for all edits.

#include <string>

#include "document/edit.h"

namespace patina {

/// Several edits as one step: all of them or, when one is refused, none. Merges with nothing.
Edit in_one_step(std::string label, Edits edits);

/// Puts an image into the document's table so that sources can name it; a second time is no change.
Edit add_image(ImageAssetPtr image);

/// A built-in name ("studio") or the path of an .hdr or .exr file.
Edit set_environment_name(std::string name);
/// Degrees about +Y, -360 to 360.
Edit set_environment_rotation(float degrees);
/// 0 to 100.
Edit set_environment_intensity(float intensity);
/// Of the built-in sky, 0 to 90.
Edit set_sun_elevation(float degrees);

/// Lights are known by their place in Document::lights, of which there are at most kMaxLights.
/// Colour 0 to 1 each, intensity 0 to 1e9, direction not zero (kept as a unit vector), cones 0 <=
/// inner < outer <= 90 degrees, radius, width and height 1e-3 to 1e6 m.
Edit add_light(const Light& light);
Edit remove_light(int index);
Edit set_light(int index, const Light& light);

}  // namespace patina

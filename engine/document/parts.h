// SPDX-License-Identifier: MIT
#pragma once

/// The parts of the model, which are the primitives of its meshes, and what each is drawn with: the
/// material that the file gives it, or the one that it was assigned.

#include <map>
#include <string>
#include <vector>

#include "document/document.h"

namespace patina {

struct Part {
    PartRef ref;
    std::string name;      ///< of the first node that shows it, numbered where its mesh has several
    MaterialPtr material;  ///< what it is drawn with, or null
    MaterialPtr material_of_file;  ///< what the file that was opened draws it with, or null
};

/// Those that are drawn, each once, in the order of the scene.
std::vector<Part> parts_of(const Document& document);

/// What that primitive is drawn with, or null.
MaterialPtr material_of_part(const Document& document, const Primitive& primitive);

/// By which number (Material::source_material, -1 where it is unset) each assigned part is drawn.
std::map<PartRef, int> assigned_numbers(const Document& document);

}  // namespace patina

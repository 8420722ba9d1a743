// SPDX-License-Identifier: MIT
#pragma once

/// Edits of which materials there are and which parts of the model are drawn with them. See edits.h
/// for what holds for all edits.

#include "document/edit.h"
#include "document/parts.h"

namespace patina {

/// The most materials of a document that edits make.
inline constexpr int kMaxMaterials = 4096;

/// A material without layers behind those that are there, drawn on nothing yet. Its id is the
/// document's next_id.
Edit add_material(std::string name);
/// A copy with fresh ids behind those that are there, drawn on nothing yet. Its id is the
/// document's next_id.
Edit duplicate_material(const Material& material);
/// Takes an added material away; its parts go back to what the file gives them. One of the file is
/// refused: other parts of the file may count on it.
Edit remove_material(const Material& material);

/// Draws that part with the material.
Edit assign_material(const Material& material, const Part& part);

/// "Material", or "Material 2" and on when that is taken.
std::string free_material_name(const Document& document, std::string_view wanted);

}  // namespace patina

// SPDX-License-Identifier: MIT
#pragma once

/// Edits of a material beside its stack, and of the whole stack from presets and the clipboard. See
/// edits.h for what holds for all edits.

#include <string>
#include <string_view>
#include <vector>

#include "document/edit.h"
#include "document/layer_edits.h"

namespace patina {

struct Preset;

Edit rename_material(const Material& material, std::string name);
/// 256, 512, 1024, 2048, 4096 or 8192.
Edit set_material_resolution(const Material& material, int resolution);
/// 0 or 1: the TEXCOORD_n that baked maps use.
Edit set_material_uv_set(const Material& material, int uv_set);
/// 0 to 1.
Edit set_material_height_scale(const Material& material, float height_scale);
Edit set_material_padding(const Material& material, Padding padding);
Edit set_material_alpha_mode(const Material& material, AlphaMode mode);
/// 0 to 1.
Edit set_material_alpha_cutoff(const Material& material, float cutoff);
Edit set_material_double_sided(const Material& material, bool double_sided);
Edit set_material_unlit(const Material& material, bool unlit);
/// 1 to 4.
Edit set_material_ior(const Material& material, float ior);
/// 0 to 1.
Edit set_material_specular_factor(const Material& material, float factor);
/// Linear, each component 0 to 1.
Edit set_material_specular_color(const Material& material, const glm::vec3& color_linear);
/// 0 to 100.
Edit set_material_emissive_strength(const Material& material, float strength);

/// Adds a preset's layers: several as an isolated group with the preset's name, a single one as it
/// is. `images` are the preset's images as an ImageStore read them.
Edit apply_preset(const Material& material, const Preset& preset, LayerPlace place,
                  std::vector<ImageAssetPtr> images = {});
/// Puts a preset's layers in the place of the stack.
Edit replace_stack_by_preset(const Material& material, const Preset& preset,
                             std::vector<ImageAssetPtr> images = {});

/// The layers as text for the clipboard: JSON in the form of the record (document/record.h).
/// @param stack  what they are of: whose names the layers that they read go by elsewhere
std::string copied_layers(const std::vector<LayerPtr>& layers,
                          const std::vector<LayerPtr>& stack = {});
/// Adds the layers that `copied_layers` made text of, with fresh ids. Refuses other text, and
/// images that this document has not. What they read of other layers is read of those of the same
/// names, or left out, which a line in the log says.
Edit paste_layers(const Material& material, std::string_view text, LayerPlace place);

}  // namespace patina

// SPDX-License-Identifier: MIT

/// What Patina writes, under the Khronos glTF validator: no error that the input has not.

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "document/material_edits.h"
#include "document/material_list_edits.h"
#include "io/json_splice.h"
#include "io/save_fixture.h"
#include "support/gltf_validator.h"

namespace patina::io {
namespace {

class Validator : public Save {
  protected:
    void SetUp() override {
        if (!tests::has_gltf_validator())
            GTEST_SKIP() << "gltf-validator or node is not installed; ./test installs both";
    }
};

Document with_settings(Document document) {
    const auto material = [&]() -> const Material& { return material_at(document, 0); };
    document = with(document, set_material_alpha_mode(material(), AlphaMode::Mask));
    document = with(document, set_material_alpha_cutoff(material(), 0.25f));
    document = with(document, set_material_double_sided(material(), true));
    document = with(document, set_material_ior(material(), 1.33f));
    document = with(document, set_material_specular_factor(material(), 0.5f));
    document = with(document, set_material_specular_color(material(), {1.0f, 0.5f, 0.25f}));
    document = with(document, set_material_emissive_strength(material(), 5.0f));
    return document;
}

/// Every channel from noise, so that every map is baked.
Document with_all_channels(const Document& document) {
    Layer layer;
    layer.id = LayerId{document.next_id};
    layer.name = "All";
    for (const ChannelInfo& info : kChannels)
        at(layer.channels, info.channel) = {.enabled = true, .source = noise(7)};
    Material material = material_at(document, 0);
    material.resolution = kMinResolution;
    material.stack.push_back(std::make_shared<const Layer>(layer));
    Document after = with_material(document, 0, std::move(material));
    ++after.next_id;
    return after;
}

/// The lowest layer's images scaled, so that they are shown untouched with a transform.
Document with_transformed_images(const Document& document) {
    Material material = material_at(document, 0);
    Layer layer = *material.stack.front();
    for (ChannelSettings& channel : layer.channels)
        if (auto* image = std::get_if<ImageSource>(&channel.source)) {
            image->transform.scale = {2.0f, 3.0f};
            image->transform.rotation_degrees = 30.0f;
            image->wrap_u = Wrap::Mirror;
        }
    material.stack.front() = std::make_shared<const Layer>(layer);
    return with_material(document, 0, std::move(material));
}

/// The first material and a copy of it, which are drawn on the last part and the first.
Document with_parts_exchanged(const Document& document) {
    const std::vector<Part> parts = patina::parts_of(document);
    Document after = with(document, assign_material(material_at(document, 0), parts.back()));
    after = with(after, duplicate_material(material_at(document, 0)));
    for (const MaterialPtr& material : after.materials)
        if (is_added(*material)) return with(after, assign_material(*material, parts.front()));
    return after;
}

TEST_F(Validator, FindsNoErrorInAnOutputThatItDoesNotFindInTheInput) {
    const auto models = asset_models();
    SKIP_WITHOUT(models);
    std::map<fs::path, fs::path> input_of;
    std::vector<fs::path> files = models;
    for (const auto& model : models) {
        const auto document = loaded(model);
        const Document& opened = *document.document;
        const auto folder = folder_ / model.stem();
        fs::create_directories(folder);
        const std::map<std::string, Document> edits = {
            {"unedited", opened},
            {"noise", with_noise_layer(opened, 0)},
            {"all", with_all_channels(opened)},
            {"settings", with_settings(opened)},
            {"unlit", with(opened, set_material_unlit(material_at(opened, 0), true))},
            {"transformed", with_transformed_images(opened)},
            {"parts", with_parts_exchanged(opened)},
        };
        for (const auto& [name, edited] : edits)
            for (const char* extension : {".glb", ".gltf"}) {
                files.push_back(folder / (name + extension));
                input_of[files.back()] = model;
                saved(edited, *document.images, files.back());
            }
    }
    std::map<fs::path, std::set<std::string>> codes;
    for (const auto& [file, errors] : tests::gltf_errors_in(files))
        for (const std::string& error : errors) codes[file].insert(tests::gltf_error_code(error));
    for (const auto& [output, input] : input_of)
        for (const std::string& code : codes[output])
            EXPECT_TRUE(codes[input].contains(code)) << output << ": " << code;
}

}  // namespace
}  // namespace patina::io

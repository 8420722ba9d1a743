// SPDX-License-Identifier: MIT

/// What Patina writes, under the Khronos glTF validator: no error that the input has not.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>

#include "document/material_edits.h"
#include "io/json_splice.h"
#include "io/save_fixture.h"

namespace patina::io {
namespace {

const fs::path kModules = fs::path(PATINA_SOURCE_DIR) / "build" / "node" / "node_modules";

using Codes = std::set<std::string>;

/// The codes of the errors that the validator finds in each file.
std::map<fs::path, Codes> errors_in(const std::vector<fs::path>& files) {
    const auto script = fs::path(PATINA_SOURCE_DIR) / "tests" / "cli" / "validate.cjs";
    std::string command = fmt::format("node '{}' '{}'", script.string(), kModules.string());
    for (const fs::path& file : files) command += fmt::format(" '{}'", file.string());
    std::FILE* const pipe = ::popen(command.c_str(), "r");
    std::string out;
    std::array<char, 4096> buffer = {};
    while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), pipe))
        out.append(buffer.data(), got);
    EXPECT_EQ(::pclose(pipe), 0) << command;
    std::map<fs::path, Codes> errors;
    const Json report = Json::parse(out, nullptr, false);
    EXPECT_EQ(report.size(), files.size()) << "the validator said: " << out;
    for (const auto& [file, found] : report.items())
        for (const auto& error : found) {
            // "CODE /json/pointer"
            const auto text = error.get<std::string>();
            errors[file].insert(text.substr(0, text.find(' ')));
        }
    return errors;
}

class Validator : public Save {
  protected:
    void SetUp() override {
        if (!fs::exists(kModules / "gltf-validator"))
            GTEST_SKIP() << "gltf-validator is not installed; ./test does it";
        if (std::system("node --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no node";
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
        };
        for (const auto& [name, edited] : edits)
            for (const char* extension : {".glb", ".gltf"}) {
                files.push_back(folder / (name + extension));
                input_of[files.back()] = model;
                saved(edited, *document.images, files.back());
            }
    }
    auto errors = errors_in(files);
    for (const auto& [output, input] : input_of)
        for (const std::string& code : errors[output])
            EXPECT_TRUE(errors[input].contains(code)) << output << ": " << code;
}

}  // namespace
}  // namespace patina::io

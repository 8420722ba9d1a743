// SPDX-License-Identifier: MIT
#pragma once

/// Small glTF files made by the tests: a whole one to break in one place, and the parts to build
/// others from.

#include <cstring>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/files.h"
#include "io/load.h"
#include "io/png_writer.h"

namespace patina::io::test {

using Json = nlohmann::json;

inline Bytes bytes_from(const std::string& text) {
    const auto bytes = bytes_of(text);
    return Bytes(bytes.begin(), bytes.end());
}

/// Appends numbers as they lie in memory, padded to four bytes.
template <typename T>
void append(Bytes& out, std::initializer_list<T> numbers) {
    const auto bytes = std::as_bytes(std::span(numbers.begin(), numbers.size()));
    out.insert(out.end(), bytes.begin(), bytes.end());
    out.resize((out.size() + 3) / 4 * 4);
}

inline void append_word(Bytes& out, std::size_t word) {
    append<std::uint32_t>(out, {static_cast<std::uint32_t>(word)});
}

inline std::uint32_t word_at(const Bytes& bytes, std::size_t offset) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i)
        word |= static_cast<std::uint32_t>(bytes.at(offset + i)) << (8 * i);
    return word;
}

/// A GLB of one JSON chunk and, unless it is empty, one binary chunk.
inline Bytes make_glb(std::string json, Bytes binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4);
    const std::size_t binary_chunk = binary.empty() ? 0 : 8 + binary.size();
    Bytes glb;
    append_word(glb, 0x46546C67);
    append_word(glb, 2);
    append_word(glb, 12 + 8 + json.size() + binary_chunk);
    append_word(glb, json.size());
    append_word(glb, 0x4E4F534A);
    const auto text = bytes_of(json);
    glb.insert(glb.end(), text.begin(), text.end());
    if (binary.empty()) return glb;
    append_word(glb, binary.size());
    append_word(glb, 0x004E4942);
    glb.insert(glb.end(), binary.begin(), binary.end());
    return glb;
}

/// A PNG of one colour.
inline Bytes plain_png(int width, int height, std::uint8_t red, std::uint8_t green,
                       std::uint8_t blue) {
    Image image;
    image.width = width;
    image.height = height;
    image.channels = 3;
    for (int i = 0; i < width * height; ++i)
        image.data.insert(image.data.end(), {std::byte(red), std::byte(green), std::byte(blue)});
    return encode_png(image).value();
}

inline Json view(std::size_t offset, std::size_t length) {
    return {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}};
}
inline Json accessor(int view, int component_type, int count, const char* type) {
    return {
        {"bufferView", view}, {"componentType", component_type}, {"count", count}, {"type", type}};
}

/// A valid file that holds one of nearly everything: one triangle with all attributes, a morph
/// target, a skin, an animation, a camera, a light, a variant, a sparse accessor and a texture.
struct SampleGltf {
    Json json;
    Bytes binary;

    Bytes glb() const { return make_glb(json.dump(), binary); }
};

inline SampleGltf sample_gltf() {
    SampleGltf sample;
    Bytes& binary = sample.binary;
    Json views = Json::array();
    const auto add_view = [&](auto append_data) {
        const std::size_t start = binary.size();
        append_data();
        views.push_back(view(start, binary.size() - start));
    };
    add_view([&] { append<float>(binary, {0, 0, 0, 1, 0, 0, 0, 1, 0}); });
    add_view([&] { append<float>(binary, {0, 0, 1, 0, 0, 1, 0, 0, 1}); });
    add_view([&] { append<float>(binary, {0, 1, 1, 1, 0, 0}); });
    add_view([&] { append<std::uint16_t>(binary, {0, 1, 2}); });
    add_view([&] { append<std::uint8_t>(binary, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}); });
    add_view([&] { append<float>(binary, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}); });
    add_view([&] { append<float>(binary, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}); });
    add_view([&] { append<std::uint16_t>(binary, {0, 2}); });
    add_view([&] { append<float>(binary, {0, 0, 1, 0, 0, 1}); });
    add_view([&] {
        const Bytes png = plain_png(4, 4, 200, 100, 50);
        binary.insert(binary.end(), png.begin(), png.end());
    });
    // A view of one image ends where its PNG does; padding is the buffer's.
    const std::size_t length = binary.size();
    sample.json = {
        {"asset", {{"version", "2.0"}}},
        {"extensionsUsed", {"KHR_lights_punctual", "KHR_materials_variants"}},
        {"scene", 0},
        {"scenes", {{{"nodes", {0, 2}}}}},
        {"nodes",
         {{{"name", "Body"}, {"mesh", 0}, {"skin", 0}, {"children", {1}}},
          {{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}},
          {{"name", "Joint"}}}},
        {"cameras", {{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}}},
        {"skins", {{{"joints", {2}}, {"skeleton", 2}, {"inverseBindMatrices", 6}}}},
        {"animations",
         {{{"samplers", {{{"input", 8}, {"output", 7}}}},
           {"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}}}}}}},
        {"meshes",
         {{{"name", "Triangle"},
           {"weights", {0.0}},
           {"primitives",
            {{{"attributes",
               {{"POSITION", 0},
                {"NORMAL", 1},
                {"TEXCOORD_0", 2},
                {"JOINTS_0", 4},
                {"WEIGHTS_0", 5}}},
              {"indices", 3},
              {"material", 0},
              {"targets", {{{"POSITION", 7}}}},
              {"extensions",
               {{"KHR_materials_variants",
                 {{"mappings", {{{"material", 0}, {"variants", {0}}}}}}}}}}}}}}},
        {"accessors",
         {accessor(0, 5126, 3, "VEC3"),
          accessor(1, 5126, 3, "VEC3"),
          accessor(2, 5126, 3, "VEC2"),
          accessor(3, 5123, 3, "SCALAR"),
          accessor(4, 5121, 3, "VEC4"),
          accessor(5, 5126, 3, "VEC4"),
          accessor(6, 5126, 1, "MAT4"),
          {{"componentType", 5126},
           {"count", 3},
           {"type", "VEC3"},
           {"sparse",
            {{"count", 2},
             {"indices", {{"bufferView", 7}, {"componentType", 5123}}},
             {"values", {{"bufferView", 8}}}}}},
          accessor(8, 5126, 3, "SCALAR")}},
        {"bufferViews", views},
        {"buffers", {{{"byteLength", length}}}},
        {"images", {{{"bufferView", 9}, {"mimeType", "image/png"}}}},
        {"samplers", {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}}},
        {"textures", {{{"source", 0}, {"sampler", 0}}}},
        {"materials",
         {{{"name", "Paint"},
           {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 0}}}}},
           {"normalTexture", {{"index", 0}}},
           {"occlusionTexture", {{"index", 0}}},
           {"emissiveTexture", {{"index", 0}}}}}},
        {"extensions",
         {{"KHR_lights_punctual", {{"lights", {{{"type", "point"}, {"intensity", 20.0}}}}}},
          {"KHR_materials_variants", {{"variants", {{{"name", "Red"}}}}}}}}};
    return sample;
}

inline Result<LoadedDocument> load_from(const Json& json, const Bytes& binary) {
    return load_document_from_memory(make_glb(json.dump(), binary), "model.glb");
}

inline Primitive first_primitive(const Result<LoadedDocument>& loaded) {
    return loaded->document->scene->meshes.at(0).primitives.at(0);
}

/// The channel of the lowest layer.
inline const ChannelSettings& lowest_channel(const Material& material, Channel channel) {
    return at(material.stack.at(0)->channels, channel);
}

}  // namespace patina::io::test

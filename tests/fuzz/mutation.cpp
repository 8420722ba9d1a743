// SPDX-License-Identifier: MIT
#include "mutation.h"

#include <array>
#include <filesystem>
#include <iterator>

#include "document/record.h"
#include "io/glb.h"

namespace patina::io::test {
namespace {

std::size_t below(Random& random, std::size_t n) {
    return static_cast<std::size_t>(random() % n);
}

void change_byte(Bytes& bytes, Random& random) {
    if (!bytes.empty()) bytes[below(random, bytes.size())] = static_cast<std::byte>(random());
}

/// Numbers at the edges of what indices, sizes and floats can be.
void change_number(std::string& text, Random& random) {
    constexpr std::array kNumbers = {"-1",   "0",   "99",    "4294967295", "1e9",
                                     "0.5",  "3.0", "1e400", "2147483647", "-0.0",
                                     "1e39", "252", "16385"};
    const std::size_t at = text.find_first_of("0123456789", below(random, text.size()));
    if (at != std::string::npos) text.replace(at, 1, kNumbers[below(random, kNumbers.size())]);
}

void change_text(std::string& text, Random& random) {
    switch (below(random, 3)) {
        case 0:
            text[below(random, text.size())] = static_cast<char>(random());
            break;
        case 1:
            text.erase(below(random, text.size()), 1 + below(random, 4));
            break;
        default:
            change_number(text, random);
    }
}

/// Some value inside `root`, the root itself among them.
Json& random_value(Json& root, Random& random) {
    Json* value = &root;
    while (value->is_structured() && !value->empty() && below(random, 6) != 0) {
        auto child = value->begin();
        std::advance(child, below(random, value->size()));
        value = &*child;
    }
    return *value;
}

void change_value(Json& root, Random& random) {
    const std::array kValues = {Json(nullptr),        Json(true), Json(""),       Json::array(),
                                Json::object(),       Json(-1),   Json(1u << 31), Json({1, 2, 3}),
                                Json({{"index", 0}}), Json(0.5)};
    Json& value = random_value(root, random);
    switch (below(random, 4)) {
        case 0:
            value = kValues[below(random, kValues.size())];
            break;
        case 1:
            value = Json(random_value(root, random));
            break;
        case 2:
            if (value.is_array() && !value.empty()) value.push_back(Json(value.back()));
            break;
        default:
            if (value.is_structured() && !value.empty()) {
                auto child = value.begin();
                std::advance(child, below(random, value.size()));
                value.erase(child);
            }
    }
}

SampleGltf sample_with_layers() {
    SampleGltf sample = sample_gltf();
    const auto loaded = load_from(sample.json, sample.binary);
    const Document& document = *loaded.value().document;
    sample.json["materials"][0]["extras"]["patina"] =
        to_json(material_record(document, *document.materials.at(0)));
    return sample;
}

void add_real_models(std::vector<SampleGltf>& models) {
    const auto folder =
        std::filesystem::path(PATINA_SOURCE_DIR) / ".." / "shared" / "assets" / "models";
    for (const char* name : {"AnimatedMorphCube.glb", "BoxVertexColors.glb"}) {
        auto file = read_file(folder / name);
        if (!file) continue;
        SourceAsset asset;
        asset.file = std::move(*file);
        if (!split_container(asset)) continue;
        models.push_back({Json::parse(asset.json_text), std::move(asset.binary_chunk)});
    }
}

}  // namespace

Bytes mutant(const SampleGltf& model, Random& random) {
    Json json = model.json;
    Bytes binary = model.binary;
    const std::size_t values = below(random, 3);
    for (std::size_t i = 0; i < values; ++i) change_value(json, random);
    std::string text = json.dump();
    const std::size_t others = values == 0 ? 1 + below(random, 3) : below(random, 2);
    for (std::size_t i = 0; i < others; ++i) {
        if (below(random, 4) == 0)
            change_byte(binary, random);
        else if (!text.empty())
            change_text(text, random);
    }
    return make_glb(text, binary);
}

std::vector<SampleGltf> models_to_mutate() {
    std::vector<SampleGltf> models = {sample_gltf(), sample_with_layers()};
    add_real_models(models);
    return models;
}

}  // namespace patina::io::test

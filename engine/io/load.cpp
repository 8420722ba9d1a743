// SPDX-License-Identifier: MIT
#include "io/load.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/document_read.h"
#include "io/glb.h"
#include "io/gltf_check.h"
#include "io/json_check.h"
#include "io/scene_read.h"
#include "io/specular_glossiness.h"

namespace patina::io {
namespace {

/// Faults that name no remedy of their own mean that the file is damaged.
Error with_remedy(Error error) {
    if (error.message != "cancelled" && error.message.find("; ") == std::string::npos)
        error.message += "; the model is damaged: export it again";
    return error;
}

struct ReadModel {
    CheckedGltf checked;
    tinygltf::Model model;
};

Result<ReadModel> read_model(const SourceAsset& asset, const LoadLimits& limits) {
    auto json = parse_json(asset.json_text, {.depth = limits.json_depth});
    if (!json) return failure("JSON: {}", json.error().message);
    auto checked = check_gltf(*json, {.nodes = limits.nodes, .node_depth = limits.node_depth});
    if (!checked) return passed_on(checked);
    auto model = parse_gltf(std::move(*json));
    if (!model) return passed_on(model);
    return ReadModel{std::move(*checked), std::move(*model)};
}

Result<LoadedDocument> load_parts(std::shared_ptr<SourceAsset> asset, const LoadLimits& limits,
                                  const Progress& progress) {
    if (const auto split = split_container(*asset); !split) return passed_on(split);
    auto read = read_model(*asset, limits);
    if (!read) return passed_on(read);
    tinygltf::Model& model = read->model;
    LoadedDocument loaded;
    loaded.warnings = read->checked.warnings;
    const auto files =
        gather_files(*asset, model, read->checked.buffer_bytes, limits.file_bytes, loaded.warnings);
    if (!files) return passed_on(files);

    const ImageLimits image_limits{.max_decoded_bytes = limits.decoded_image_bytes};
    loaded.images = std::make_shared<ImageStore>(image_limits);
    progress.report(0.1f);
    progress.set_stage(fmt::format("Decoding {} images", model.images.size()));
    auto images =
        decode_images(model, *files, *loaded.images, image_limits, progress, loaded.warnings);
    if (!images) return passed_on(images);
    if (const auto converted =
            convert_specular_glossiness(model, *images, *loaded.images, loaded.warnings);
        !converted)
        return passed_on(converted);
    progress.report(0.6f);
    progress.set_stage("Building the scene");
    auto scene =
        read_scene({model, files->buffers}, limits.geometry_bytes, loaded.warnings, progress);
    if (!scene) return passed_on(scene);
    progress.report(0.95f);

    Document document =
        read_document({model, *asset, *images, *loaded.images, loaded.warnings}, std::move(*scene));
    document.source = std::move(asset);
    document.opened = std::make_shared<const Document>(document);
    std::vector<Hash128> used;
    for (const auto& [hash, image] : document.images) used.push_back(hash);
    loaded.images->keep_only(used);
    loaded.document = std::make_shared<const Document>(std::move(document));
    progress.report(1.0f);
    return loaded;
}

Result<LoadedDocument> load_named(std::shared_ptr<SourceAsset> asset, const std::string& name,
                                  const LoadLimits& limits, const Progress& progress) try {
    auto loaded = load_parts(std::move(asset), limits, progress);
    if (!loaded) return failure("{}: {}", name, with_remedy(loaded.error()).message);
    for (std::string& warning : loaded->warnings) warning = fmt::format("{}: {}", name, warning);
    return loaded;
} catch (const std::bad_alloc&) {
    return failure("{}: does not fit into memory; simplify the model", name);
}

}  // namespace

Result<LoadedDocument> load_document(const std::filesystem::path& path, const LoadLimits& limits,
                                     const Progress& progress) {
    progress.set_stage("Reading the model");
    auto file = read_file(path, limits.file_bytes);
    if (!file) return passed_on(file);
    auto asset = std::make_shared<SourceAsset>();
    asset->path = path;
    asset->file = std::move(*file);
    return load_named(std::move(asset), quoted_for_message(path.string()), limits, progress);
}

Result<LoadedDocument> load_document_from_memory(Bytes glb, std::string name,
                                                 const LoadLimits& limits,
                                                 const Progress& progress) {
    auto asset = std::make_shared<SourceAsset>();
    asset->file = std::move(glb);
    return load_named(std::move(asset), quoted_for_message(name), limits, progress);
}

}  // namespace patina::io

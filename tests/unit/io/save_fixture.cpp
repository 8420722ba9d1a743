// SPDX-License-Identifier: MIT
#include "io/save_fixture.h"

#include <unistd.h>

#include <algorithm>
#include <stdexcept>

#include "io/sample_gltf.h"

namespace patina::io {

std::vector<fs::path> asset_models() {
    std::vector<fs::path> models;
    const fs::path folder = fs::path(PATINA_SOURCE_DIR) / ".." / "shared" / "assets" / "models";
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
        const auto extension = entry.path().extension();
        if (extension == ".glb" || extension == ".gltf") models.push_back(entry.path());
    }
    std::sort(models.begin(), models.end());
    return models;
}

LoadedDocument loaded(const fs::path& path) {
    auto document = load_document(path);
    if (!document) throw std::runtime_error(document.error().message);
    return std::move(*document);
}

Document with(const Document& before, const Edit& edit) {
    auto after = edit.apply(before);
    if (!after) throw std::runtime_error(after.error().message);
    return std::move(*after);
}

ProceduralSource noise(std::uint32_t seed) {
    ProceduralSource source;
    source.seed = seed;
    return source;
}

Document with_material(const Document& document, std::size_t index, Material material) {
    Document after = document;
    after.materials.at(index) = std::make_shared<const Material>(std::move(material));
    return after;
}

Document with_noise_layer(const Document& document, std::size_t index, std::uint32_t seed) {
    Layer layer;
    layer.id = LayerId{document.next_id};
    layer.name = "Noise";
    at(layer.channels, Channel::BaseColor) = {.enabled = true, .source = noise(seed)};
    at(layer.channels, Channel::Roughness) = {.enabled = true, .source = noise(seed + 1)};
    Material material = material_at(document, index);
    material.stack.push_back(std::make_shared<const Layer>(layer));
    material.resolution = kMinResolution;
    Document after = with_material(document, index, std::move(material));
    ++after.next_id;
    return after;
}

Glb parts_of(const Bytes& file) {
    const std::size_t json = test::word_at(file, 12);
    Glb parts;
    parts.json.assign(reinterpret_cast<const char*>(file.data()) + 20, json);
    if (file.size() <= 20 + json) return parts;
    const auto begin = file.begin() + static_cast<std::ptrdiff_t>(28 + json);
    parts.binary.assign(begin, begin + test::word_at(file, 20 + json));
    return parts;
}

std::string json_of(const fs::path& file) {
    if (file.extension() == ".gltf") return read_text_file(file).value();
    return parts_of(read_file(file).value()).json;
}

Save::Save() {
    folder_ = fs::temp_directory_path() /
              fmt::format("patina-save-{}-{}", ::getpid(),
                          testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
}

Save::~Save() {
    fs::remove_all(folder_);
}

fs::path Save::copied(const fs::path& model) {
    const auto folder = folder_ / model.stem();
    fs::create_directories(folder);
    if (model.extension() == ".gltf")
        for (const auto& entry : fs::directory_iterator(model.parent_path()))
            fs::copy(entry.path(), folder);
    else
        fs::copy_file(model, folder / model.filename());
    return folder / model.filename();
}

SaveReport Save::saved(const Document& document, ImageProvider& images, const fs::path& path,
                       const SaveOptions& options) {
    auto report = save_document(document, images, path, options);
    if (!report) throw std::runtime_error(report.error().message);
    return std::move(*report);
}

std::size_t Save::files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

LoadedDocument Save::quad(bool uvs, const std::vector<PlainMaterial>& materials) {
    Mesh mesh;
    Primitive primitive;
    primitive.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    primitive.normals.assign(4, {0, 0, 1});
    if (uvs) primitive.uvs[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    primitive.indices = {0, 1, 2, 0, 2, 3};
    primitive.source_material = materials.empty() ? -1 : 0;
    mesh.primitives.push_back(primitive);
    auto document = load_document_from_memory(mesh_to_glb(mesh, materials), "quad");
    if (!document) throw std::runtime_error(document.error().message);
    return std::move(*document);
}

}  // namespace patina::io

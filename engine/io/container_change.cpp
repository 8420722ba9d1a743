// SPDX-License-Identifier: MIT
#include "io/container_change.h"

#include "core/hash.h"
#include "io/gltf_json.h"
#include "io/safe_name.h"
#include "io/uri.h"

namespace patina::io {
namespace {

Result<Bytes> bytes_of_uri(const SourceAsset& source, const std::string& uri) {
    if (is_data_uri(uri)) {
        auto data = decode_data_uri(uri);
        if (!data) return passed_on(data);
        return std::move(data->bytes);
    }
    const auto file = source.external_files.find(uri);
    if (file == source.external_files.end() || !file->second)
        return failure("the file \"{}\" that it names was not read", quoted_for_message(uri, 100));
    return *file->second;
}

std::string mime_type_of(const Bytes& image) {
    const bool jpeg =
        image.size() > 2 && image[0] == std::byte{0xff} && image[1] == std::byte{0xd8};
    return jpeg ? "image/jpeg" : "image/png";
}

void pad(Bytes& bytes) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
}

/// Puts the external PNG and JPEG images behind the first buffer.
void embed_images(GltfJson& gltf, SourceAsset& glb) {
    for (Json& image : gltf.array("images")) {
        const std::string uri = text_at(image, "uri");
        const auto file = glb.external_files.find(uri);
        if (file == glb.external_files.end() || !file->second) continue;
        const Bytes& bytes = *file->second;
        pad(glb.binary_chunk);
        Json& views = gltf.array("bufferViews");
        if (!image.contains("name")) image["name"] = uri;
        image.erase("uri");
        if (!image.contains("mimeType")) image["mimeType"] = mime_type_of(bytes);
        image["bufferView"] = views.size();
        views.push_back(
            {{"buffer", 0}, {"byteOffset", glb.binary_chunk.size()}, {"byteLength", bytes.size()}});
        glb.binary_chunk.insert(glb.binary_chunk.end(), bytes.begin(), bytes.end());
    }
}

/// Drops the external files that the JSON does not name any more.
void forget_unnamed_files(GltfJson& gltf, SourceAsset& asset) {
    std::map<std::string, std::shared_ptr<const Bytes>> named;
    for (const char* array : {"buffers", "images"})
        for (const Json& item : gltf.array(array)) {
            const auto file = asset.external_files.find(text_at(item, "uri"));
            if (file != asset.external_files.end()) named.insert(*file);
        }
    asset.external_files = std::move(named);
}

Result<SourceAsset> as_glb(const SourceAsset& source) {
    auto gltf = GltfJson::open(source.json_text);
    if (!gltf) return passed_on(gltf);
    SourceAsset glb = source;
    glb.container = Container::Glb;
    glb.file.clear();
    Json& buffers = gltf->array("buffers");
    if (!buffers.empty()) {
        auto bytes = bytes_of_uri(source, text_at(buffers.front(), "uri"));
        if (!bytes) return passed_on(bytes);
        // Some files are longer than their buffer says; what is behind is not part of it.
        const int length = index_at(buffers.front(), "byteLength");
        if (length >= 0 && bytes->size() > static_cast<std::size_t>(length))
            bytes->resize(static_cast<std::size_t>(length));
        glb.binary_chunk = std::move(*bytes);
        buffers.front().erase("uri");
    } else {
        buffers.push_back({{"byteLength", 0}});
    }
    embed_images(*gltf, glb);
    if (glb.binary_chunk.empty())
        buffers.clear();
    else
        buffers.front()["byteLength"] = glb.binary_chunk.size();
    pad(glb.binary_chunk);
    forget_unnamed_files(*gltf, glb);
    auto text = gltf->text();
    if (!text) return passed_on(text);
    glb.json_text = std::move(*text);
    return glb;
}

Result<SourceAsset> as_gltf(const SourceAsset& source, std::string_view stem,
                            std::vector<std::string>& warnings) {
    auto gltf = GltfJson::open(source.json_text);
    if (!gltf) return passed_on(gltf);
    SourceAsset separate = source;
    separate.container = Container::Gltf;
    separate.file.clear();
    if (!source.trailing_chunks.empty())
        warnings.push_back(
            "chunks of unknown type after the binary one have no place in a .gltf "
            "and were left out; save as .glb to keep them");
    separate.trailing_chunks.clear();
    Json& buffers = gltf->array("buffers");
    if (!source.binary_chunk.empty() && !buffers.empty() && !buffers.front().contains("uri")) {
        const std::string name = fmt::format("{}-{}.bin", safe_file_name(stem, 60),
                                             to_hex(hash_bytes(source.binary_chunk)));
        buffers.front()["uri"] = name;
        separate.external_files[name] = std::make_shared<const Bytes>(source.binary_chunk);
    }
    separate.binary_chunk.clear();
    auto text = gltf->text();
    if (!text) return passed_on(text);
    separate.json_text = std::move(*text);
    return separate;
}

}  // namespace

Result<SourceAsset> with_container(const SourceAsset& source, Container container,
                                   std::string_view stem, std::vector<std::string>& warnings) {
    if (source.container == container) return source;
    return container == Container::Glb ? as_glb(source) : as_gltf(source, stem, warnings);
}

}  // namespace patina::io

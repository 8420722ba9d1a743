// SPDX-License-Identifier: MIT
#include "io/gltf_images.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "io/base64.h"
#include "io/safe_name.h"

namespace patina::io {
namespace {

/// The name of the samplers that Patina adds, by which it knows them again.
constexpr std::string_view kOwnSampler = "patina";
constexpr std::array<std::byte, 4> kZeros = {};

int wrap_code(Wrap wrap) {
    switch (wrap) {
        case Wrap::Repeat:
            return 10497;
        case Wrap::Mirror:
            return 33648;
        case Wrap::Clamp:
            return 33071;
    }
    return 10497;
}
constexpr int kNearest = 9728;

int wrap_code_at(const Json& sampler, std::string_view key) {
    const int code = index_at(sampler, key);
    return code < 0 ? wrap_code(Wrap::Repeat) : code;
}

bool names_a_texture(std::string_view key) {
    return key.ends_with("Texture");
}

/// Calls `visit(index)` with every texture index in a material, extensions included.
template <typename Visit>
void for_each_texture_index(Json& material, const Visit& visit) {
    for_each_member(material, [&](const std::string& key, Json& value) {
        if (names_a_texture(key) && index_at(value, "index") >= 0) visit(value["index"]);
    });
}

std::string_view file_extension_of(std::string_view mime_type) {
    if (mime_type == "image/jpeg") return "jpg";
    if (mime_type == "image/png") return "png";
    const std::size_t slash = mime_type.rfind('/');
    return slash == std::string_view::npos ? "bin" : mime_type.substr(slash + 1);
}

std::uint64_t aligned(std::uint64_t offset) {
    return (offset + 3) / 4 * 4;
}

void renumber(Json& index, const std::vector<int>& moved) {
    const int old = index.is_number_integer() ? index.get<int>() : -1;
    if (old < 0 || old >= static_cast<int>(moved.size())) return;
    if (const int now = moved[static_cast<std::size_t>(old)]; now != old) index = now;
}

}  // namespace

GltfImages::GltfImages(GltfJson& gltf, const SourceAsset& source, const std::set<Hash128>& owned)
    : gltf_(gltf),
      source_(source),
      images_(gltf.array("images"), own_images(owned)),
      textures_(gltf.array("textures"), own_textures()),
      samplers_(gltf.array("samplers"), own_samplers()),
      views_(gltf.array("bufferViews"), own_views()) {}

std::optional<std::span<const std::byte>> GltfImages::bytes_of_view(int view) const {
    const Json& views = gltf_.array("bufferViews");
    if (view < 0 || view >= static_cast<int>(views.size())) return std::nullopt;
    const Json& json = views[static_cast<std::size_t>(view)];
    if (source_.container != Container::Glb || index_at(json, "buffer") != 0) return std::nullopt;
    const auto offset = static_cast<std::size_t>(std::max(index_at(json, "byteOffset"), 0));
    const auto length = static_cast<std::size_t>(std::max(index_at(json, "byteLength"), 0));
    const std::size_t size = source_.binary_chunk.size();
    if (offset > size || length > size - offset) return std::nullopt;
    return std::span(source_.binary_chunk).subspan(offset, length);
}

std::optional<std::span<const std::byte>> GltfImages::bytes_of_image(const Json& image) const {
    if (const int view = index_at(image, "bufferView"); view >= 0) return bytes_of_view(view);
    const auto file = source_.external_files.find(text_at(image, "uri"));
    if (file == source_.external_files.end() || !file->second) return std::nullopt;
    return std::span(*file->second);
}

std::vector<bool> GltfImages::own_images(const std::set<Hash128>& owned) {
    const Json& images = gltf_.array("images");
    std::vector<bool> own(images.size(), false);
    for (std::size_t i = 0; i < images.size() && !owned.empty(); ++i) {
        const auto bytes = bytes_of_image(images[i]);
        if (!bytes) continue;
        const Hash128 hash = hash_bytes(*bytes);
        own[i] = owned.contains(hash);
        if (own[i]) hashes_[static_cast<int>(i)] = hash;
    }
    return own;
}

std::vector<bool> GltfImages::own_textures() {
    std::vector<bool> own;
    for (const Json& texture : gltf_.array("textures"))
        own.push_back(images_.is_own(index_at(texture, "source")) &&
                      !texture.contains("extensions") && !texture.contains("extras"));
    return own;
}

std::vector<bool> GltfImages::own_samplers() {
    std::vector<bool> own;
    for (const Json& sampler : gltf_.array("samplers"))
        own.push_back(text_at(sampler, "name") == kOwnSampler);
    return own;
}

std::vector<bool> GltfImages::own_views() {
    const Json& views = gltf_.array("bufferViews");
    std::vector<bool> own(views.size(), false);
    const auto set = [&](int view, bool value) {
        if (view >= 0 && view < static_cast<int>(own.size()))
            own[static_cast<std::size_t>(view)] = value;
    };
    for (int i = 0; i < images_.size(); ++i)
        if (images_.is_own(i)) set(index_at(images_[i], "bufferView"), true);
    for (int i = 0; i < images_.size(); ++i)
        if (!images_.is_own(i)) set(index_at(images_[i], "bufferView"), false);
    for (const int used : gltf_.numbers_outside("images", "bufferView")) set(used, false);
    // Their bytes can be replaced only where nothing else lies behind or between them.
    std::uint64_t own_begin = source_.binary_chunk.size(), own_end = 0, others_end = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const auto begin =
            static_cast<std::uint64_t>(std::max(index_at(views[i], "byteOffset"), 0));
        const auto end =
            begin + static_cast<std::uint64_t>(std::max(index_at(views[i], "byteLength"), 0));
        if (own[i]) own_begin = std::min(own_begin, begin);
        if (own[i])
            own_end = std::max(own_end, end);
        else if (index_at(views[i], "buffer") == 0)
            others_end = std::max(others_end, end);
    }
    const bool replaceable =
        own_begin >= others_end && aligned(own_end) >= source_.binary_chunk.size();
    if (!replaceable) own.assign(own.size(), false);
    return own;
}

int GltfImages::add_image(const std::string& name, const std::string& mime_type,
                          std::shared_ptr<const Bytes> bytes) {
    const Hash128 hash = hash_bytes(*bytes);
    for (const auto& [index, known] : hashes_)
        if (known == hash && images_.is_own(index)) return index;
    for (const auto& [index, image] : new_images_)
        if (image.hash == hash) return index;
    const int index = images_.add({{"name", name}, {"mimeType", mime_type}});
    new_images_[index] = {.hash = hash, .bytes = std::move(bytes)};
    return index;
}

int GltfImages::texture(int image, int sampler) {
    for (int i = 0; i < textures_.size(); ++i)
        if (index_at(textures_[i], "source") == image &&
            index_at(textures_[i], "sampler") == sampler && !textures_[i].contains("extensions"))
            return i;
    Json texture = Json::object();
    if (sampler >= 0) texture["sampler"] = sampler;
    texture["source"] = image;
    return textures_.add(std::move(texture));
}

int GltfImages::sampler(Wrap wrap_u, Wrap wrap_v, Filter filter, int preferred) {
    const bool nearest = filter == Filter::Nearest;
    const auto fits = [&](int i) {
        return wrap_code_at(samplers_[i], "wrapS") == wrap_code(wrap_u) &&
               wrap_code_at(samplers_[i], "wrapT") == wrap_code(wrap_v) &&
               (index_at(samplers_[i], "magFilter") == kNearest) == nearest;
    };
    if (preferred >= 0 && preferred < samplers_.size() && fits(preferred)) return preferred;
    if (wrap_u == Wrap::Repeat && wrap_v == Wrap::Repeat && !nearest) return -1;
    for (int i = 0; i < samplers_.size(); ++i)
        if (fits(i)) return i;
    Json sampler = {{"name", kOwnSampler}};
    if (nearest) sampler["magFilter"] = kNearest;
    if (nearest) sampler["minFilter"] = kNearest;
    sampler["wrapS"] = wrap_code(wrap_u);
    sampler["wrapT"] = wrap_code(wrap_v);
    return samplers_.add(std::move(sampler));
}

int GltfImages::sampler_of(int texture) {
    return texture >= 0 && texture < textures_.size() ? index_at(textures_[texture], "sampler")
                                                      : -1;
}

int GltfImages::image_of(int texture) {
    return texture >= 0 && texture < textures_.size() ? index_at(textures_[texture], "source") : -1;
}

void GltfImages::keep_image(int image) {
    layer_images_.insert(image);
}

std::optional<Hash128> GltfImages::hash_of_image(int image) {
    if (const auto added = new_images_.find(image); added != new_images_.end())
        return added->second.hash;
    const auto known = hashes_.find(image);
    return known != hashes_.end() && images_.is_own(image) ? known->second : std::nullopt;
}

std::vector<Hash128> GltfImages::owned_by(const Json& material,
                                          const std::vector<int>& layer_images) {
    std::set<Hash128> owned;
    const auto add = [&](int image) {
        if (const auto hash = hash_of_image(image)) owned.insert(*hash);
    };
    Json copy = material;
    for_each_texture_index(copy, [&](const Json& index) { add(image_of(index.get<int>())); });
    for (const int image : layer_images) add(image);
    return {owned.begin(), owned.end()};
}

void GltfImages::keep_what_is_used() {
    for (Json& material : gltf_.array("materials"))
        for_each_texture_index(material,
                               [&](const Json& index) { textures_.keep(index.get<int>()); });
    for (int i = 0; i < textures_.size(); ++i) {
        if (!textures_.is_kept(i)) continue;
        samplers_.keep(index_at(textures_[i], "sampler"));
        images_.keep(index_at(textures_[i], "source"));
        for_each_member(textures_[i], [&](const std::string& key, const Json& value) {
            if (key == "source" && value.is_number_integer()) images_.keep(value.get<int>());
        });
    }
    for (const int image : layer_images_) images_.keep(image);
    for (int i = 0; i < images_.size(); ++i)
        if (images_.is_kept(i)) views_.keep(index_at(images_[i], "bufferView"));
}

bool GltfImages::binary_can_grow() const {
    const Json& buffers = gltf_.array("buffers");
    return buffers.empty() || !buffers.front().contains("uri");
}

void GltfImages::place_new_image(Json& item, const NewImage& image) {
    const std::string mime_type = text_at(item, "mimeType");
    if (source_.container == Container::Gltf) {
        const std::string name = fmt::format("{}-{}.{}", safe_file_name(text_at(item, "name"), 60),
                                             to_hex(image.hash), file_extension_of(mime_type));
        item.erase("mimeType");
        item["uri"] = name;
        files_[name] = image.bytes;
    } else if (binary_can_grow()) {
        const int view =
            views_.add({{"buffer", 0}, {"byteOffset", 0}, {"byteLength", image.bytes->size()}});
        views_.keep(view);
        new_view_bytes_[view] = image.bytes;
        item["bufferView"] = view;
    } else {
        // A GLB whose first buffer is an external file has no place for a binary chunk.
        item.erase("mimeType");
        item["uri"] = fmt::format("data:{};base64,{}", mime_type, base64(*image.bytes));
    }
}

void GltfImages::compact_all() {
    const auto textures = textures_.compact();
    for (Json& material : gltf_.array("materials"))
        for_each_texture_index(material, [&](Json& index) { renumber(index, textures); });
    const auto images = images_.compact();
    const auto samplers = samplers_.compact();
    for (int i = 0; i < textures_.size(); ++i) {
        if (textures_[i].contains("sampler")) renumber(textures_[i]["sampler"], samplers);
        for_each_member(textures_[i], [&](const std::string& key, Json& value) {
            if (key == "source") renumber(value, images);
        });
    }
}

std::uint64_t GltfImages::kept_binary_bytes() {
    std::uint64_t kept = source_.binary_chunk.size();
    for (int i = 0; i < views_.size(); ++i)
        if (views_.is_own(i))
            kept = std::min(
                kept, static_cast<std::uint64_t>(std::max(index_at(views_[i], "byteOffset"), 0)));
    return kept;
}

Json& GltfImages::binary_buffer() {
    Json& buffers = gltf_.array("buffers");
    if (buffers.empty()) buffers.push_back({{"byteLength", 0}});
    return buffers.front();
}

Status GltfImages::lay_out_binary() {
    BinaryTail tail{.kept_bytes = kept_binary_bytes(), .pieces = {}, .total_bytes = 0};
    tail.total_bytes = tail.kept_bytes;
    const bool had_own = tail.kept_bytes < source_.binary_chunk.size();
    for (int i = 0; i < views_.size(); ++i) {
        if (!views_.is_kept(i) || !(views_.is_own(i) || views_.is_new(i))) continue;
        const auto added = new_view_bytes_.find(i);
        const auto bytes =
            added != new_view_bytes_.end() ? std::span(*added->second) : bytes_of_view(i);
        if (!bytes) return failure("the bytes of bufferView {} are missing", i);
        const std::uint64_t begin = aligned(tail.total_bytes);
        tail.pieces.push_back(std::span(kZeros).first(begin - tail.total_bytes));
        tail.pieces.push_back(*bytes);
        views_[i]["byteOffset"] = begin;
        tail.total_bytes = begin + bytes->size();
    }
    const auto moved = views_.compact();
    for (int i = 0; i < images_.size(); ++i)
        if (images_[i].contains("bufferView")) renumber(images_[i]["bufferView"], moved);
    if (!had_own && tail.pieces.empty()) return {};
    if (tail.total_bytes == 0 && gltf_.count("buffers") == 1) {
        gltf_.array("buffers").clear();
    } else {
        if (tail.total_bytes == 0) {  // the first buffer stays for the sake of the others' numbers
            tail.pieces.push_back(kZeros);
            tail.total_bytes = kZeros.size();
        }
        binary_buffer()["byteLength"] = tail.total_bytes;
    }
    binary_ = std::move(tail);
    return {};
}

Status GltfImages::finish() {
    keep_what_is_used();
    for (auto& [index, image] : new_images_)
        if (images_.is_kept(index)) place_new_image(images_[index], image);
    compact_all();
    if (source_.container == Container::Glb) return lay_out_binary();
    return {};
}

}  // namespace patina::io

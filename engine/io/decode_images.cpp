// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include "core/parallel.h"
#include "io/document_read.h"
#include "io/image_decode.h"
#include "io/uri.h"

namespace patina::io {
namespace {

using tinygltf::Model;

bool has_record(const Model& model) {
    return std::any_of(model.materials.begin(), model.materials.end(),
                       [](const tinygltf::Material& material) {
                           return record_text(material.extras).has_value();
                       });
}

/// By index: whether the image must be decoded.
std::vector<bool> images_to_decode(const Model& model) {
    if (has_record(model)) return std::vector<bool>(model.images.size(), true);
    std::vector<bool> wanted(model.images.size(), false);
    for (const tinygltf::Material& material : model.materials) {
        const auto want = [&](const TextureUse& use) {
            if (const int image = image_index(model, use); image >= 0)
                wanted[static_cast<std::size_t>(image)] = true;
        };
        const MaterialValues values = material_values(material);
        for (const TextureUse* use : values.slots()) want(*use);
        want(values.specular);
        want(values.specular_color);
        const auto& glossiness =
            extension_of(material.extensions, "KHR_materials_pbrSpecularGlossiness");
        want(texture_use(glossiness, "diffuseTexture"));
        want(texture_use(glossiness, "specularGlossinessTexture"));
    }
    return wanted;
}

std::string image_name(const tinygltf::Image& image, std::size_t index) {
    if (!image.name.empty()) return image.name;
    if (!image.uri.empty() && !is_data_uri(image.uri)) return image.uri;
    return fmt::format("Image {}", index + 1);
}

/// Sizes from the headers, before any memory is taken for pixels.
Status check_sizes(const Model& model, const GltfFiles& files, const std::vector<bool>& wanted,
                   const ImageLimits& limits) {
    std::set<const Bytes*> seen;
    std::uint64_t total_bytes = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (!wanted[i] || !files.images[i] || !seen.insert(files.images[i].get()).second) continue;
        const auto header = read_image_header(*files.images[i], image_name(model.images[i], i));
        if (!header) continue;  // a placeholder will stand for it
        if (const auto fits = check_image_size(*header, limits); !fits)
            return failure("/images/{}: {}", i, fits.error().message);
        total_bytes += header->decoded_bytes();
        if (total_bytes > limits.max_decoded_bytes)
            return failure(
                "/images/{}: all images together would take more than the limit of {} MiB; scale "
                "them down",
                i, limits.max_decoded_bytes >> 20);
    }
    return {};
}

/// The hash that stands for pixels that are not there: of what was to hold them.
Hash128 placeholder_hash(const GltfFiles& files, std::size_t index, const std::string& name) {
    if (files.images[index]) return hash_bytes(*files.images[index]);
    return Hasher().add(std::string_view("missing image")).add(name).finish();
}

ImageAssetPtr with_source(const ImageAssetPtr& asset, std::size_t index, const std::string& name) {
    auto copy = std::make_shared<ImageAsset>(*asset);
    copy->name = name;
    copy->source_image = static_cast<int>(index);
    return copy;
}

/// Equal pixels are one image: the first of the file.
void merge_equal(FileImages& images) {
    std::map<Hash128, ImageAssetPtr> first;
    for (ImageAssetPtr& image : images)
        if (image) image = first.try_emplace(image->hash, image).first->second;
}

}  // namespace

Result<FileImages> decode_images(const Model& model, const GltfFiles& files, ImageStore& store,
                                 const ImageLimits& limits, const Progress& progress,
                                 std::vector<std::string>& warnings) {
    const std::vector<bool> wanted = images_to_decode(model);
    if (const auto fits = check_sizes(model, files, wanted, limits); !fits) return passed_on(fits);
    FileImages images(model.images.size());
    std::vector<std::string> faults(model.images.size());
    const auto decode = [&](std::int64_t first, std::int64_t last) {
        for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
            if (!wanted[i] || progress.cancelled()) continue;
            const std::string name = image_name(model.images[i], i);
            if (files.images[i]) {
                const auto asset = store.add(files.images[i], name);
                if (asset) {
                    images[i] = with_source(*asset, i, name);
                    continue;
                }
                faults[i] = asset.error().message;
            }
            const Hash128 hash = placeholder_hash(files, i, name);
            images[i] = with_source(store.add_placeholder(hash, name, files.images[i]), i, name);
        }
    };
    parallel_for(0, static_cast<std::int64_t>(images.size()), 1, decode);
    if (progress.cancelled()) return failure("cancelled");
    for (std::size_t i = 0; i < faults.size(); ++i)
        if (!faults[i].empty())
            warnings.push_back(fmt::format("/images/{}: {}; a placeholder is shown", i, faults[i]));
    merge_equal(images);
    return images;
}

}  // namespace patina::io

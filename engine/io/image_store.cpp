// SPDX-License-Identifier: MIT
#include "io/image_store.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>
#include <unordered_map>

#include "core/parallel.h"
#include "io/image_decode.h"
#include "io/png_writer.h"
#include "io/tiff_reader.h"

namespace patina::io {
namespace {

ImageAsset asset_of(const Hash128& hash, const Image& image, std::string_view name,
                    std::string_view mime_type, EncodedImage encoded) {
    ImageAsset asset;
    asset.hash = hash;
    asset.name = name;
    asset.mime_type = mime_type;
    asset.encoded = std::move(encoded);
    asset.width = image.width;
    asset.height = image.height;
    asset.channels = image.channels;
    asset.type = image.type;
    return asset;
}

/// What is shown in place of pixels that are not there: a checker close to a flat normal, half
/// rough, so that it is seen and does no harm in any channel.
ImagePtr placeholder_image() {
    static const ImagePtr placeholder = [] {
        constexpr int kSide = 16;
        auto image = std::make_shared<Image>();
        image->width = kSide;
        image->height = kSide;
        image->channels = 3;
        image->type = SampleType::U8;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                const bool light = (x / 4 + y / 4) % 2 == 0;
                image->data.insert(
                    image->data.end(),
                    {std::byte(light ? 136 : 120), std::byte(light ? 136 : 120), std::byte(255)});
            }
        }
        return image;
    }();
    return placeholder;
}

bool is_within_0_to_1(const Image& image) {
    const auto* const numbers = reinterpret_cast<const float*>(image.data.data());
    return std::all_of(numbers, numbers + image.data.size() / sizeof(float),
                       [](float number) { return number >= 0.0f && number <= 1.0f; });
}

/// The same picture in 16 bits a sample.
ImagePtr shared_as_u16(const Image& image) {
    Image rounded = image;
    rounded.type = SampleType::U16;
    rounded.data.resize(image.data.size() / 2);
    const auto* const from = reinterpret_cast<const float*>(image.data.data());
    auto* const to = reinterpret_cast<std::uint16_t*>(rounded.data.data());
    for (std::size_t i = 0; i < image.data.size() / sizeof(float); ++i)
        to[i] = static_cast<std::uint16_t>(std::lround(from[i] * 65535.0f));
    return std::make_shared<const Image>(std::move(rounded));
}

}  // namespace

struct ImageStore::State {
    ImageLimits limits;
    mutable std::mutex mutex;
    std::unordered_map<Hash128, ImagePtr, Hash128Hash> pixels;       ///< by content_hash
    std::unordered_map<Hash128, ImageAssetPtr, Hash128Hash> assets;  ///< by hash_bytes of the file
    std::uint64_t reserved_bytes = 0;  ///< of decoded images and of those being decoded

    /// Sets memory aside, or says that the images together are too large.
    Status reserve(std::uint64_t bytes) {
        const std::lock_guard lock(mutex);
        if (bytes > limits.max_decoded_bytes - reserved_bytes)
            return failure(
                "all images together would take more than the limit of {} MiB; scale them down",
                limits.max_decoded_bytes >> 20);
        reserved_bytes += bytes;
        return {};
    }
    void release(std::uint64_t bytes) {
        const std::lock_guard lock(mutex);
        reserved_bytes -= bytes;
    }
    /// Takes reserved pixels in; what is there already is not kept twice.
    void keep(const Hash128& hash, ImagePtr image) {
        const std::lock_guard lock(mutex);
        const std::uint64_t bytes = image->data.size();
        if (!pixels.try_emplace(hash, std::move(image)).second) reserved_bytes -= bytes;
    }
    ImageAssetPtr find_asset(const Hash128& encoded) const {
        const std::lock_guard lock(mutex);
        const auto found = assets.find(encoded);
        return found == assets.end() ? nullptr : found->second;
    }
    /// Takes in reserved pixels and what is known of them, under the hash of their file.
    ImageAssetPtr keep_asset(const Hash128& file, ImagePtr image, ImageAsset made) {
        keep(made.hash, std::move(image));
        const auto asset = std::make_shared<const ImageAsset>(std::move(made));
        const std::lock_guard lock(mutex);
        assets.emplace(file, asset);
        return asset;
    }
};

ImageStore::ImageStore(const ImageLimits& limits) : state_(std::make_unique<State>()) {
    state_->limits = limits;
}
ImageStore::~ImageStore() = default;

Result<ImageAssetPtr> ImageStore::add(std::shared_ptr<const Bytes> encoded, std::string_view name) {
    const Hash128 encoded_hash = hash_bytes(*encoded);
    if (const auto known = state_->find_asset(encoded_hash)) return known;
    const auto open = open_image(*encoded, name);
    if (!open) return passed_on(open);
    const ImageHeader header = (*open)->header();
    if (const auto fits = check_image_size(header, state_->limits); !fits) return passed_on(fits);
    if (const auto fits = state_->reserve(header.decoded_bytes()); !fits) return passed_on(fits);
    const auto image = (*open)->pixels();
    if (!image) {
        state_->release(header.decoded_bytes());
        return passed_on(image);
    }
    const Hash128 hash = content_hash(**image);
    ImageAsset asset =
        asset_of(hash, **image, name, mime_type_of_format(header.format), std::move(encoded));
    asset.color_space = header.color_space;
    return state_->keep_asset(encoded_hash, *image, std::move(asset));
}

Result<ImageAssetPtr> ImageStore::add_file(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    const auto named = [&](Result<ImageAssetPtr> asset) -> Result<ImageAssetPtr> {
        if (asset) return asset;
        return failure("{}: {}", quoted_for_message(path.string()), asset.error().message);
    };
    if (const auto plain = open_plain_tiff(path)) return named(add_plain(*plain, name));
    const auto bytes = read_large_file(path);
    if (!bytes) return passed_on(bytes);
    const std::string_view format = image_format(*bytes, name);
    const bool is_kept = format == "png" || format == "jpeg";
    return named(is_kept ? add(std::make_shared<const Bytes>(bytes->begin(), bytes->end()), name)
                         : add_converted(*bytes, name));
}

/// The pixels of an uncompressed file tell it from others as well as all of it would.
Result<ImageAssetPtr> ImageStore::add_plain(OpenedImage& plain, std::string_view name) {
    if (const auto fits = check_image_size(plain.header(), state_->limits); !fits)
        return passed_on(fits);
    const auto image = plain.pixels();
    if (!image) return passed_on(image);
    const Hash128 pixels = content_hash(**image);
    if (const auto known = state_->find_asset(pixels)) return known;
    return add_as_png(pixels, *image, pixels, name, plain.header().color_space);
}

Result<ImageAssetPtr> ImageStore::add_converted(std::span<const std::byte> file,
                                                std::string_view name) {
    const Hash128 file_hash = hash_bytes(file);
    if (const auto known = state_->find_asset(file_hash)) return known;
    const auto open = open_image(file, name);
    if (!open) return passed_on(open);
    if (const auto fits = check_image_size((*open)->header(), state_->limits); !fits)
        return passed_on(fits);
    const auto image = (*open)->pixels();
    if (!image) return passed_on(image);
    const bool is_float = (*image)->type == SampleType::F32;
    const ImageHeader& header = (*open)->header();
    if (is_float && !is_within_0_to_1(**image)) {
        ImageAsset asset =
            asset_of(content_hash(**image), **image, name, mime_type_of_format(header.format),
                     std::make_shared<const Bytes>(file.begin(), file.end()));
        asset.color_space = header.color_space;
        return add_decoded(file_hash, *image, std::move(asset));
    }
    const ImagePtr stored = is_float ? shared_as_u16(**image) : *image;
    return add_as_png(file_hash, stored, content_hash(*stored), name, header.color_space);
}

std::vector<Result<ImageAssetPtr>> ImageStore::add_files(
    std::span<const std::filesystem::path> paths, const Progress& progress) {
    std::vector<Result<ImageAssetPtr>> added(paths.size());
    parallel_for(
        0, static_cast<std::int64_t>(paths.size()), 1, [&](std::int64_t first, std::int64_t last) {
            for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
                if (!progress.cancelled()) added[i] = add_file(paths[i]);
        });
    return added;
}

/// Takes decoded pixels in, which are to be carried as PNG once they are saved.
Result<ImageAssetPtr> ImageStore::add_as_png(const Hash128& file, const ImagePtr& image,
                                             const Hash128& pixels, std::string_view name,
                                             ColorSpace color_space) {
    if (const auto fits = state_->reserve(image->data.size()); !fits) return passed_on(fits);
    const auto encode = [image]() -> std::shared_ptr<const Bytes> {
        auto png = encode_png(*image);
        return png ? std::make_shared<const Bytes>(std::move(*png)) : nullptr;
    };
    ImageAsset asset =
        asset_of(pixels, *image, name, "image/png", EncodedImage::when_asked(encode));
    asset.color_space = color_space;  // which the PNG will say nothing of
    return add_decoded(file, image, std::move(asset));
}

/// Takes decoded pixels in, for which no memory was set aside before.
Result<ImageAssetPtr> ImageStore::add_decoded(const Hash128& file, const ImagePtr& image,
                                              ImageAsset asset) {
    if (const auto fits = state_->reserve(image->data.size()); !fits) return passed_on(fits);
    return state_->keep_asset(file, image, std::move(asset));
}

ImageAssetPtr ImageStore::add_placeholder(const Hash128& hash, std::string_view name,
                                          std::shared_ptr<const Bytes> encoded) {
    const ImagePtr image = placeholder_image();
    auto asset =
        std::make_shared<const ImageAsset>(asset_of(hash, *image, name, {}, std::move(encoded)));
    const std::lock_guard lock(state_->mutex);
    state_->pixels.try_emplace(hash, image);
    return asset;
}

void ImageStore::keep_only(std::span<const Hash128> images) {
    const std::lock_guard lock(state_->mutex);
    const std::set<Hash128> kept(images.begin(), images.end());
    const auto is_kept = [&](const Hash128& hash) { return kept.contains(hash); };
    std::erase_if(state_->assets, [&](const auto& entry) { return !is_kept(entry.second->hash); });
    std::erase_if(state_->pixels, [&](const auto& entry) {
        if (is_kept(entry.first)) return false;
        if (entry.second != placeholder_image())
            state_->reserved_bytes -= entry.second->data.size();
        return true;
    });
}

Result<ImagePtr> ImageStore::pixels(const Hash128& image) {
    const std::lock_guard lock(state_->mutex);
    const auto found = state_->pixels.find(image);
    if (found == state_->pixels.end())
        return failure("no image with the hash {} is known", to_hex(image));
    return found->second;
}

}  // namespace patina::io

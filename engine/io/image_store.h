// SPDX-License-Identifier: MIT
#pragma once

/// Encoded images in, pixels out, each image decoded once and kept by the hash of its content.
/// add() decodes on the calling thread; PNG and plain TIFF by Patina's readers, the rest by
/// OpenImageIO.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "composite/image_provider.h"
#include "core/progress.h"
#include "document/document.h"

namespace patina::io {

struct ImageLimits {
    int max_side = 16384;  ///< of one image
    /// Of one image, and of all that a store holds together.
    std::uint64_t max_decoded_bytes = std::uint64_t{2} << 30;
};

class OpenedImage;

/// Thread-safe.
class ImageStore final : public ImageProvider {
  public:
    explicit ImageStore(const ImageLimits& limits = {});
    ~ImageStore() override;

    /// Decodes `encoded` now (or finds that it was decoded before) and returns what the document
    /// keeps of it. Counts against the limit of all images together.
    Result<ImageAssetPtr> add(std::shared_ptr<const Bytes> encoded, std::string_view name);
    /// Reads a file and adds it: PNG and JPEG keep their bytes, other formats are carried as 16-bit
    /// PNG when they are within 0..1. That PNG is made when it is first asked for.
    Result<ImageAssetPtr> add_file(const std::filesystem::path& path);

    /// The same for several files side by side. Those that a cancel left out are null.
    std::vector<Result<ImageAssetPtr>> add_files(std::span<const std::filesystem::path> paths,
                                                 const Progress& progress = {});

    /// Stands in for pixels that are missing or cannot be decoded: a checker is served under
    /// `hash`. `encoded` may be null.
    ImageAssetPtr add_placeholder(const Hash128& hash, std::string_view name,
                                  std::shared_ptr<const Bytes> encoded);

    /// Forgets all pixels but these.
    void keep_only(std::span<const Hash128> images);

    Result<ImagePtr> pixels(const Hash128& image) override;

  private:
    Result<ImageAssetPtr> add_converted(std::span<const std::byte> file, std::string_view name);
    Result<ImageAssetPtr> add_plain(OpenedImage& plain, std::string_view name);
    Result<ImageAssetPtr> add_as_png(const Hash128& file, const ImagePtr& image,
                                     const Hash128& pixels, std::string_view name,
                                     ColorSpace color_space);
    Result<ImageAssetPtr> add_decoded(const Hash128& file, const ImagePtr& image, ImageAsset asset);

    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace patina::io

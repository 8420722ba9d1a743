// SPDX-License-Identifier: MIT
#include "io/gltf_files.h"

#include <map>

#include "io/uri.h"

namespace patina::io {
namespace {

using SharedBytes = std::shared_ptr<const Bytes>;

class Gatherer {
  public:
    Gatherer(SourceAsset& asset, const tinygltf::Model& model,
             const std::vector<std::uint64_t>& buffer_bytes, std::uint64_t limit_bytes,
             std::vector<std::string>& warnings)
        : asset_(asset),
          model_(model),
          buffer_bytes_(buffer_bytes),
          left_bytes_(limit_bytes),
          limit_bytes_(limit_bytes),
          warnings_(warnings) {}

    Result<GltfFiles> gather() {
        for (std::size_t i = 0; i < model_.buffers.size(); ++i)
            if (const auto status = add_buffer(i); !status)
                return failure("/buffers/{}: {}", i, status.error().message);
        for (std::size_t i = 0; i < model_.images.size(); ++i)
            if (const auto status = add_image(i); !status)
                return failure("/images/{}: {}", i, status.error().message);
        return std::move(files_);
    }

  private:
    Status take(std::uint64_t bytes) {
        if (bytes > left_bytes_)
            return failure("all files together are larger than the limit of {} MiB",
                           limit_bytes_ >> 20);
        left_bytes_ -= bytes;
        return {};
    }

    /// The bytes of a data: URI or of a file; null when there is no such file.
    Result<SharedBytes> fetch(const std::string& uri) {
        if (is_data_uri(uri)) {
            auto data = decode_data_uri(uri);
            if (!data) return passed_on(data);
            if (const auto fits = take(data->bytes.size()); !fits) return passed_on(fits);
            return std::make_shared<const Bytes>(std::move(data->bytes));
        }
        if (const auto known = asset_.external_files.find(uri);
            known != asset_.external_files.end())
            return known->second;
        const auto relative = relative_path_of_uri(uri);
        if (!relative) return passed_on(relative);
        if (asset_.path.empty())
            return failure("\"{}\" lies outside, but a model in memory has no folder",
                           quoted_for_message(uri, 100));
        const auto path = file_under(asset_.path.parent_path(), *relative);
        if (!path) return passed_on(path);
        if (!*path) return SharedBytes();
        auto bytes = read_file(**path, left_bytes_);
        if (!bytes) return passed_on(bytes);
        if (const auto fits = take(bytes->size()); !fits) return passed_on(fits);
        auto shared = std::make_shared<const Bytes>(std::move(*bytes));
        asset_.external_files.emplace(uri, shared);
        return shared;
    }

    Status add_buffer(std::size_t index) {
        const std::string& uri = model_.buffers[index].uri;
        if (uri.empty()) {
            // Only the first buffer may be the binary chunk; others can be fallbacks of extensions.
            const bool is_chunk = index == 0 && !asset_.binary_chunk.empty();
            files_.buffers.emplace_back();
            if (!is_chunk) return {};
            return set_buffer(index, asset_.binary_chunk);
        }
        const auto bytes = fetch(uri);
        if (!bytes) return passed_on(bytes);
        if (!*bytes)
            return failure("the file \"{}\" is missing; put it beside the model",
                           quoted_for_message(uri, 100));
        files_.owned.push_back(*bytes);
        files_.buffers.emplace_back();
        return set_buffer(index, **bytes);
    }

    Status set_buffer(std::size_t index, std::span<const std::byte> bytes) {
        const std::uint64_t length = buffer_bytes_[index];
        if (bytes.size() < length)
            return failure("has {} bytes, byteLength says {}", bytes.size(), length);
        files_.buffers[index] = bytes.first(length);
        return {};
    }

    Status add_image(std::size_t index) {
        const tinygltf::Image& image = model_.images[index];
        files_.images.emplace_back();
        if (image.uri.empty()) return add_embedded_image(image.bufferView);
        auto bytes = fetch(image.uri);
        if (!bytes) return passed_on(bytes);
        if (!*bytes)
            warnings_.push_back(fmt::format("/images/{}: the file \"{}\" is missing", index,
                                            quoted_for_message(image.uri, 100)));
        files_.images.back() = std::move(*bytes);
        return {};
    }

    Status add_embedded_image(int view_index) {
        if (view_index < 0) return {};
        SharedBytes& shared = image_of_view_[view_index];
        if (!shared) {
            const tinygltf::BufferView& view =
                model_.bufferViews[static_cast<std::size_t>(view_index)];
            const auto buffer = files_.buffers[static_cast<std::size_t>(view.buffer)];
            if (buffer.empty()) return {};
            if (const auto fits = take(view.byteLength); !fits) return fits;
            const auto bytes = buffer.subspan(view.byteOffset, view.byteLength);
            shared = std::make_shared<const Bytes>(bytes.begin(), bytes.end());
        }
        files_.images.back() = shared;
        return {};
    }

    SourceAsset& asset_;
    const tinygltf::Model& model_;
    const std::vector<std::uint64_t>& buffer_bytes_;
    std::uint64_t left_bytes_;
    std::uint64_t limit_bytes_;
    std::vector<std::string>& warnings_;
    std::map<int, SharedBytes> image_of_view_;
    GltfFiles files_;
};

}  // namespace

Result<GltfFiles> gather_files(SourceAsset& asset, const tinygltf::Model& model,
                               const std::vector<std::uint64_t>& buffer_bytes,
                               std::uint64_t limit_bytes, std::vector<std::string>& warnings) {
    return Gatherer(asset, model, buffer_bytes, limit_bytes, warnings).gather();
}

}  // namespace patina::io

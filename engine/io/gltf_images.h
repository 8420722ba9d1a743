// SPDX-License-Identifier: MIT
#pragma once

/// The textures and images of a glTF file while a save adds to them: what is in the file, what of
/// it is Patina's own, what is new, and where the bytes go.

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "document/document.h"
#include "io/item_table.h"

namespace patina::io {

/// The part after which everything of a GLB's binary chunk is new, and what follows it.
struct BinaryTail {
    std::uint64_t kept_bytes = 0;  ///< of the old chunk, from its start
    std::vector<std::span<const std::byte>> pieces;
    std::uint64_t total_bytes = 0;  ///< kept_bytes and the pieces
};

class GltfImages {
  public:
    /// @param owned  hashes of the encoded images that records in the file list as Patina's own
    /// All three must outlive the object.
    GltfImages(GltfJson& gltf, const SourceAsset& source, const std::set<Hash128>& owned);

    /// How many images there are now.
    int image_count() const { return images_.size(); }
    /// The index of an image with these bytes: one of Patina's own that is there, or a new one.
    int add_image(const std::string& name, const std::string& mime_type,
                  std::shared_ptr<const Bytes> bytes);
    /// A texture of the image with the sampler (-1 for none); one that is there, or a new one.
    int texture(int image, int sampler);
    /// A sampler that wraps and filters so: `preferred`, if it does; another that is there; or a
    /// new one. -1 is glTF's default.
    int sampler(Wrap wrap_u, Wrap wrap_v, Filter filter, int preferred);
    /// The sampler of a texture, -1 for none or for no texture.
    int sampler_of(int texture);
    /// The image of a texture, -1 for none.
    int image_of(int texture);
    /// Keeps an image though no texture may show it: a layer reads it.
    void keep_image(int image);

    /// Hashes of those images of Patina's own, old and new, that a material shows or that are in
    /// `layer_images`, ascending.
    std::vector<Hash128> owned_by(const Json& material, const std::vector<int>& layer_images);

    /// Drops Patina's own items that nothing shows any more, renumbers what moved, and lays out the
    /// binary chunk (GLB) or the files (glTF). Call it once, when all materials are as they will
    /// be.
    Status finish();

    /// After finish(), of a GLB: the new binary chunk, if it differs from the old one.
    const std::optional<BinaryTail>& binary() const { return binary_; }
    /// After finish(), of a glTF: new files by name.
    const std::map<std::string, std::shared_ptr<const Bytes>>& files() const { return files_; }

  private:
    struct NewImage {
        Hash128 hash;
        std::shared_ptr<const Bytes> bytes;
    };

    std::vector<bool> own_images(const std::set<Hash128>& owned);
    std::vector<bool> own_textures();
    std::vector<bool> own_samplers();
    std::vector<bool> own_views();
    std::optional<Hash128> hash_of_image(int image);
    std::optional<std::span<const std::byte>> bytes_of_image(const Json& image) const;
    std::optional<std::span<const std::byte>> bytes_of_view(int view) const;
    void place_new_image(Json& item, const NewImage& image);
    void keep_what_is_used();
    void compact_all();
    Status lay_out_binary();
    std::uint64_t kept_binary_bytes();
    Json& binary_buffer();
    bool binary_can_grow() const;

    GltfJson& gltf_;
    const SourceAsset& source_;
    std::map<int, std::optional<Hash128>> hashes_;  ///< of images in the file
    ItemTable images_;
    ItemTable textures_;
    ItemTable samplers_;
    ItemTable views_;
    std::map<int, NewImage> new_images_;                          ///< by index before finish()
    std::map<int, std::shared_ptr<const Bytes>> new_view_bytes_;  ///< by index before finish()
    std::set<int> layer_images_;
    std::optional<BinaryTail> binary_;
    std::map<std::string, std::shared_ptr<const Bytes>> files_;
};

}  // namespace patina::io

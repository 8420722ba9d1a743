// SPDX-License-Identifier: MIT
#pragma once

/// Thumbnails by content: asked for while drawing, composited on a worker of low urgency, drawn and
/// uploaded on idle frames, kept until too many are unused.

#include <condition_variable>
#include <deque>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <unordered_map>

#include "composite/image_provider.h"
#include "editor/session/environments.h"
#include "editor/session/material_ball.h"
#include "editor/state/shown.h"
#include "io/preset_library.h"
#include "render/interface_image.h"

namespace patina::editor {

class ThumbnailCache final : public Thumbnails {
  public:
    explicit ThumbnailCache(std::function<void()> wake);
    ~ThumbnailCache() override;
    ThumbnailCache(const ThumbnailCache&) = delete;
    ThumbnailCache& operator=(const ThumbnailCache&) = delete;

    /// Where the images of the document's layers come from. Null without a document.
    void set_images(std::shared_ptr<ImageProvider> images);
    /// What layers of the materials read of the model.
    void set_surfaces(std::map<MaterialId, UvSurfacePtr> surfaces) {
        surfaces_ = std::move(surfaces);
    }
    void set_presets(const std::vector<io::PresetFile>* presets) { presets_ = presets; }
    /// What an environment's name stands for.
    void set_environments(std::function<Result<EnvironmentSource>(const std::string&)> find) {
        environments_ = std::move(find);
    }

    struct ChannelSource {
        Source source;
        Channel channel = Channel::BaseColor;
        bool operator==(const ChannelSource&) const = default;
    };
    /// A mask, and the stack of its layer where it reads that.
    struct LayerMask {
        Mask mask;
        std::vector<LayerPtr> stack = {};
        LayerId layer = {};
        bool operator==(const LayerMask&) const = default;
    };
    /// What a thumbnail is of; a Material is shown as a ball.
    using Subject = std::variant<Layer, LayerMask, ChannelSource, Material>;

    /// Uploads what is ready, and draws at most one ball unless `hurried`. True when more is left.
    bool finish_some(bool hurried);
    bool settled() const;
    std::size_t texture_bytes() const { return texture_bytes_; }

    Picture layer(const Material& material, const Layer& layer) override;
    Picture mask(const Material& material, const Layer& layer) override;
    Picture mask_entry(const Material& material, const Layer& layer,
                       const MaskEntry& entry) override;
    Picture channel_source(const Material& material, const Layer& layer, Channel channel) override;
    Picture material(const Material& material) override;
    Picture preset(const Preset& preset, const std::vector<KnobSetting>& knobs) override;
    Picture image(const ImageAsset& image) override;
    Picture environment(const std::string& name) override;

  private:
    /// What the worker makes of a request: a picture, or a surface to draw a ball with.
    using Made = std::variant<std::monostate, Image, render::SurfaceMaterial>;
    struct Request {
        Hash128 key;
        std::function<Made()> work;
    };
    struct Entry {
        std::optional<render::InterfaceImage> image;
        std::uint64_t used = 0;
    };
    Picture find(const Hash128& key, std::function<Made()> work);
    enum class PlaceKind { Layer, Mask, MaskEntry, Source, Material };
    struct Place {
        PlaceKind kind = PlaceKind::Layer;
        std::uint64_t id = 0;
        Channel channel = Channel::BaseColor;
        auto operator<=>(const Place&) const = default;
    };
    struct Known {
        Subject subject;
        UvSurfacePtr surface;
        Hash128 key;
    };
    Picture of_subject(const Place& place, Subject subject, const Material& of);
    void run();
    Result<Image> ball_picture(const render::SurfaceMaterial& surface);
    void forget_unused();

    std::function<void()> wake_;
    std::shared_ptr<ImageProvider> images_;
    const std::vector<io::PresetFile>* presets_ = nullptr;
    std::function<Result<EnvironmentSource>(const std::string&)> environments_;
    std::map<MaterialId, UvSurfacePtr> surfaces_;
    std::map<Place, Known> keys_;
    std::unordered_map<Hash128, Entry, Hash128Hash> entries_;
    std::optional<Result<MaterialBall>> ball_;
    std::uint64_t clock_ = 0;
    std::size_t texture_bytes_ = 0;

    mutable std::mutex mutex_;
    std::condition_variable work_;
    std::deque<Request> requests_;
    std::deque<std::pair<Hash128, Made>> made_;
    bool busy_ = false;
    bool stopping_ = false;
    std::thread thread_;
};

}  // namespace patina::editor

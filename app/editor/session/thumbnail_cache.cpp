// SPDX-License-Identifier: MIT
#include "editor/session/thumbnail_cache.h"

#include <algorithm>
#include <cmath>

#include "composite/composite.h"
#include "core/formulae/formulae.h"
#include "core/log.h"
#include "editor/session/material_ball.h"
#include "editor/session/thumbnail_materials.h"
#include "io/image_store.h"
#include "render/environment.h"

namespace patina::editor {
namespace {

constexpr int kMapSide = 96;  // of squares: sharp up to 250 %
constexpr int kBallMapSide = 256;
constexpr int kThumbnailSide = 192;
constexpr std::size_t kMostEntries = 600;
constexpr std::size_t kMostKeys = 4 * kMostEntries;

Result<Image> base_color_picture(const Material& material, const UvSurfacePtr& surface,
                                 ImageProvider& images) {
    const Program program = Program::compile(material, surface);
    Result<MapSet> maps = bake_maps(program, images, kMapSide, {BakedMap::BaseColor});
    if (!maps) return passed_on(maps);
    return Image(*(*maps)[BakedMap::BaseColor]);
}

/// Small maps for everything that is not constant, untouched images included.
Result<render::SurfaceMaterial> small_surface(const Material& material, ImageProvider& images) {
    const Program program = Program::compile(material, ball_surface());
    std::array<SlotPlan, kSlotCount> slots = program.slots();
    for (std::size_t i = 0; i < slots.size(); ++i)
        if (std::holds_alternative<SlotImage>(slots[i]))
            slots[i] = SlotBaked{baked_map_of(static_cast<Slot>(i))};
    MapSet maps;
    const std::vector<BakedMap> needed = render::baked_maps_of(slots);
    if (!needed.empty()) {
        Result<MapSet> baked = bake_maps(program, images, kBallMapSide, needed);
        if (!baked) return passed_on(baked);
        maps = std::move(*baked);
    }
    render::SurfaceMaterial surface = render::surface_of(material, slots, maps, images);
    surface.alpha_mode = AlphaMode::Opaque;
    return surface;
}

/// An equirectangular map of floats as a small picture.
Image small_panorama(const Image& map) {
    constexpr int kWidth = 160;
    constexpr int kHeight = 80;
    Image result{.width = kWidth, .height = kHeight, .channels = 3, .type = SampleType::U8};
    result.data.resize(std::size_t{kWidth} * kHeight * 3);
    const auto* values = reinterpret_cast<const float*>(map.data.data());
    const auto channels = static_cast<std::size_t>(map.channels);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const auto column = static_cast<std::size_t>(x * map.width / kWidth);
            const auto row = static_cast<std::size_t>(y * map.height / kHeight);
            const float* texel =
                values + (row * static_cast<std::size_t>(map.width) + column) * channels;
            const std::size_t at =
                (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)) * 3;
            for (std::size_t c = 0; c < 3; ++c) {
                const float linear = texel[channels >= 3 ? c : 0];
                const formulae::Real3 toned =
                    formulae::tone_map_reinhard(formulae::Real3(linear, linear, linear));
                const float encoded = formulae::srgb_from_linear(toned.x);
                result.data[at + c] =
                    static_cast<std::byte>(std::lround(std::clamp(encoded, 0.0f, 1.0f) * 255.0f));
            }
        }
    return result;
}

Result<Image> environment_picture(const EnvironmentSource& source) {
    if (!source.builtin.empty()) {
        const Result<Image> builtin = render::builtin_environment(source.builtin, 128);
        if (!builtin) return passed_on(builtin);
        return small_panorama(*builtin);
    }
    const Result<ImagePtr> map = read_environment(source);
    if (!map) return passed_on(map);
    if ((*map)->type != SampleType::F32)
        return failure("{}: not a float panorama", quoted_for_message(source.file.string()));
    return small_panorama(**map);
}

/// U8 at most kThumbnailSide texels a side, by nearest texels (mips smooth it further).
Result<Image> small_image(const Image& image) {
    if (image.type != SampleType::U8 && image.type != SampleType::U16)
        return failure("no small picture of floats");
    const int longest = std::max(image.width, image.height);
    const int step = std::max(1, (longest + kThumbnailSide - 1) / kThumbnailSide);
    Image result{.width = std::max(1, image.width / step),
                 .height = std::max(1, image.height / step),
                 .channels = image.channels,
                 .type = SampleType::U8};
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t sample = sample_bytes(image.type);
    result.data.resize(static_cast<std::size_t>(result.width) *
                       static_cast<std::size_t>(result.height) * channels);
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x)
            for (std::size_t c = 0; c < channels; ++c) {
                const std::size_t from =
                    (static_cast<std::size_t>(y * step) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(x * step)) *
                        channels +
                    c;
                const std::size_t to =
                    (static_cast<std::size_t>(y) * static_cast<std::size_t>(result.width) +
                     static_cast<std::size_t>(x)) *
                        channels +
                    c;
                // The high byte of 16 bits (little-endian) is its 8-bit value.
                result.data[to] = image.data[from * sample + sample - 1];
            }
    return result;
}

/// The material whose base colour, or whose ball, is the subject's thumbnail.
Material material_of(const ThumbnailCache::Subject& subject) {
    if (const auto* layer = std::get_if<Layer>(&subject)) return layer_thumbnail(*layer);
    if (const auto* mask = std::get_if<ThumbnailCache::LayerMask>(&subject))
        return mask_thumbnail(mask->mask, mask->stack, mask->layer);
    if (const auto* source = std::get_if<ThumbnailCache::ChannelSource>(&subject))
        return source_thumbnail(source->source, source->channel);
    return std::get<Material>(subject);
}

ThumbnailCache::LayerMask mask_of(const Material& material, const Layer& layer, Mask mask) {
    if (!reads_other_layers(mask)) return {.mask = std::move(mask)};
    return {.mask = std::move(mask), .stack = material.stack, .layer = layer.id};
}

Hash128 material_key(bool ball, const Material& material, const UvSurfacePtr& surface) {
    const Program program = Program::compile(material, surface);
    Hasher hasher;
    hasher.add(ball);
    for (int i = 0; i < kSlotCount; ++i) hasher.add(program.slot_hash(static_cast<Slot>(i)));
    hasher.add(material.ior).add(material.specular_factor).add(material.emissive_strength);
    return hasher.finish();
}

}  // namespace

ThumbnailCache::ThumbnailCache(std::function<void()> wake)
    : wake_(std::move(wake)), thread_([this] { run(); }) {}

ThumbnailCache::~ThumbnailCache() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    work_.notify_all();
    thread_.join();
}

void ThumbnailCache::set_images(std::shared_ptr<ImageProvider> images) {
    images_ = std::move(images);
    const std::lock_guard lock(mutex_);
    // What is still wanted is asked for again when it is drawn.
    for (const Request& request : requests_) entries_.erase(request.key);
    requests_.clear();
}

void ThumbnailCache::run() {
    std::unique_lock lock(mutex_);
    while (!stopping_) {
        if (requests_.empty()) {
            work_.wait(lock);
            continue;
        }
        Request request = std::move(requests_.front());
        requests_.pop_front();
        busy_ = true;
        lock.unlock();
        Made made = request.work();
        lock.lock();
        busy_ = false;
        made_.emplace_back(request.key, std::move(made));
        lock.unlock();
        wake_();
        lock.lock();
    }
}

Picture ThumbnailCache::find(const Hash128& key, std::function<Made()> work) {
    const auto [found, is_new] = entries_.try_emplace(key);
    found->second.used = ++clock_;
    if (is_new) {
        {
            const std::lock_guard lock(mutex_);
            requests_.push_back({key, std::move(work)});
        }
        work_.notify_all();
    }
    if (!found->second.image) return {};
    return {reinterpret_cast<ImTextureID>(found->second.image->texture())};
}

/// Keys are hashes of compiled programs, which cost more than a frame may: they are made when the
/// subject is another than the last one in its place, and kept.
Picture ThumbnailCache::of_subject(const Place& place, Subject subject, const Material& of) {
    if (!images_) return {};
    const bool ball = std::holds_alternative<Material>(subject);
    const auto worn = surfaces_.find(of.id);
    UvSurfacePtr surface = worn == surfaces_.end() ? nullptr : worn->second;
    if (ball) surface = ball_surface();
    if (keys_.size() > kMostKeys) keys_.clear();
    const auto [known, is_new] = keys_.try_emplace(place);
    if (is_new || known->second.subject != subject || known->second.surface != surface) {
        known->second.key = material_key(ball, material_of(subject), surface);
        known->second.subject = subject;
        known->second.surface = surface;
    }
    return find(
        known->second.key,
        [subject = std::move(subject), surface = std::move(surface), images = images_]() -> Made {
            const Material shown = material_of(subject);
            if (!std::holds_alternative<Material>(subject)) {
                if (Result<Image> picture = base_color_picture(shown, surface, *images))
                    return std::move(*picture);
                return {};
            }
            if (Result<render::SurfaceMaterial> made = small_surface(shown, *images))
                return std::move(*made);
            return {};
        });
}

Picture ThumbnailCache::layer(const Material& material, const Layer& layer) {
    return of_subject({PlaceKind::Layer, layer.id.value}, layer, material);
}

Picture ThumbnailCache::mask(const Material& material, const Layer& layer) {
    return of_subject({PlaceKind::Mask, layer.id.value}, mask_of(material, layer, layer.mask),
                      material);
}

Picture ThumbnailCache::mask_entry(const Material& material, const Layer& layer,
                                   const MaskEntry& entry) {
    return of_subject({PlaceKind::MaskEntry, entry.id.value},
                      mask_of(material, layer, only_entry(entry)), material);
}

Picture ThumbnailCache::channel_source(const Material& material, const Layer& layer,
                                       Channel channel) {
    return of_subject({PlaceKind::Source, layer.id.value, channel},
                      ChannelSource{at(layer.channels, channel).source, channel}, material);
}

Picture ThumbnailCache::material(const Material& material) {
    return of_subject({PlaceKind::Material, material.id.value}, material, material);
}

Picture ThumbnailCache::preset(const Preset& preset, const std::vector<KnobSetting>& knobs) {
    Hasher hasher;
    hasher.add("preset").add(preset.id).add(preset.version);
    for (const KnobSetting& knob : knobs) hasher.add(knob.id).add(knob.value);
    const io::PresetFile* file = nullptr;
    if (presets_ != nullptr)
        for (const io::PresetFile& each : *presets_)
            if (each.preset.id == preset.id) file = &each;
    if (file == nullptr) return {};
    return find(hasher.finish(), [copy = *file, knobs]() mutable -> Made {
        const auto layers = turned_layers(copy.preset, knobs);
        if (!layers) return {};
        copy.preset.layers = *layers;
        io::ImageStore images;
        if (const auto added = io::add_preset_images(copy, images); !added) return {};
        if (auto surface = small_surface(preset_thumbnail(copy.preset), images))
            return std::move(*surface);
        return {};
    });
}

Picture ThumbnailCache::image(const ImageAsset& image) {
    if (!images_) return {};
    Hasher hasher;
    hasher.add("image").add(image.hash);
    return find(hasher.finish(), [hash = image.hash, images = images_]() -> Made {
        const Result<ImagePtr> pixels = images->pixels(hash);
        if (!pixels || !*pixels) return {};
        if (Result<Image> small = small_image(**pixels)) return std::move(*small);
        return {};
    });
}

Picture ThumbnailCache::environment(const std::string& name) {
    if (name.empty() || !environments_) return {};
    const Result<EnvironmentSource> source = environments_(name);
    if (!source) return {};
    Hasher hasher;
    hasher.add("environment").add(source->builtin).add(source->file.string());
    return find(hasher.finish(), [source = *source]() -> Made {
        if (Result<Image> picture = environment_picture(source)) return std::move(*picture);
        return {};
    });
}

Result<Image> ThumbnailCache::ball_picture(const render::SurfaceMaterial& surface) {
    if (!ball_) ball_ = MaterialBall::create();
    if (!*ball_) return passed_on(*ball_);
    return (*ball_)->picture(surface, kThumbnailSide);
}

bool ThumbnailCache::finish_some(bool hurried) {
    while (true) {
        std::pair<Hash128, Made> next;
        {
            const std::lock_guard lock(mutex_);
            if (made_.empty()) return false;
            if (hurried && std::holds_alternative<render::SurfaceMaterial>(made_.front().second))
                return true;
            next = std::move(made_.front());
            made_.pop_front();
        }
        const auto* surface = std::get_if<render::SurfaceMaterial>(&next.second);
        Result<Image> picture = failure("nothing to show");
        if (surface != nullptr) picture = ball_picture(*surface);
        if (auto* image = std::get_if<Image>(&next.second)) picture = std::move(*image);
        if (picture) {
            if (auto uploaded = render::InterfaceImage::make(*picture)) {
                texture_bytes_ += uploaded->bytes();
                entries_[next.first].image = std::move(*uploaded);
            }
        }
        if (surface != nullptr) break;
    }
    forget_unused();
    const std::lock_guard lock(mutex_);
    return !made_.empty();
}

void ThumbnailCache::forget_unused() {
    while (entries_.size() > kMostEntries) {
        const auto oldest = std::min_element(
            entries_.begin(), entries_.end(),
            [](const auto& a, const auto& b) { return a.second.used < b.second.used; });
        if (oldest->second.image) texture_bytes_ -= oldest->second.image->bytes();
        entries_.erase(oldest);
    }
}

bool ThumbnailCache::settled() const {
    const std::lock_guard lock(mutex_);
    return !busy_ && requests_.empty() && made_.empty();
}

}  // namespace patina::editor

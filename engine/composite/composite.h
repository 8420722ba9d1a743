// SPDX-License-Identifier: MIT
#pragma once

/// The layer stack evaluated on the CPU: the reference, the bake, and the live path wherever OpenGL
/// runs in software. One fused pass over tiles (rows of them in parallel), the same texels on any
/// CPU and with any number of threads. May include core, scene, document and shaders/shared.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "composite/image_provider.h"
#include "composite/program.h"
#include "core/progress.h"

namespace patina {

/// Texels [x0, x1) x [y0, y1), row 0 at the top.
struct TexelRect {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
    bool empty() const { return x0 >= x1 || y0 >= y1; }
    bool operator==(const TexelRect&) const = default;
};

/// The baked maps that were asked for; the others are null. All are square, `size` texels a side.
struct MapSet {
    int size = 0;
    std::array<ImagePtr, kBakedMapCount> maps = {};
    const ImagePtr& operator[](BakedMap map) const { return maps[static_cast<std::size_t>(map)]; }
};

/// The maps that the slots of a program read, in order: those of a slot that is not constant. A
/// slot that shows an untouched image counts too, for whoever draws the composite instead of it.
std::vector<BakedMap> maps_of(const Program& program);

/// Bakes whole maps, without any cache. An image that is not there is a failure that names it.
/// `size` is 1 to 16384, a power of two or not.
/// @param wanted  the maps to make; see Program::slots for those that a material needs
Result<MapSet> bake_maps(const Program& program, ImageProvider& images, int size,
                         const std::vector<BakedMap>& wanted, const Progress& progress = {});

/// The live composite of one material: keeps the last result and float32 caches of what lies below
/// the edited layer, so that an edit costs what it changes. One thread at a time.
class LiveComposite {
  public:
    /// @param cache_budget_bytes  of the caches of what lies below; smaller copies of images, which
    ///                            cache_bytes() counts too, are beside it
    explicit LiveComposite(std::size_t cache_budget_bytes = std::size_t{512} << 20);
    ~LiveComposite();
    LiveComposite(LiveComposite&&) noexcept;
    LiveComposite& operator=(LiveComposite&&) noexcept;

    struct Update {
        std::vector<BakedMap> changed_maps;
        TexelRect changed;  ///< in texels of `size`; the whole map when it was made anew
        double elapsed_ms = 0.0;
    };
    /// Brings the maps of `maps_of(program)` up to date at `size` texels a side (the others become
    /// null: all their slots are constant); equals bake_maps bit for bit. Images that are not
    /// there show as a grey checker and are named in the log once.
    Result<Update> update(const Program& program, ImageProvider& images, int size,
                          const Progress& progress = {});
    /// The same where the caller knows that what is outside `within` is as at the last update (a
    /// brush stroke); only what is inside is composited, and as far around as adjustments reach.
    Result<Update> update_within(const TexelRect& within, const Program& program,
                                 ImageProvider& images, int size, const Progress& progress = {});
    /// The result of the last update; empty after one that was cancelled. Pixels that someone else
    /// still holds never change: hold on to a map no longer than needed, and the next update can
    /// write in place.
    const MapSet& maps() const;
    std::size_t cache_bytes() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// One step of `explain`: what a layer did to one channel of one texel. Of a normal that heights
/// bend the last step is of no layer (id 0): its source is the normal of the heights alone. Values
/// are as in ConstantSource: colours linear, whatever space the layer blends in.
struct ExplainStep {
    LayerId layer;
    std::string layer_name;
    int depth = 0;  ///< in groups
    BlendMode mode = BlendMode::Normal;
    glm::vec3 source = glm::vec3(0.0f);  ///< the layer's own value
    float mask = 1.0f;                   ///< times the share of a layer that blends by height
    float weight = 0.0f;                 ///< opacity x channel opacity x mask x coverage
    glm::vec3 result = glm::vec3(0.0f);  ///< after the layer
    float coverage =
        1.0f;  ///< after the layer, of what the group that it is in has laid down so far
};
/// The history of one texel, bottom to top, by the same program and kernels that bake it.
/// @param surface  as in Program::compile
Result<std::vector<ExplainStep>> explain_texel(const Material& material,
                                               const UvSurfacePtr& surface, ImageProvider& images,
                                               Channel channel, int size, int x, int y);

}  // namespace patina

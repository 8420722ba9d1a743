// SPDX-License-Identifier: MIT
#pragma once

/// A picture of a document without a window: what `patina render` writes. Makes its own surfaceless
/// OpenGL context; nothing may be current on the calling thread.

#include <functional>
#include <optional>
#include <span>

#include "composite/image_provider.h"
#include "core/progress.h"
#include "core/result.h"
#include "document/document.h"
#include "render/environment_cache.h"
#include "render/renderer.h"
#include "render/view.h"

namespace patina::render {

struct OffscreenRequest {
    PictureSize size = {1280, 720};
    int samples = 16;     ///< sub-pixel samples, 1 to 65536
    bool linear = false;  ///< linear radiance (or raw channel numbers) in F32 instead of sRGB
    SampleType sample_type = SampleType::U8;  ///< of sRGB pictures: U8 or U16
    /// Everything but what the document says: its lights are added to the view's, its environment's
    /// rotation is added and its intensity multiplied.
    View view;
    /// Set: `view.camera`, but for its up and its lens, is replaced by one that frames the scene
    /// from here.
    std::optional<ViewDirection> automatic_camera = ViewDirection::ThreeQuarter;
    std::optional<glm::vec3> automatic_target;  ///< what that one looks at; unset: the middle
    /// An equirectangular map that is decoded already; null: the built-in one that the document
    /// names, or the studio.
    ImagePtr environment;
    EnvironmentCache environment_cache = {};  ///< where filtered environments are kept; nowhere
    /// The costs of a picture are to be known: one of a single draw is drawn once more before, or
    /// they would be those of compiling programs.
    bool costs_wanted = false;
};

struct RenderedImage {
    /// RGBA, row 0 at the top; U8 or U16 (sample_type), sRGB, straight alpha; or F32 premultiplied
    /// where `linear`.
    Image image;
    FrameStats stats;
    double bake_ms = 0.0;
    double environment_ms = 0.0;
    double render_ms = 0.0;
};

/// Takes picture `index` of several, which is drawn over afterwards.
using EachPicture = std::function<Status(int index, RenderedImage& picture)>;

/// Composites the materials, filters the environment and draws pictures all around the target,
/// counter-clockwise from above, equally far apart; the first is from where the request says.
Status render_turntable_offscreen(const Document& document, ImageProvider& images,
                                  const OffscreenRequest& request, int pictures,
                                  const EachPicture& each, const Progress& progress = {});

/// One picture of each of these channels, in their order, all of the same view.
Status render_channels_offscreen(const Document& document, ImageProvider& images,
                                 const OffscreenRequest& request,
                                 std::span<const ChannelView> channels, const EachPicture& each,
                                 const Progress& progress = {});

}  // namespace patina::render

// SPDX-License-Identifier: MIT
#pragma once

/// All that panels read, as of one frame: the snapshot, what is selected in it, and what the
/// session knows beside it. Valid while the frame is drawn.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "composite/composite.h"
#include "document/document.h"
#include "document/preset.h"
#include "editor/state/actions.h"
#include "editor/widgets/log_lines.h"
#include "editor/widgets/ui.h"
#include "render/difference_stats.h"
#include "render/renderer.h"
#include "scene/uv_layout.h"

namespace patina::editor {

/// Thumbnails. One that is not made yet comes back empty and is made when there is time.
class Thumbnails {
  public:
    virtual ~Thumbnails() = default;
    virtual Picture layer(const Material& material, const Layer& layer) = 0;
    virtual Picture mask(const Material& material, const Layer& layer) = 0;
    virtual Picture mask_entry(const Material& material, const Layer& layer,
                               const MaskEntry& entry) = 0;
    virtual Picture channel_source(const Material& material, const Layer& layer,
                                   Channel channel) = 0;
    virtual Picture material(const Material& material) = 0;
    /// With some of its knobs turned.
    virtual Picture preset(const Preset& preset, const std::vector<KnobSetting>& knobs) = 0;
    virtual Picture image(const ImageAsset& image) = 0;
    virtual Picture environment(const std::string& name) = 0;
};

struct JobShown {
    int id = 0;
    std::string stage;  ///< "Baking 4 maps at 4096"
    float fraction = 0.0f;
    double seconds = 0.0;  ///< since it began
    bool can_cancel = true;
};

enum class ToastKind { Done, Note, Error };
struct ToastShown {
    int id = 0;
    ToastKind kind = ToastKind::Done;
    std::string message;
    std::string link;  ///< the label of its action, or empty
    Action action = Action::Undo;
};

struct HistoryShown {
    std::vector<std::string> labels;
    int position = 0;
    std::size_t bytes = 0;
    bool can_undo = false;
    bool can_redo = false;
};

struct EnvironmentShown {
    std::string name;  ///< as EnvironmentSettings::name
    std::string label;
};

struct CostShown {
    double frame_ms = 0.0;
    double composite_ms = 0.0;
    std::size_t memory_bytes = 0;
    std::size_t gpu_bytes = 0;
    render::FrameStats frame;
};

/// How far the picture of the viewport has been refined since something changed.
struct RefinementShown {
    int drawn = 0;
    int draws = 0;  ///< when it is finished; 0: it is not refined
};

/// What is known of the texel under the crosshair.
struct TexelShown {
    render::Probe probe;
    render::Pixel pixel;
    MaterialId material;
    int texel_x = 0;
    int texel_y = 0;
    std::vector<ExplainStep> steps = {};  ///< bottom to top, of `channel`
    std::optional<Channel> channel = std::nullopt;
};

/// What is known of two shadings that are compared.
struct ComparisonShown {
    render::DifferenceStats difference;        ///< over the model, exposed luminance
    std::optional<render::SideValues> values;  ///< under the crosshair, exposed
};

struct Shown {
    DocumentPtr document;  ///< null: nothing is open
    MaterialPtr material;
    LayerPtr layer;
    std::string file_name;
    bool edited = false;
    HistoryShown history;
    std::span<const JobShown> jobs;
    std::span<const ToastShown> toasts;
    std::span<const LogLine> log;
    bool keeps_previous = true;  ///< a first save leaves what was there as name~
    std::span<const Preset* const> presets;
    std::span<const EnvironmentShown> environments;
    CostShown cost;
    RefinementShown refinement;
    /// How the parts lie in the UV set of the material; known some time after the Material tab is
    /// shown.
    std::optional<UvLayout> uv_layout;
    Picture viewport;
    Picture strip;
    std::optional<TexelShown> texel;  ///< under the crosshair
    std::optional<ComparisonShown> comparison;
    std::optional<render::Probe> hovered;  ///< under the pointer, with the probe in hand
    Thumbnails* thumbnails = nullptr;
};

/// Whether what the action needs is there.
bool applies(Action action, const Shown& shown);

}  // namespace patina::editor

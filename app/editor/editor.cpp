// SPDX-License-Identifier: MIT
#include "editor/editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "core/log.h"
#include "editor/facts.h"
#include "editor/keys.h"
#include "editor/layout.h"
#include "editor/panels/panels.h"
#include "editor/settings.h"
#include "editor/window.h"
#include "editor/workspace.h"

namespace patina::editor {
namespace {

constexpr float kScaleStep = 0.25f;
constexpr float kLeastScale = 1.0f;
constexpr float kMostScale = 2.5f;
constexpr float kHistogramHeight = 128.0f;  // logical
/// Dear ImGui settles hovers and popups in the frames after an input.
constexpr int kSettlingFrames = 3;
constexpr int kRefiningDraws = 256;
/// A hand that pauses for less is still at work, and its next move shall find nothing under way.
constexpr double kRestingSeconds = 0.3;

float usable_scale(float wanted) {
    return std::clamp(std::round(wanted / kScaleStep) * kScaleStep, kLeastScale, kMostScale);
}

Status apply_scale(Ui& ui, Window& window, float scale) {
    Result<Fonts> fonts = load_fonts(scale);
    if (!fonts) return passed_on(fonts);
    ui.fonts = *fonts;
    ui.scale = scale;
    ImGui::GetStyle() = scaled_style(scale);
    window.upload_fonts();
    return {};
}

/// The window's root: everything is drawn into it, popups above.
class RootWindow {
  public:
    RootWindow() {
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        ImGui::SetNextWindowPos(ImVec2(0, 0));
        ImGui::SetNextWindowSize(size);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
        ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::kBase);
        ImGui::Begin("root", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                         ImGuiWindowFlags_NoBringToFrontOnFocus |
                         ImGuiWindowFlags_NoScrollWithMouse);
        rect_ = {0, 0, size.x, size.y};
    }
    ~RootWindow() {
        ImGui::End();
        ImGui::PopStyleColor();
        ImGui::PopStyleVar();
    }
    RootWindow(const RootWindow&) = delete;
    RootWindow& operator=(const RootWindow&) = delete;
    const Rect& rect() const { return rect_; }

  private:
    Rect rect_;
};

Requests draw_panels(Ui& ui, const Layout& layout, const Shown& shown, ViewState& view) {
    view.mask_entry_at_hand = {};
    Requests requests = draw_top_bar(ui, layout.top_bar, shown, view);
    draw_splitters(ui, layout, view.splitters);
    if (!layout.right.empty())
        requests.append(draw_properties(ui, layout.right, layout.width_class == WidthClass::Narrow,
                                        shown, view));
    if (!layout.layers.empty()) {
        requests.append(draw_materials_panel(ui, layout.materials, shown, view));
        requests.append(draw_layers_panel(ui, layout.layers, shown, view));
    }
    requests.append(draw_history_panel(ui, layout.history, shown, view));
    requests.append(draw_viewport_bar(ui, layout.viewport_bar, shown, view));
    requests.append(draw_viewport(ui, layout.viewport, shown, view));
    requests.append(layout.histogram ? draw_difference_panel(ui, layout.strip, shown, view)
                                     : draw_channel_strip(ui, layout.strip, shown, view));
    requests.append(draw_shelf(ui, layout.shelf, shown, view));
    requests.append(carry_to_model(ui, layout.viewport, layout.layers, shown, view));
    requests.append(draw_status_bar(ui, layout.status_bar, shown, view));
    return requests;
}

void take_keys(Ui& ui, Workspace& workspace, const Shown& shown) {
    const bool popup =
        ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    // No key acts while typing or in a popup.
    if (ImGui::GetIO().WantTextInput || ui.typing.id != 0 || popup || workspace.dialog_open())
        return;
    ViewState& view = workspace.view();
    if (const auto channel = pressed_channel()) view.view.channel = *channel;
    if (const auto action = pressed_action(ui.focus); action && applies(*action, shown))
        workspace.perform(*action);
    if (view.view.compare == render::CompareMode::Split)
        view.view.divider = std::clamp(
            view.view.divider + 0.01f * static_cast<float>(pressed_divider_step(ui.focus)), 0.0f,
            1.0f);
    if (pressed_escape() && !view.layer_drag.moving && !view.drag_to_model.moving) {
        ui.focus.leave();
        view.tool = ViewportTool::Move;
        view.crosshair.reset();
        view.solo = {};
        view.viewed_mask = {};
        workspace.session().forget_texel();
    }
}

void draw_dialogs(Ui& ui, Workspace& workspace, const Shown& shown) {
    if (const auto action = workspace.palette().draw(ui, shown)) workspace.perform(*action);
    workspace.file_dialog().draw(ui);
    if (const auto preset = workspace.preset_dialog().draw(ui, shown)) {
        Requests requests;
        requests.ask(*preset);
        workspace.carry_out(std::move(requests));
    }
    if (const auto preset = workspace.save_preset_dialog().draw(ui, shown)) {
        Requests requests;
        requests.ask(*preset);
        workspace.carry_out(std::move(requests));
    }
    workspace.export_dialog().draw(ui);
    workspace.save_view_dialog().draw(ui);
    workspace.question().draw(ui);
    workspace.keys().draw(ui);
    workspace.log().draw(ui, shown.log);
}

/// How the picture is refined while the hand rests.
struct Refining {
    int draws = kRefiningDraws;
    double seconds_to_rest = kRestingSeconds;
};

Session::FrameInput frame_input(const Ui& ui, const Layout& layout, const ViewState& view,
                                const Refining& refining) {
    Session::FrameInput input;
    const auto pixels = [](float size) { return std::max(static_cast<int>(size), 1); };
    input.viewport = {pixels(layout.viewport.width()), pixels(layout.viewport.height())};
    if (!layout.strip.empty() && !layout.histogram) {
        const Rect card = channel_picture(ui, layout.strip);
        input.strip_card = {pixels(card.width()), pixels(card.height())};
    }
    const ImVec2 mouse = ImGui::GetMousePos();
    if (view.tool == ViewportTool::Probe && layout.viewport.contains(mouse.x, mouse.y))
        input.hovered = glm::vec2((mouse.x - layout.viewport.x0) / layout.viewport.width(),
                                  (mouse.y - layout.viewport.y0) / layout.viewport.height());
    input.moving = ImGui::IsAnyMouseDown();
    input.refining_draws = view.refine_when_idle ? refining.draws : 0;
    input.resting = refining.seconds_to_rest <= 0.0;
    return input;
}

/// What the frames of one window are made with.
struct Parts {
    Ui& ui;
    Window& window;
    Workspace& workspace;
    Facts& facts;
    Refining refining = {};
    bool scale_chosen = false;  ///< by the user, in this session
    Rect viewport = {};         ///< of the last frame
    Rect layers = {};
};

/// One frame. Returns the seconds to wait before the next; negative: until something happens.
/// @param quiet  what came of the last input has been drawn
double draw_frame(Parts& parts, bool quiet) {
    Ui& ui = parts.ui;
    Window& window = parts.window;
    Workspace& workspace = parts.workspace;
    window.begin_frame();
    ui.begin_frame();
    Session& session = workspace.session();
    ViewState& view = workspace.view();
    {
        const RootWindow root;
        const bool open = session.has_document();
        const LayoutNeeds needs{
            open ? session.document().materials.size() : 0,
            open && render::shows_difference_beside(view.view) ? kHistogramHeight : 0.0f};
        const Layout layout = layout_for(ui, root.rect(), view, needs);
        workspace.set_has_log_panel(!layout.history.empty());
        parts.viewport = layout.viewport;
        parts.layers = layout.layers;
        session.update(view, frame_input(ui, layout, view, parts.refining));
        const Shown shown = session.shown(view);
        Requests requests = draw_panels(ui, layout, shown, view);
        draw_dialogs(ui, workspace, shown);
        workspace.carry_out(std::move(requests));
        if (ui.edit_ended && session.has_document()) session.history().seal();
        // In one slow frame a click and then a key may arrive: the key acts on what the click did.
        take_keys(ui, workspace, session.shown(view));
        if (!shown.toasts.empty()) ui.wake_in(0.5);
        ui.end_frame();
        parts.facts.state(ui, {session, view, shown, layout, quiet});
    }
    window.end_frame();
    // After the swap: who reads the map finds on screen what it says.
    if (const Status written = ui.map.end_frame(); !written)
        std::fprintf(stderr, "patina: %s\n", written.error().message.c_str());
    if (session.refining() && !ImGui::IsAnyMouseDown())
        ui.wake_in(std::max(parts.refining.seconds_to_rest, 0.0));
    return session.wants_frame() ? 0.0 : ui.seconds_to_wake();
}

/// On a part of the model files go to that part's material.
void take_dropped(const Parts& parts, const Window::Dropped& dropped) {
    Requests requests;
    DropPlace place = DropPlace::Window;
    const Rect& viewport = parts.viewport;
    if (parts.layers.contains(dropped.x, dropped.y)) place = DropPlace::Layers;
    if (viewport.contains(dropped.x, dropped.y)) {
        place = DropPlace::Viewport;
        requests.ask(PickAt{(dropped.x - viewport.x0) / viewport.width(),
                            (dropped.y - viewport.y0) / viewport.height()});
    }
    for (const auto& path : dropped.paths) requests.ask(TakeFile{path, place});
    parts.workspace.carry_out(std::move(requests));
}

std::string title_of(Session& session) {
    if (!session.has_document()) return "Patina";
    const std::string name = session.file_name().string();
    return name + (session.is_edited() ? " \u2022 edited" : "") + " \u2013 Patina";
}

Result<Window> open_window(const Options& options, const Settings& settings) {
    Window::Description description{.title = "Patina", .report_errors = options.ui_map.has_value()};
    if (settings.window_width > 0) description.width = settings.window_width;
    if (settings.window_height > 0) description.height = settings.window_height;
    if (options.window_width > 0) description.width = options.window_width;
    if (options.window_height > 0) description.height = options.window_height;
    return Window::open(description);
}

/// What the settings were changed to since they were written: written once nothing is dragged. What
/// the command line asked for is of this session only.
void remember(const Options& options, const Parts& parts, Settings& settings) {
    if (ImGui::IsAnyMouseDown()) return;
    Settings now = settings;
    const ViewState& view = parts.workspace.view();
    now.splitters = view.splitters;
    now.shelf_open = view.unfolded.shelf;
    now.small_cards = view.small_cards;
    now.favourites = view.favourites;
    now.keep_previous = parts.workspace.session().keeps_previous();
    if (!options.refining_draws) now.refine_when_idle = view.refine_when_idle;
    if (options.window_width == 0) now.window_width = parts.window.size()[0];
    if (options.window_height == 0) now.window_height = parts.window.size()[1];
    if (parts.scale_chosen) now.scale = parts.ui.scale;
    if (now == settings) return;
    settings = now;
    if (const Status written = write_settings(settings_file(), settings); !written)
        log_warning("{}", written.error().message);
}

Status run_window(const Options& options) {
    Settings settings = read_settings(settings_file());
    Result<Window> opened = open_window(options, settings);
    if (!opened) return passed_on(opened);
    Window window = std::move(*opened);
    Ui ui;
    ui.map.write_to(options.ui_map);
    const float remembered = settings.scale > 0.0f ? settings.scale : window.content_scale();
    const float scale = usable_scale(options.scale > 0.0f ? options.scale : remembered);
    if (const Status scaled = apply_scale(ui, window, scale); !scaled) return scaled;
    Result<std::unique_ptr<Session>> session = Session::create(&Window::wake);
    if (!session) return passed_on(session);
    Workspace workspace(std::move(*session));
    workspace.view().splitters = settings.splitters;
    workspace.view().unfolded.shelf = settings.shelf_open;
    workspace.view().small_cards = settings.small_cards;
    workspace.view().favourites = settings.favourites;
    workspace.session().set_keep_previous(settings.keep_previous);
    workspace.view().refine_when_idle =
        options.refining_draws.value_or(settings.refine_when_idle ? kRefiningDraws : 0) > 0;
    if (options.file) workspace.take_file({*options.file});
    Facts facts;
    Parts parts{ui, window, workspace, facts};
    if (options.refining_draws.value_or(0) > 0) parts.refining.draws = *options.refining_draws;
    auto touched = std::chrono::steady_clock::now();
    std::string title;
    int frames_left = kSettlingFrames;
    double wait_seconds = 0.0;
    while (!workspace.quitting()) {
        if (frames_left > 0)
            window.poll();
        else
            window.wait(wait_seconds);
        const auto now = std::chrono::steady_clock::now();
        if (window.take_input()) {
            frames_left = kSettlingFrames;
            touched = now;
        }
        parts.refining.seconds_to_rest =
            kRestingSeconds - std::chrono::duration<double>(now - touched).count();
        for (const Window::Dropped& dropped : window.take_dropped()) take_dropped(parts, dropped);
        if (window.close_wanted()) {
            window.refuse_close();
            workspace.quit();
        }
        if (const int steps = workspace.take_scale_steps(); steps != 0) {
            const float next = usable_scale(ui.scale + kScaleStep * static_cast<float>(steps));
            if (const Status scaled = apply_scale(ui, window, next); !scaled) return scaled;
            parts.scale_chosen = true;
            frames_left = kSettlingFrames;
        }
        if (frames_left > 0) --frames_left;
        wait_seconds = draw_frame(parts, frames_left == 0);
        remember(options, parts, settings);
        if (const std::string wanted = title_of(workspace.session()); wanted != title) {
            title = wanted;
            window.set_title(title);
        }
    }
    return {};
}

}  // namespace

int run(const Options& options) {
    const Status status = run_window(options);
    if (status) return 0;
    std::fprintf(stderr, "patina: %s\n", status.error().message.c_str());
    return 1;
}

}  // namespace patina::editor

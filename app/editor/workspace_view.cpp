// SPDX-License-Identifier: MIT
#include "editor/workspace.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace patina::editor {

void Workspace::frame(const Bounds& bounds) {
    if (!session_->has_document()) return;
    view_.view.camera =
        render::framed_from(view_.view.camera, bounds, session_->view_aspect(view_));
}

void Workspace::look_from(render::ViewDirection direction) {
    if (!session_->has_document()) return;
    view_.view.camera = render::framed_from_direction(view_.view.camera, session_->bounds(),
                                                      session_->view_aspect(view_), direction);
}

/// What the picture shows, and how it is shaded.
void Workspace::perform_picture(Action action) {
    render::View& view = view_.view;
    const auto step_channel = [&view](int step) {
        const int count = render::kChannelViewCount;
        const int next = (static_cast<int>(view.channel) + step + count) % count;
        view.channel = static_cast<render::ChannelView>(next);
    };
    switch (action) {
        case Action::ViewSingle:
            view.compare = render::CompareMode::Single;
            return;
        case Action::ViewSplit:
            view.compare = render::CompareMode::Split;
            return;
        case Action::ViewTwo:
            view.compare = render::CompareMode::TwoViews;
            return;
        case Action::ViewDifference:
            view.compare = render::CompareMode::Difference;
            return;
        case Action::NextCompareMode:
            view.compare =
                static_cast<render::CompareMode>((static_cast<int>(view.compare) + 1) % 4);
            return;
        case Action::SwapSides:
            std::swap(view.left, view.right);
            return;
        case Action::ShadePbr:
            view.left.model = render::ShadingModel::Pbr;
            return;
        case Action::ShadePhong:
            view.left.model = render::ShadingModel::Phong;
            return;
        case Action::ShadeBlinnPhong:
            view.left.model = render::ShadingModel::BlinnPhong;
            return;
        case Action::NextChannel:
            return step_channel(1);
        case Action::PreviousChannel:
            return step_channel(-1);
        case Action::ShowUv:
            view.channel = view.channel == render::ChannelView::UvChecker
                               ? render::ChannelView::Final
                               : render::ChannelView::UvChecker;
            return;
        case Action::ShowWires:
            view.wires = !view.wires;
            return;
        case Action::BrighterExposure:
            view.exposure_ev = std::min(view.exposure_ev + 1.0f / 3.0f, 6.0f);
            return;
        case Action::DarkerExposure:
            view.exposure_ev = std::max(view.exposure_ev - 1.0f / 3.0f, -6.0f);
            return;
        default:
            return;
    }
}

void Workspace::perform_camera(Action action) {
    switch (action) {
        case Action::FrameModel:
            return frame(session_->bounds());
        case Action::FrameMaterial:
            return frame(session_->bounds_of_material(view_));
        case Action::LookFromThreeQuarter:
            return look_from(render::ViewDirection::ThreeQuarter);
        case Action::LookFromFront:
            return look_from(render::ViewDirection::Front);
        case Action::LookFromBack:
            return look_from(render::ViewDirection::Back);
        case Action::LookFromLeft:
            return look_from(render::ViewDirection::Left);
        case Action::LookFromRight:
            return look_from(render::ViewDirection::Right);
        case Action::LookFromTop:
            return look_from(render::ViewDirection::Top);
        case Action::LookFromBottom:
            return look_from(render::ViewDirection::Bottom);
        case Action::Orthographic:
            view_.view.camera = render::with_other_projection(view_.view.camera);
            return;
        default:
            return;
    }
}

/// Panels, tools and boxes.
void Workspace::perform_interface(Action action) {
    switch (action) {
        case Action::ProbeTool:
            view_.tool =
                view_.tool == ViewportTool::Probe ? ViewportTool::Move : ViewportTool::Probe;
            return;
        case Action::ShowLights:
            view_.right_tab = RightTab::Material;
            view_.unfolded.lights = true;
            return;
        case Action::HidePanels:
            view_.panels_hidden = !view_.panels_hidden;
            return;
        case Action::ShowLog:
            if (has_log_panel_)
                view_.history_tab = HistoryTab::Log;
            else
                log_.open();
            return;
        case Action::ResetLayout:
            view_.splitters = {};
            view_.panels_hidden = false;
            return;
        case Action::LargerInterface:
            ++scale_steps_;
            return;
        case Action::SmallerInterface:
            --scale_steps_;
            return;
        case Action::FindAction:
            palette_.open();
            return;
        case Action::Keys:
            keys_.open();
            return;
        case Action::About:
            question_.ask({.title = fmt::format("Patina {}", PATINA_VERSION),
                           .text = "An editor for layered physically based materials. What it "
                                   "saves is glTF 2.0. MIT licence.",
                           .answers = {{"Close", {}, true}}});
            return;
        default:
            return;
    }
}

}  // namespace patina::editor

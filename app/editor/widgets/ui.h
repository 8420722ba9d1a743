// SPDX-License-Identifier: MIT
#pragma once

/// What every control is made of: scale, fonts, painting in tokens, and one way to be pressed.
/// Every control goes through `press` (or `note`), which also tells the UiMap of it. A Ui is passed
/// to all that draws; it holds no state of the document.

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

#include "editor/widgets/focus.h"
#include "editor/widgets/fonts.h"
#include "editor/widgets/icons.h"
#include "editor/widgets/rect.h"
#include "editor/widgets/theme.h"
#include "editor/widgets/ui_map.h"

namespace patina::editor {

enum class Align { Left, Center, Right };

/// What a tooltip says: what it is, its range or use, its key. It appears after 500 ms.
struct Tip {
    std::string title;
    std::string text = {};
    std::string key = {};
};

/// A control as the UiMap and the tooltip know it.
struct Control {
    std::string_view label;
    std::string_view kind;
    std::string_view value = {};
    bool enabled = true;
    const Tip* tip = nullptr;
    bool focusable = true;  ///< false: what only the pointer can work, and keys do otherwise
};

struct Press {
    ImGuiID id = 0;
    bool hovered = false;
    bool held = false;      ///< the left button went down here and still is
    bool started = false;   ///< it went down in this frame
    bool released = false;  ///< it came up in this frame after it went down here
    bool clicked = false;   ///< and came up here
    bool double_clicked = false;
    bool right_clicked = false;
    bool focused = false;  ///< the keyboard is at it
};

/// An image for the interface: a texture and the part of it to show. 0 has not been made yet.
struct Picture {
    ImTextureID texture = nullptr;
    ImVec2 uv0 = ImVec2(0.0f, 0.0f);
    ImVec2 uv1 = ImVec2(1.0f, 1.0f);
};

class Ui {
  public:
    float scale = 1.0f;
    Fonts fonts;
    UiMap map;
    Focus focus;
    /// Set by a control whose drag or typing ended: the next edit is a step of its own.
    bool edit_ended = false;
    /// Multiplies the alpha of all that is painted, for what is disabled or hidden; 0 to 255.
    unsigned alpha = 255;

    /// Logical pixels to whole pixels of the window.
    float px(float logical) const;
    /// Asks for another frame within `seconds`, for what changes by itself (a tooltip, a spinner).
    void wake_in(double seconds);
    /// Starts a frame: no wishes yet.
    void begin_frame();
    /// Draws what lies above everything: the tooltip that is due.
    void end_frame();
    /// Seconds until the next frame is wanted; negative: only when something happens.
    double seconds_to_wake() const { return wake_seconds_; }

    /// Reports the hovered control's tooltip; shown when the pointer has rested on it.
    void offer_tip(ImGuiID id, const Rect& anchor, const Tip& tip);

    /// The number or text field that is being typed into.
    struct Typing {
        ImGuiID id = 0;
        std::string text;
        bool fresh = false;  ///< to be focused and selected in this frame
    };
    Typing typing;

  private:
    double wake_seconds_ = -1.0;
    ImGuiID tip_id_ = 0;
    double tip_since_ = 0.0;
    bool tip_offered_ = false;
    Rect tip_anchor_;
    Tip tip_;
};

/// Names the panel or row that the controls within belong to, for ids and the UiMap.
class Place {
  public:
    Place(Ui& ui, std::string_view name);
    /// The same with ids by `id` instead of by the name (rows whose names may repeat).
    Place(Ui& ui, std::string_view name, std::uint64_t id);
    ~Place();
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

  private:
    Ui& ui_;
};

/// Paints all within at a share of its alpha.
class Faded {
  public:
    Faded(Ui& ui, bool faded, unsigned alpha = 115);
    ~Faded() { ui_.alpha = before_; }
    Faded(const Faded&) = delete;
    Faded& operator=(const Faded&) = delete;

  private:
    Ui& ui_;
    unsigned before_;
};

// Painting. Rectangles are in pixels; radii and thicknesses are logical.
void fill(const Ui& ui, const Rect& rect, ImU32 color, float radius = 0.0f,
          ImDrawFlags corners = ImDrawFlags_RoundCornersAll);
void outline(const Ui& ui, const Rect& rect, ImU32 color, float radius = 0.0f,
             float thickness = 1.0f);
/// One pixel high, at the top of `rect`.
void hairline(const Ui& ui, const Rect& rect, ImU32 color = theme::kHairline);
void disc(const Ui& ui, float x, float y, float radius, ImU32 color);
void ring(const Ui& ui, float x, float y, float radius, ImU32 color, float thickness);
void line(const Ui& ui, float x0, float y0, float x1, float y1, ImU32 color, float thickness);
void picture(const Ui& ui, const Rect& rect, const Picture& picture, float radius = 0.0f);

float text_width(const ImFont* font, std::string_view text);
/// One line, in the middle of the rectangle's height, with an ellipsis where it does not fit.
/// Returns the x where it ends.
float text(const Ui& ui, const Rect& rect, const ImFont* font, ImU32 color, std::string_view words,
           Align align = Align::Left);
/// Broken at spaces to the width. Returns the height it took.
float paragraph(const Ui& ui, const Rect& rect, const ImFont* font, ImU32 color,
                std::string_view words);
/// An icon in the middle, at a size in logical pixels.
void icon_glyph(const Ui& ui, const Rect& rect, const char* glyph, ImU32 color, float size = 14.0f);
/// A key as a small bordered chip with its left edge at the rectangle's; returns its width.
float key_chip(const Ui& ui, const Rect& rect, std::string_view key);

/// The part of `rect` that is not clipped away.
Rect visible_part(const Rect& rect);
/// A control that can be pressed. Everything that reacts to the mouse is made of this.
Press press(Ui& ui, const Rect& rect, const Control& control);
/// A control that is only shown or that reacts by itself: tells the UiMap and the tooltip of it.
void note(Ui& ui, const Rect& rect, const Control& control);

/// A clipped region with its own scroll bar. Lay rows out from `content()` and say how far they
/// went with `set_height`.
class ScrollArea {
  public:
    ScrollArea(Ui& ui, const char* id, const Rect& rect);
    ~ScrollArea();
    ScrollArea(const ScrollArea&) = delete;
    ScrollArea& operator=(const ScrollArea&) = delete;
    /// As wide as the region; its top moves up as the region scrolls.
    Rect content() const { return content_; }
    void set_height(float pixels) { height_ = pixels; }
    /// Scrolls so that y (in window pixels) comes into view.
    void reveal(float y0, float y1) const;

  private:
    Rect rect_;
    Rect content_;
    float height_ = 0.0f;
};

}  // namespace patina::editor

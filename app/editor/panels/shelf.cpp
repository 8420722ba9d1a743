// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "document/edits.h"
#include "editor/panels/panels.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/combo.h"
#include "editor/widgets/dragging.h"
#include "editor/widgets/name_search.h"
#include "editor/widgets/popup_menu.h"
#include "editor/widgets/text_field.h"

namespace patina::editor {
namespace {

struct CardSpec {
    std::string_view label;
    std::string_view tooltip;
    Picture picture;
    bool round = true;
    bool wide = false;  ///< an environment: twice as wide as high
    bool on = false;
    bool enabled = true;
    std::optional<bool> favourite = {};  ///< unset: there is no star on it
};

struct CardPress {
    Press press;
    bool starred = false;  ///< its star was clicked
};

/// The star at the top right of a card: always where it is a favourite, else under the pointer.
bool draw_star(Ui& ui, const Rect& card, bool favourite) {
    const Rect box{card.x1 - ui.px(24), card.y0, card.x1, card.y0 + ui.px(24)};
    const Tip tip{favourite ? "Remove from favourites" : "Add to favourites",
                  "The star above the shelf shows favourites alone"};
    const Press pressed = press(ui, box,
                                {.label = favourite ? "Favourite" : "Not a favourite",
                                 .kind = "star",
                                 .value = favourite ? "on" : "off",
                                 .tip = &tip,
                                 .focusable = false});
    const ImVec2 mouse = ImGui::GetMousePos();
    if (favourite || card.contains(mouse.x, mouse.y))
        icon_glyph(ui, box, favourite ? icon::kStar : icon::kStarEmpty,
                   favourite         ? theme::kWarning
                   : pressed.hovered ? theme::kText
                                     : theme::kText2,
                   12);
    return pressed.clicked;
}

/// A picture with its name below.
CardPress draw_card(Ui& ui, const Rect& card, float side, const CardSpec& spec) {
    const Tip tip{std::string(spec.label), std::string(spec.tooltip)};
    const Place place(ui, spec.label);
    const Faded faded(ui, !spec.enabled);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.ChannelsSplit(2);
    list.ChannelsSetCurrent(1);
    const bool starred = spec.favourite && draw_star(ui, card, *spec.favourite);
    list.ChannelsSetCurrent(0);
    const Press pressed = press(ui, card,
                                {.label = spec.label,
                                 .kind = "card",
                                 .value = spec.on ? "on" : "",
                                 .enabled = spec.enabled,
                                 .tip = &tip});
    if (pressed.hovered || spec.on) fill(ui, card, spec.on ? theme::kSelected : theme::kPopup, 6);
    Rect rest = card;
    rest.cut_top(ui.px(6));
    const float height = spec.wide ? 0.5f * side : side;
    const Rect frame = rest.cut_top(side).centered(side, height);
    if (spec.picture.texture == nullptr && spec.round)
        disc(ui, frame.center_x(), frame.center_y(), 0.46f * side / ui.scale, theme::kField);
    if (!spec.round) fill(ui, frame, rgb(0x0D0D0D), 3);
    picture(ui, frame, spec.picture, spec.round ? 0.0f : 3.0f);
    rest.cut_top(ui.px(6));
    text(ui, rest.cut_top(ui.px(16)).inset(ui.px(4), 0), ui.fonts.caption11,
         pressed.hovered ? theme::kText : theme::kText2, spec.label, Align::Center);
    list.ChannelsMerge();
    return {pressed, starred};
}

/// Cards in rows, as many as fit, in a region that scrolls.
class CardGrid {
  public:
    CardGrid(Ui& ui, const Rect& rect, bool small)
        : ui_(ui), area_(ui, "cards", rect), content_(area_.content()) {
        const bool wide = rect.width() / ui.scale > 900;
        side_ = ui.px(small ? 44.0f : wide ? 80.0f : 60.0f);
        width_ = ui.px(small ? 76 : 100);
        height_ = side_ + ui.px(34);
        const float room = content_.width() - ui.px(16);
        columns_ = std::max(1, static_cast<int>(room / width_));
        step_ = std::floor(room / static_cast<float>(columns_));
    }
    ~CardGrid() {
        const int rows = (count_ + columns_ - 1) / columns_;
        area_.set_height(ui_.px(12) + static_cast<float>(rows) * (height_ + ui_.px(4)));
    }
    CardGrid(const CardGrid&) = delete;
    CardGrid& operator=(const CardGrid&) = delete;

    CardPress add(const CardSpec& spec) {
        const auto column = static_cast<float>(count_ % columns_);
        const int rows_before = count_ / columns_;
        const auto row = static_cast<float>(rows_before);
        ++count_;
        const float x = content_.x0 + ui_.px(8) + column * step_;
        const float y = content_.y0 + ui_.px(6) + row * (height_ + ui_.px(4));
        return draw_card(ui_, {x, y, x + width_, y + height_}, side_, spec);
    }
    int count() const { return count_; }

  private:
    Ui& ui_;
    ScrollArea area_;
    Rect content_;
    float side_ = 0.0f;
    float width_ = 0.0f;
    float height_ = 0.0f;
    float step_ = 0.0f;
    int columns_ = 1;
    int count_ = 0;
};

bool shown_here(const Preset& preset, const ViewState& view) {
    if (view.favourites_alone && !view.favourites.contains(preset.id)) return false;
    if (!view.shelf_category.empty() && preset.category != view.shelf_category) return false;
    std::string where = preset.name;
    for (const std::string& tag : preset.tags) where += " " + tag;
    return name_matches(where, view.shelf_search);
}

Requests preset_menu(Ui& ui, const Preset& preset) {
    Requests requests;
    PopupMenu menu(ui, "preset menu", 200);
    if (!menu.open()) return requests;
    if (menu.item({.icon = icon::kPlus, .label = "Add above the layer"}))
        requests.ask(ApplyPreset{preset.id});
    if (menu.item({.icon = icon::kReset, .label = "Replace the stack"}))
        requests.ask(ApplyPreset{preset.id, true});
    if (menu.item({.icon = icon::kSliders,
                   .label = "Turn its knobs\u2026",
                   .enabled = !preset.knobs.empty()}))
        requests.ask(TurnKnobs{preset.id});
    return requests;
}

void nothing_matches(Ui& ui, const Rect& rect, ViewState& view) {
    Rect row = Rect{rect.x0, rect.y0, rect.x1, rect.y0 + ui.px(50)}.inset(ui.px(16), ui.px(12));
    const std::string words = view.favourites.empty() && view.favourites_alone
                                  ? "No favourites yet: click the star of a preset"
                              : view.shelf_search.empty()
                                  ? "No favourites in " + view.shelf_category
                                  : "Nothing matches '" + view.shelf_search + "'";
    row.x0 = text(ui, row, ui.fonts.body13, theme::kText3, words) + ui.px(4);
    const TextButton clear{.label = view.favourites_alone ? "Show all" : "Clear", .link = true};
    if (text_button(ui, row.cut_left(text_button_width(ui, clear)), clear)) {
        view.shelf_search.clear();
        view.shelf_category.clear();
        view.favourites_alone = false;
    }
}

Requests draw_presets(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view) {
    Requests requests;
    int count = 0;
    {
        CardGrid grid(ui, rect, view.small_cards);
        for (const Preset* preset : shown.presets) {
            if (!shown_here(*preset, view)) continue;
            const std::string tooltip =
                preset->description +
                "\nClick adds it, drag lays it on a part, right click for more";
            const bool favourite = view.favourites.contains(preset->id);
            const auto [pressed, starred] =
                grid.add({.label = preset->name,
                          .tooltip = tooltip,
                          .picture = shown.thumbnails->preset(*preset, {}),
                          .enabled = shown.material != nullptr,
                          .favourite = favourite});
            if (starred && favourite) view.favourites.erase(preset->id);
            if (starred && !favourite) view.favourites.insert(preset->id);
            ImGui::PushID(preset->id.c_str());
            if (clicked_or_dragged(ui, pressed, {.what = preset->id}, view))
                requests.ask(ApplyPreset{preset->id});
            if (pressed.right_clicked) ImGui::OpenPopup("preset menu");
            requests.append(preset_menu(ui, *preset));
            ImGui::PopID();
        }
        count = grid.count();
    }
    if (count == 0 && !shown.presets.empty()) nothing_matches(ui, rect, view);
    return requests;
}

Requests draw_images(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view) {
    Requests requests;
    int count = 0;
    {
        CardGrid grid(ui, rect, view.small_cards);
        if (shown.document)
            for (const auto& [hash, image] : shown.document->images) {
                if (!name_matches(image->name, view.shelf_search)) continue;
                const Press pressed =
                    grid.add({.label = image->name,
                              .tooltip = "Click adds it as a layer, drag lays it on a part",
                              .picture = shown.thumbnails->image(*image),
                              .round = false})
                        .press;
                if (clicked_or_dragged(ui, pressed, {.what = hash}, view))
                    requests.ask(AddImageAsLayer{hash});
            }
        count = grid.count();
    }
    if (count == 0)
        text(ui, Rect{rect.x0, rect.y0, rect.x1, rect.y0 + ui.px(44)}.inset(ui.px(16), 0),
             ui.fonts.body13, theme::kText3, "Drop images here to bring them into the document");
    return requests;
}

Requests draw_environments(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view) {
    Requests requests;
    CardGrid grid(ui, rect, view.small_cards);
    for (const EnvironmentShown& environment : shown.environments) {
        if (!name_matches(environment.label, view.shelf_search)) continue;
        const bool on = shown.document && shown.document->environment.name == environment.name;
        const Press pressed = grid.add({.label = environment.label,
                                        .tooltip = "Click lights the model with it",
                                        .picture = shown.thumbnails->environment(environment.name),
                                        .round = false,
                                        .wide = true,
                                        .on = on,
                                        .enabled = shown.document != nullptr})
                                  .press;
        if (pressed.clicked && !on) requests.edit(set_environment_name(environment.name));
    }
    return requests;
}

using Categories = std::vector<std::pair<std::string, std::size_t>>;

/// "All" and each category with its number of presets.
Categories categories_of(std::span<const Preset* const> presets) {
    std::map<std::string, std::size_t> counts;
    for (const Preset* preset : presets) ++counts[preset->category];
    Categories result = {{"", presets.size()}};
    result.insert(result.end(), counts.begin(), counts.end());
    return result;
}

void draw_category_column(Ui& ui, const Rect& rect, const Categories& categories, ViewState& view) {
    fill(ui, {rect.x1 - ui.px(1), rect.y0, rect.x1, rect.y1}, theme::kHairline);
    ScrollArea area(ui, "categories", {rect.x0, rect.y0, rect.x1 - ui.px(1), rect.y1});
    Rect row = area.content();
    row.y0 += ui.px(6);
    row.y1 = row.y0 + ui.px(26);
    for (const auto& [name, count] : categories) {
        const bool on = view.shelf_category == name;
        const std::string_view label = name.empty() ? std::string_view("All") : name;
        const Press pressed =
            press(ui, row, {.label = label, .kind = "category", .value = on ? "on" : "off"});
        row_tint(ui, row, on, pressed.hovered);
        Rect inner = row;
        inner.cut_left(ui.px(12));
        inner.cut_right(ui.px(10));
        text(ui, inner, ui.fonts.value12, on ? theme::kText : theme::kText3, std::to_string(count),
             Align::Right);
        text(ui, inner, ui.fonts.value12, on ? theme::kText : theme::kText2, label);
        if (pressed.clicked) view.shelf_category = name;
        row = row.moved(0, row.height());
    }
    area.set_height(ui.px(12) + static_cast<float>(categories.size()) * row.height());
}

void draw_category_combo(Ui& ui, const Rect& rect, const Categories& categories, ViewState& view) {
    std::vector<std::string> labels;
    int chosen = 0;
    for (std::size_t i = 0; i < categories.size(); ++i) {
        const auto& [name, count] = categories[i];
        labels.push_back((name.empty() ? "All" : name) + ", " + std::to_string(count));
        if (name == view.shelf_category) chosen = static_cast<int>(i);
    }
    std::vector<ComboItem> items;
    for (const std::string& label : labels) items.push_back({.label = label});
    if (const auto picked = combo(ui, rect, {.label = "Category"}, items, chosen))
        view.shelf_category = categories[static_cast<std::size_t>(*picked)].first;
}

void draw_title(Ui& ui, Rect title, bool wide, bool open, const Categories& categories,
                ViewState& view) {
    title.cut_left(ui.px(theme::kPadding));
    title.cut_right(ui.px(6));
    const auto tab_of = [&](std::string_view label, ShelfTab which) {
        if (!tab(ui, title, {label, open && view.shelf_tab == which})) return;
        view.shelf_tab = which;
        view.unfolded.shelf = view.unfolded.narrow_shelf = true;
    };
    tab_of("Presets", ShelfTab::Presets);
    tab_of("Images", ShelfTab::Images);
    tab_of("Environments", ShelfTab::Environments);
    if (icon_button(ui, title.cut_right(ui.px(26)),
                    {.icon = open ? icon::kChevronDown : icon::kChevronUp,
                     .label = open ? "Fold the shelf" : "Unfold the shelf",
                     .size = 11}))
        view.unfolded.shelf = view.unfolded.narrow_shelf = !open;
    if (!open) return;
    if (icon_button(ui, title.cut_right(ui.px(26)),
                    {.icon = icon::kGrid,
                     .label = view.small_cards ? "Large cards" : "Small cards",
                     .tooltip = "How large the pictures of the shelf are",
                     .on = view.small_cards}))
        view.small_cards = !view.small_cards;
    if (view.shelf_tab == ShelfTab::Presets &&
        icon_button(ui, title.cut_right(ui.px(26)),
                    {.icon = view.favourites_alone ? icon::kStar : icon::kStarEmpty,
                     .label = view.favourites_alone ? "Show all presets" : "Show favourites alone",
                     .tooltip = "A preset becomes one by the star on its card",
                     .on = view.favourites_alone}))
        view.favourites_alone = !view.favourites_alone;
    title.cut_right(ui.px(4));
    const float search = ui.px(wide ? 220 : 132);
    search_field(ui, title.cut_right(search).centered(search, ui.px(24)),
                 {.label = "Search the shelf", .hint = wide ? "Search names and tags" : "Search"},
                 view.shelf_search);
    if (wide || view.shelf_tab != ShelfTab::Presets) return;
    title.cut_right(ui.px(4));
    draw_category_combo(ui, title.cut_right(ui.px(96)).centered(ui.px(96), ui.px(24)), categories,
                        view);
}

}  // namespace

Requests draw_shelf(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view) {
    if (rect.empty()) return {};
    const Place place(ui, "Shelf");
    fill(ui, rect, theme::kPanel, 6);
    Rect rest = rect;
    const bool wide = rect.width() / ui.scale > 900;
    const bool open = rect.height() > ui.px(theme::kPanelTitle) + 2;
    const Categories categories = categories_of(shown.presets);
    draw_title(ui, rest.cut_top(ui.px(theme::kPanelTitle)), wide, open, categories, view);
    if (!open) return {};
    hairline(ui, rest);
    rest.cut_top(ui.px(1));
    switch (view.shelf_tab) {
        case ShelfTab::Presets:
            if (wide) draw_category_column(ui, rest.cut_left(ui.px(132)), categories, view);
            return draw_presets(ui, rest, shown, view);
        case ShelfTab::Images:
            return draw_images(ui, rest, shown, view);
        case ShelfTab::Environments:
            return draw_environments(ui, rest, shown, view);
    }
    return {};
}

}  // namespace patina::editor

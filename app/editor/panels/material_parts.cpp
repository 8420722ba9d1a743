// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "document/edits.h"
#include "editor/panels/panels.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/form.h"

namespace patina::editor {
namespace {

/// The material that a part gets when it is unticked: none where the file itself says this one.
MaterialPtr other_material(const Part& part, const MaterialPtr& material) {
    return part.material_of_file == material ? nullptr : part.material_of_file;
}

Requests draw_part(Ui& ui, const Rect& rect, const Part& part, const MaterialPtr& material) {
    Requests requests;
    const bool ticked = part.material == material;
    const MaterialPtr other = other_material(part, material);
    const Place place(ui, part.name,
                      static_cast<std::uint64_t>(part.ref.mesh) * 65536 +
                          static_cast<std::uint64_t>(part.ref.primitive) + 1);
    Rect line = rect;
    if (!ticked && part.material) {
        const Rect words = line.cut_right(0.45f * line.width());
        text(ui, words, ui.fonts.caption11, theme::kText3, part.material->name, Align::Right);
        line.cut_right(ui.px(8));
    }
    const std::string tooltip =
        !ticked ? "Draws this part with " + material->name
                : (other ? "Gives it back to " + other->name
                         : "The file draws it with this one: assign it another material instead");
    if (!labelled_checkbox(ui, line, part.name, ticked, tooltip, !ticked || other != nullptr))
        return requests;
    requests.edit(assign_material(ticked ? *other : *material, part));
    return requests;
}

}  // namespace

Requests draw_material_parts(Ui& ui, Rect& rest, const Shown& shown, ViewState& view) {
    Requests requests;
    const Place place(ui, "Parts");
    const std::vector<Part> parts = parts_of(*shown.document);
    const auto drawn = std::count_if(parts.begin(), parts.end(), [&](const Part& part) {
        return part.material == shown.material;
    });
    const Rect head = rest.cut_top(ui.px(theme::kPanelTitle));
    hairline(ui, head);
    if (section(ui, head,
                {.title = "Parts",
                 .count = fmt::format("{} of {}", drawn, parts.size()),
                 .open = view.unfolded.parts}))
        view.unfolded.parts = !view.unfolded.parts;
    if (!view.unfolded.parts) return requests;
    for (const Part& part : parts)
        requests.append(
            draw_part(ui, next_line(ui, rest).inset(ui.px(12), 0), part, shown.material));
    rest.cut_top(ui.px(6));
    return requests;
}

}  // namespace patina::editor

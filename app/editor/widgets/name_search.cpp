// SPDX-License-Identifier: MIT
#include "editor/widgets/name_search.h"

#include <algorithm>
#include <cctype>

#include "editor/widgets/buttons.h"
#include "editor/widgets/text_field.h"

namespace patina::editor {
namespace {

std::string lowered(std::string_view words) {
    std::string result(words);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return result;
}

}  // namespace

bool name_matches(std::string_view name, std::string_view search) {
    const std::string where = lowered(name);
    const std::string words = lowered(search);
    std::size_t begin = 0;
    while (begin < words.size()) {
        const std::size_t end = std::min(words.find(' ', begin), words.size());
        if (where.find(words.substr(begin, end - begin)) == std::string::npos) return false;
        begin = end + 1;
    }
    return true;
}

void search_toggle(Ui& ui, const Rect& rect, std::string_view label,
                   std::optional<std::string>& search) {
    if (!icon_button(ui, rect, {.icon = icon::kSearch, .label = label, .on = search.has_value()}))
        return;
    if (search)
        search.reset();
    else
        search.emplace();
}

void name_search(Ui& ui, Rect& rest, std::string_view label, std::string& search) {
    Rect row = rest.cut_top(ui.px(30)).inset(ui.px(10), ui.px(2));
    row.y1 = row.y0 + ui.px(theme::kFieldHeight);
    search_field(ui, row, {.label = label, .hint = "Search names"}, search);
}

}  // namespace patina::editor

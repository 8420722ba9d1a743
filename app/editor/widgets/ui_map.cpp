// SPDX-License-Identifier: MIT
#include "editor/widgets/ui_map.h"

#include <nlohmann/json.hpp>

#include "core/files.h"

namespace patina::editor {
namespace {

nlohmann::ordered_json json_of(const UiMapEntry& entry) {
    const Rect& r = entry.rect;
    return {{"place", entry.place},
            {"label", entry.label},
            {"kind", entry.kind},
            {"value", entry.value},
            {"rect",
             {static_cast<int>(r.x0), static_cast<int>(r.y0), static_cast<int>(r.width()),
              static_cast<int>(r.height())}},
            {"enabled", entry.enabled}};
}

}  // namespace

void UiMap::begin_frame() {
    entries_.clear();
    facts_.clear();
    place_.clear();
}

void UiMap::add(std::string_view label, std::string_view kind, std::string_view value,
                const Rect& visible, bool enabled) {
    if (!file_ || visible.empty()) return;
    std::string place;
    for (const std::string& part : place_) place += (place.empty() ? "" : "/") + part;
    entries_.push_back({std::move(place), std::string(label), std::string(kind), std::string(value),
                        visible, enabled});
}

void UiMap::set_fact(std::string_view name, std::string_view value) {
    if (file_) facts_.push_back({std::string(name), std::string(value)});
}

Status UiMap::end_frame() {
    if (!file_ || (entries_ == written_entries_ && facts_ == written_facts_)) return {};
    written_entries_ = entries_;
    written_facts_ = facts_;
    nlohmann::ordered_json facts = nlohmann::ordered_json::object();
    for (const Fact& fact : facts_) facts[fact.name] = fact.value;
    std::string text = "{\"revision\":" + std::to_string(++revision_) + ",\n\"facts\":";
    constexpr auto kReplace = nlohmann::ordered_json::error_handler_t::replace;
    text += facts.dump(-1, ' ', false, kReplace) + ",\n\"controls\":[";
    for (const UiMapEntry& entry : entries_)
        text += (&entry == entries_.data() ? "\n" : ",\n") +
                json_of(entry).dump(-1, ' ', false, kReplace);
    return write_file_atomically(*file_, text + "\n]}\n");
}

}  // namespace patina::editor

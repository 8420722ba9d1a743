// SPDX-License-Identifier: MIT
#pragma once

/// What is on screen, for tests and scripts (--ui-map): label, kind, value, rectangle and state of
/// every visible control, and facts such as whether work is under way. One JSON file, replaced in
/// one go whenever its content changes, so that a reader waits for what it expects to see.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "editor/widgets/rect.h"

namespace patina::editor {

struct UiMapEntry {
    std::string place;  ///< the panel and row it is in, such as "Layers/Verdigris"
    std::string label;
    std::string kind;   ///< "slider", "button", "combo", "row" ...
    std::string value;  ///< as it is shown; "on" and "off" of switches
    Rect rect;          ///< the visible part, in pixels of the window
    bool enabled = true;
    bool operator==(const UiMapEntry&) const = default;
};

class UiMap {
  public:
    /// Nothing is recorded without a file.
    void write_to(std::optional<std::filesystem::path> file) { file_ = std::move(file); }
    bool is_written() const { return file_.has_value(); }
    void begin_frame();
    void push_place(std::string_view name) { place_.emplace_back(name); }
    void pop_place() { place_.pop_back(); }
    void add(std::string_view label, std::string_view kind, std::string_view value,
             const Rect& visible, bool enabled);
    void set_fact(std::string_view name, std::string_view value);
    /// Writes the file when something differs from what it holds.
    Status end_frame();

  private:
    struct Fact {
        std::string name;
        std::string value;
        bool operator==(const Fact&) const = default;
    };
    std::optional<std::filesystem::path> file_;
    std::vector<std::string> place_;
    std::vector<UiMapEntry> entries_;
    std::vector<Fact> facts_;
    std::vector<UiMapEntry> written_entries_;
    std::vector<Fact> written_facts_;
    int revision_ = 0;
};

}  // namespace patina::editor

// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "editor/widgets/ui.h"

namespace patina::editor {

struct LogLine {
    bool is_warning = false;
    std::string text;
};

/// The lines, newest first, in a region that scrolls.
void draw_log_lines(Ui& ui, const Rect& rect, std::span<const LogLine> log);

}  // namespace patina::editor

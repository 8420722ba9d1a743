// SPDX-License-Identifier: MIT
#pragma once

/// Files dragged from another program and dropped, by the protocol that X11 desktops use (XDND 5).

#include <filesystem>
#include <string>

namespace patina::editor_tests {

/// Drops a file on the window that lies at a point of the screen, where the pointer has to be.
/// False when there is none that takes files or it does not answer within `seconds`.
bool drop_file(const std::string& display, int x, int y, const std::filesystem::path& file,
               int seconds);

}  // namespace patina::editor_tests

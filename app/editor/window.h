// SPDX-License-Identifier: MIT
#pragma once

/// The window, its OpenGL 4.1 core context, and Dear ImGui's back ends. GLFW is used here alone.

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"

namespace patina::editor {

class Window {
  public:
    struct Description {
        int width = 1600;
        int height = 900;
        std::string title;
        /// What the driver finds wrong goes to the log and to the standard error stream, and each
        /// call waits until it is known: for tests.
        bool report_errors = false;
    };
    /// Makes the window with an EGL context where that works, else with the native kind, and makes
    /// it current. Also starts Dear ImGui.
    static Result<Window> open(const Description& description);
    ~Window();
    Window(Window&&) noexcept;
    Window& operator=(Window&&) noexcept;

    /// Waits for something to happen: forever, or for at most `seconds` when that is not negative.
    void wait(double seconds);
    /// Takes what has happened without waiting.
    void poll();
    /// Ends a wait, from any thread.
    static void wake();

    bool close_wanted() const;
    void refuse_close();
    void set_title(const std::string& title);
    /// In screen units, as Description has them.
    std::array<int, 2> size() const;
    /// Of the monitor, for the interface: 1 on ordinary ones.
    float content_scale() const;
    /// Whether input arrived since the last call.
    bool take_input();
    /// Files dropped on the window since the last call, and where in it.
    struct Dropped {
        std::vector<std::filesystem::path> paths;
        float x = 0.0f;
        float y = 0.0f;
    };
    std::vector<Dropped> take_dropped();

    void begin_frame();
    /// Draws what Dear ImGui collected and shows it.
    void end_frame();
    /// After the fonts were replaced.
    void upload_fonts();

  private:
    struct State;
    explicit Window(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace patina::editor

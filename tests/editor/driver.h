// SPDX-License-Identifier: MIT
#pragma once

/// The real program in a window of its own display, worked by mouse and keyboard as a person would,
/// and seen through its --ui-map and its pixels. Nothing here sleeps for a guessed time: every step
/// waits for what it expects to see.

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace patina::editor_tests {

/// Runs a program found along PATH and waits for it; its exit status, -1 when it did not run.
int run_tool(const std::vector<std::string>& words, const std::string& display);

/// An Xvfb on a free display.
class Display {
  public:
    Display(int width, int height);
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;
    /// ":99", or empty when Xvfb is not installed or does not start.
    const std::string& name() const { return name_; }

  private:
    void start_server(int width, int height);
    void end();

    pid_t child_ = -1;
    std::string name_;
};

struct Control {
    std::string place;
    std::string label;
    std::string kind;
    std::string value;
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    bool enabled = true;
};

/// RGB bytes of a part of the screen.
struct Pixels {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
    bool operator==(const Pixels&) const = default;
};
/// The share of pixels whose channels differ by more than `tolerance`.
double different_share(const Pixels& a, const Pixels& b, int tolerance = 2);

/// The viewport without its corners: labels with times above, tools and gizmo at the sides.
Pixels model_part(const Pixels& all);

class Editor {
  public:
    Editor(const std::string& display, const std::filesystem::path& folder,
           const std::vector<std::string>& arguments);
    /// Ends the program. That it met an OpenGL error is a test failure.
    ~Editor();
    Editor(const Editor&) = delete;
    Editor& operator=(const Editor&) = delete;

    /// What the ui-map says now. Facts by name; empty when there is no such fact.
    std::string fact(const std::string& name) const;
    std::vector<Control> controls() const;
    /// The first control whose label and kind are these and whose place begins so.
    std::optional<Control> find(const std::string& place, const std::string& label,
                                const std::string& kind) const;
    /// Rows of the layer list, from the top: "Name".
    std::vector<std::string> layers() const;

    /// Waits until `holds`, as long as the program lives and two minutes have not passed. The
    /// reason for giving up is reported as a test failure that names `what`.
    bool wait_for(const std::string& what, const std::function<bool()>& holds) const;
    /// Waits until all that was done here was taken, and what came of it is done and shown. The
    /// pointer moves by a pixel: the editor takes input in its order and says where the pointer is.
    bool settle() const;
    bool wait_fact(const std::string& name, const std::string& value) const;

    /// Each waits for the control to be there and enabled, then acts on it.
    bool click(const std::string& place, const std::string& label, const std::string& kind) const;
    bool double_click(const std::string& place, const std::string& label,
                      const std::string& kind) const;
    /// With the right button.
    bool open_menu(const std::string& place, const std::string& label,
                   const std::string& kind) const;
    bool drag(const std::string& place, const std::string& label, const std::string& kind,
              double from_share, double to_share) const;
    /// From the middle of one control to the middle of another.
    bool drag_to(const Control& from, const Control& to) const;
    void key(const std::string& keys) const;
    /// Drops a file from another program in the middle of a control.
    bool drop(const std::filesystem::path& file, const std::string& place, const std::string& label,
              const std::string& kind) const;
    void point_at(int x, int y) const;

    /// The viewport's pixels, without pointer-dependent parts: the pointer is put aside first.
    Pixels viewport() const;
    /// Waits for the program to end: its exit status, -1 when it was killed.
    int wait_for_end();

  private:
    void read_map() const;
    bool point_at_control(const std::string& place, const std::string& label,
                          const std::string& kind) const;
    bool settle_at(int x, int y) const;
    bool has_seen_pointer_at(int x, int y) const;

    std::string display_;
    std::filesystem::path map_file_;
    std::filesystem::path screen_file_;
    std::filesystem::path errors_file_;  ///< what the program says on its standard error stream
    pid_t child_ = -1;
    mutable nlohmann::json map_;
    // Not the corner: GLFW takes a move to 0, 0 for one of its own and keeps quiet about it.
    mutable int pointer_x_ = 8;
    mutable int pointer_y_ = 8;
    mutable int settled_times_ = 0;  ///< so that no place is waited at twice in a row
};

}  // namespace patina::editor_tests

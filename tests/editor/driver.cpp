// SPDX-License-Identifier: MIT
#include "editor/driver.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include "editor/drop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <glm/glm.hpp>
#include <iostream>
#include <sstream>

namespace patina::editor_tests {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto kPatience = std::chrono::seconds(120);
/// For a tool that is done in milliseconds, on a machine that is busy.
constexpr auto kToolPatience = std::chrono::seconds(60);
constexpr int kDisplayTries = 3;
constexpr int kPollMs = 15;

/// What a program finds around it beside what is here.
struct Surroundings {
    std::string display;
    std::string settings_folder;  ///< of this test alone
};

std::vector<std::string> environment_with(const Surroundings& around) {
    std::vector<std::string> result;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string_view variable(*entry);
        if (!variable.starts_with("DISPLAY=") && !variable.starts_with("XDG_CONFIG_HOME=") &&
            !variable.starts_with("XDG_CACHE_HOME=") && !variable.starts_with("XDG_DATA_HOME="))
            result.emplace_back(variable);
    }
    if (!around.display.empty()) result.push_back("DISPLAY=" + around.display);
    if (!around.settings_folder.empty()) {
        result.push_back("XDG_CONFIG_HOME=" + around.settings_folder);
        // Shaders and filtered environments are made once for all tests.
        result.push_back("XDG_CACHE_HOME=" PATINA_EDITOR_CACHE);
        result.push_back("XDG_DATA_HOME=" + around.settings_folder);
    }
    return result;
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> result;
    for (std::string& word : words) result.push_back(word.data());
    result.push_back(nullptr);
    return result;
}

pid_t start(std::vector<std::string> words, const Surroundings& around,
            posix_spawn_file_actions_t* actions) {
    std::vector<std::string> environment = environment_with(around);
    const std::vector<char*> argv = pointers_to(words);
    const std::vector<char*> envp = pointers_to(environment);
    pid_t child = -1;
    const int error =
        ::posix_spawnp(&child, words.front().c_str(), actions, nullptr, argv.data(), envp.data());
    return error == 0 ? child : -1;
}

int end_status(pid_t child) {
    int status = 0;
    if (::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
    return WEXITSTATUS(status);
}

void pause_briefly() {
    ::poll(nullptr, 0, kPollMs);
}

bool has_ended(pid_t child) {
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == child;
}

bool ends_within(pid_t child, std::chrono::seconds patience) {
    for (const auto until = Clock::now() + patience; !has_ended(child); pause_briefly())
        if (Clock::now() > until) return false;
    return true;
}

std::string sentence(const std::vector<std::string>& words) {
    std::string result;
    for (const std::string& word : words) result += (result.empty() ? "" : " ") + word;
    return result;
}

/// What Xvfb says of its display: its number and a line break, when it takes clients. Empty when it
/// has not said so in time.
std::string number_from(int pipe_end) {
    std::string number;
    pollfd waited{pipe_end, POLLIN, 0};
    char letter = 0;
    while (::poll(&waited, 1, static_cast<int>(std::chrono::milliseconds(kToolPatience).count())) >
               0 &&
           ::read(pipe_end, &letter, 1) == 1) {
        if (letter == '\n') return number;
        number += letter;
    }
    return {};
}

}  // namespace

int run_tool(const std::vector<std::string>& words, const std::string& display) {
    const pid_t child = start(words, {display, {}}, nullptr);
    if (child < 0) return -1;
    if (!ends_within(child, kToolPatience)) {
        ADD_FAILURE() << "'" << sentence(words) << "' did not end";
        ::kill(child, SIGKILL);
    }
    return end_status(child);
}

Display::Display(int width, int height) {
    for (int i = 0; i < kDisplayTries && name_.empty(); ++i) {
        end();
        start_server(width, height);
    }
}

void Display::start_server(int width, int height) {
    int ends[2] = {-1, -1};
    if (::pipe(ends) != 0) return;
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addclose(&actions, ends[0]);
    child_ =
        start({"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0",
               std::to_string(width) + "x" + std::to_string(height) + "x24", "-nolisten", "tcp"},
              {}, &actions);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    const std::string number = child_ > 0 ? number_from(ends[0]) : std::string();
    ::close(ends[0]);
    if (!number.empty()) name_ = ":" + number;
}

void Display::end() {
    if (child_ <= 0) return;
    ::kill(child_, SIGTERM);
    if (!ends_within(child_, kToolPatience)) ::kill(child_, SIGKILL);
    end_status(child_);
    child_ = -1;
}

Display::~Display() {
    end();
}

Pixels model_part(const Pixels& all) {
    const int left = all.width / 10;
    const int top = 60;
    const int bottom = 60;
    if (all.height <= top + bottom) return {};
    Pixels part{all.width - 2 * left, all.height - top - bottom, {}};
    for (int y = 0; y < part.height; ++y) {
        const auto row = all.rgb.begin() + ((y + top) * all.width + left) * 3;
        part.rgb.insert(part.rgb.end(), row, row + part.width * 3);
    }
    return part;
}

double different_share(const Pixels& a, const Pixels& b, int tolerance) {
    if (a.width != b.width || a.height != b.height || a.rgb.empty()) return 1.0;
    std::size_t different = 0;
    for (std::size_t i = 0; i + 2 < a.rgb.size(); i += 3) {
        int most = 0;
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(int{a.rgb[i + c]} - int{b.rgb[i + c]}));
        different += most > tolerance ? 1 : 0;
    }
    return static_cast<double>(different) * 3.0 / static_cast<double>(a.rgb.size());
}

Editor::Editor(const std::string& display, const fs::path& folder,
               const std::vector<std::string>& arguments)
    : display_(display),
      map_file_(folder / "ui.json"),
      screen_file_(folder / "screen.rgb"),
      errors_file_(folder / "errors.txt") {
    fs::remove(map_file_);
    std::vector<std::string> words = {PATINA_PROGRAM, "--ui-map", map_file_.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors_file_.c_str(),
                                       O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0600);
    child_ = start(words, {display, (folder / "settings").string()}, &actions);
    ::posix_spawn_file_actions_destroy(&actions);
}

Editor::~Editor() {
    if (child_ > 0) {
        ::kill(child_, SIGKILL);
        end_status(child_);
    }
    std::ifstream file(errors_file_);
    for (std::string line; std::getline(file, line);) {
        EXPECT_EQ(line.find("OpenGL: "), std::string::npos) << line;
        std::cerr << line << '\n';
    }
}

void Editor::read_map() const {
    std::ifstream file(map_file_);
    nlohmann::json map = nlohmann::json::parse(file, nullptr, false);
    if (!map.is_discarded()) map_ = std::move(map);
}

std::string Editor::fact(const std::string& name) const {
    read_map();
    if (!map_.contains("facts")) return {};
    return map_["facts"].value(name, "");
}

std::vector<Control> Editor::controls() const {
    read_map();
    std::vector<Control> result;
    if (!map_.contains("controls")) return result;
    for (const auto& entry : map_["controls"]) {
        const auto& rect = entry["rect"];
        result.push_back({.place = entry["place"],
                          .label = entry["label"],
                          .kind = entry["kind"],
                          .value = entry["value"],
                          .x = rect[0],
                          .y = rect[1],
                          .width = rect[2],
                          .height = rect[3],
                          .enabled = entry["enabled"]});
    }
    return result;
}

std::optional<Control> Editor::find(const std::string& place, const std::string& label,
                                    const std::string& kind) const {
    for (const Control& control : controls())
        if (control.place.starts_with(place) && control.label == label && control.kind == kind)
            return control;
    return std::nullopt;
}

std::vector<std::string> Editor::layers() const {
    std::vector<std::string> result;
    for (const Control& control : controls())
        if (control.place.starts_with("Layers/") && control.kind == "row")
            result.push_back(control.label);
    return result;
}

bool Editor::wait_for(const std::string& what, const std::function<bool()>& holds) const {
    const auto until = Clock::now() + kPatience;
    while (!holds()) {
        if (has_ended(child_)) {
            ADD_FAILURE() << "the editor ended while waiting for " << what;
            return false;
        }
        if (Clock::now() > until) {
            ADD_FAILURE() << "waited in vain for " << what
                          << "; facts: " << map_.value("facts", nlohmann::json()).dump();
            return false;
        }
        pause_briefly();
    }
    return true;
}

bool Editor::has_seen_pointer_at(int x, int y) const {
    return fact("pointer") == std::to_string(x) + " " + std::to_string(y);
}

bool Editor::settle() const {
    return settle_at(pointer_x_ ^ (1 + ++settled_times_ % 3), pointer_y_);
}

bool Editor::settle_at(int x, int y) const {
    // What the map says of that place must not be left from an earlier visit, when the program has
    // yet to see what was done since.
    while ((x == pointer_x_ && y == pointer_y_) || has_seen_pointer_at(x, y)) ++x;
    point_at(x, y);
    return wait_for("all to be done and shown",
                    [&] { return has_seen_pointer_at(x, y) && fact("settled") == "yes"; });
}

bool Editor::wait_fact(const std::string& name, const std::string& value) const {
    return wait_for(name + " = " + value, [&] { return fact(name) == value; });
}

void Editor::point_at(int x, int y) const {
    pointer_x_ = x;
    pointer_y_ = y;
    run_tool({"xdotool", "mousemove", std::to_string(x), std::to_string(y)}, display_);
}

bool Editor::point_at_control(const std::string& place, const std::string& label,
                              const std::string& kind) const {
    // A menu grows to its widest row in its first frames, and what is typed moves the rows of a
    // list: it is pointed at only when the program, having seen the pointer there, still draws it
    // there.
    return wait_for(place + " / " + label + " (" + kind + ")", [&] {
        const std::optional<Control> control = find(place, label, kind);
        if (!control || !control->enabled) return false;
        const int x = control->x + control->width / 2;
        const int y = control->y + control->height / 2;
        if (x != pointer_x_ || y != pointer_y_) point_at(x, y);
        pause_briefly();
        const std::optional<Control> seen = find(place, label, kind);
        return has_seen_pointer_at(x, y) && seen && seen->x == control->x && seen->y == control->y;
    });
}

bool Editor::open_menu(const std::string& place, const std::string& label,
                       const std::string& kind) const {
    if (!point_at_control(place, label, kind)) return false;
    run_tool({"xdotool", "click", "3"}, display_);
    return true;
}

bool Editor::click(const std::string& place, const std::string& label,
                   const std::string& kind) const {
    if (!point_at_control(place, label, kind)) return false;
    run_tool({"xdotool", "click", "1"}, display_);
    if (kind != "item") return true;
    // What lies behind a menu is out of reach until it is gone, or another has taken its place.
    return wait_for("the menu to close", [&] { return !find(place, label, kind).has_value(); });
}

bool Editor::double_click(const std::string& place, const std::string& label,
                          const std::string& kind) const {
    if (!point_at_control(place, label, kind)) return false;
    run_tool({"xdotool", "click", "--repeat", "2", "--delay", "60", "1"}, display_);
    return true;
}

bool Editor::drag(const std::string& place, const std::string& label, const std::string& kind,
                  double from_share, double to_share) const {
    if (!wait_for(label, [&] { return find(place, label, kind).has_value(); })) return false;
    const Control control = *find(place, label, kind);
    const auto at = [&](double share) {
        return control.x + static_cast<int>(std::lround(share * control.width));
    };
    const int y = control.y + control.height / 2;
    point_at(at(from_share), y);
    run_tool({"xdotool", "mousedown", "1"}, display_);
    for (int step = 1; step <= 8; ++step)
        point_at(at(from_share + (to_share - from_share) * step / 8.0), y);
    run_tool({"xdotool", "mouseup", "1"}, display_);
    return true;
}

bool Editor::drag_to(const Control& from, const Control& to) const {
    const auto middle = [](const Control& control) {
        return glm::ivec2(control.x + control.width / 2, control.y + control.height / 2);
    };
    const glm::ivec2 start = middle(from);
    if (!settle_at(start.x, start.y)) return false;
    run_tool({"xdotool", "mousedown", "1"}, display_);
    for (int step = 1; step <= 8; ++step) {
        const glm::ivec2 at = start + (middle(to) - start) * step / 8;
        point_at(at.x, at.y);
    }
    run_tool({"xdotool", "mouseup", "1"}, display_);
    return true;
}

bool Editor::drop(const fs::path& file, const std::string& place, const std::string& label,
                  const std::string& kind) const {
    if (!wait_for(label, [&] { return find(place, label, kind).has_value(); })) return false;
    const Control control = *find(place, label, kind);
    const int x = control.x + control.width / 2;
    const int y = control.y + control.height / 2;
    if (!settle_at(x, y)) return false;
    return drop_file(display_, x, y, file, static_cast<int>(kPatience.count()));
}

void Editor::key(const std::string& keys) const {
    run_tool({"xdotool", "key", keys}, display_);
}

Pixels Editor::viewport() const {
    std::istringstream rect(fact("viewport"));
    int x = 0;
    int y = 0;
    Pixels pixels;
    rect >> x >> y >> pixels.width >> pixels.height;
    settle_at(x + pixels.width / 2 + ++settled_times_ % 32, 20);
    std::ostringstream crop;
    crop << pixels.width << 'x' << pixels.height << '+' << x << '+' << y;
    run_tool({"import", "-silent", "-window", "root", "-crop", crop.str(), "-depth", "8",
              "rgb:" + screen_file_.string()},
             display_);
    std::ifstream file(screen_file_, std::ios::binary);
    pixels.rgb.assign(std::istreambuf_iterator<char>(file), {});
    return pixels;
}

int Editor::wait_for_end() {
    if (!ends_within(child_, kPatience)) return -1;
    const int status = end_status(child_);
    child_ = -1;
    return status;
}

}  // namespace patina::editor_tests

// SPDX-License-Identifier: MIT
#include "editor/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cstdio>
#include <deque>
#include <optional>
#include <utility>
#include <variant>

#include "core/log.h"
#include "render/window_target.h"

namespace patina::editor {

namespace {

/// Something that the hand did and that has not been given to Dear ImGui yet.
struct KeyChange {
    int key = 0;
    int scancode = 0;
    int action = 0;
    int modifiers = 0;
};
struct Letter {
    unsigned codepoint = 0;
};
struct PointerMove {
    ImVec2 position;
};
struct ButtonChange {
    int button = 0;
    bool down = false;
};
using HandEvent = std::variant<KeyChange, Letter, PointerMove, ButtonChange>;

/// The pointer as far as Dear ImGui has been told.
struct Pointer {
    ImVec2 position = ImVec2(-FLT_MAX, -FLT_MAX);
    std::array<bool, ImGuiMouseButton_COUNT> down = {};
};

/// What GLFW's callbacks find through the window.
struct Events {
    bool input = true;
    std::vector<Window::Dropped> dropped;
    std::deque<HandEvent> hand;
    Pointer pointer;
};

}  // namespace

struct Window::State {
    GLFWwindow* handle = nullptr;
    Events events;
    std::optional<render::WindowErrors> errors;

    ~State() {
        errors.reset();
        if (ImGui::GetCurrentContext() != nullptr) {
            ImGui_ImplOpenGL3_Shutdown();
            ImGui_ImplGlfw_Shutdown();
            ImGui::DestroyContext();
        }
        if (handle != nullptr) glfwDestroyWindow(handle);
        glfwTerminate();
    }
};

namespace {

std::string last_error() {
    const char* words = nullptr;
    glfwGetError(&words);
    return quoted_for_message(words == nullptr ? "no reason given" : words);
}

GLFWwindow* try_window(const Window::Description& description, int context_api) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, context_api);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, description.report_errors ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    return glfwCreateWindow(description.width, description.height, description.title.c_str(),
                            nullptr, nullptr);
}

void report_gl_error(std::string_view message) {
    const std::string line = fmt::format("OpenGL: {}", message);
    log_line(LogLevel::Error, line);
    fmt::print(stderr, "patina: {}\n", line);
}

Events& events_of(GLFWwindow* handle) {
    return *static_cast<Events*>(glfwGetWindowUserPointer(handle));
}

void mark_input(GLFWwindow* handle) {
    events_of(handle).input = true;
}

void push(GLFWwindow* handle, const HandEvent& event) {
    mark_input(handle);
    events_of(handle).hand.push_back(event);
}

/// Pointer, buttons and keys go to Dear ImGui in their order, by feed().
void install_callbacks(GLFWwindow* handle) {
    glfwSetCursorPosCallback(handle, [](GLFWwindow* w, double x, double y) {
        push(w, PointerMove{ImVec2(static_cast<float>(x), static_cast<float>(y))});
    });
    glfwSetMouseButtonCallback(handle, [](GLFWwindow* w, int button, int action, int) {
        if (button < ImGuiMouseButton_COUNT) push(w, ButtonChange{button, action == GLFW_PRESS});
    });
    glfwSetScrollCallback(handle, [](GLFWwindow* w, double x, double y) {
        mark_input(w);
        ImGui_ImplGlfw_ScrollCallback(w, x, y);
    });
    glfwSetKeyCallback(handle, [](GLFWwindow* w, int key, int code, int action, int modifiers) {
        push(w, KeyChange{key, code, action, modifiers});
    });
    glfwSetCharCallback(handle, [](GLFWwindow* w, unsigned letter) { push(w, Letter{letter}); });
    glfwSetCursorEnterCallback(handle, [](GLFWwindow* w, int entered) {
        if (entered == GLFW_FALSE) push(w, PointerMove{ImVec2(-FLT_MAX, -FLT_MAX)});
        ImGui_ImplGlfw_CursorEnterCallback(w, entered);
    });
    glfwSetWindowFocusCallback(handle, [](GLFWwindow* w, int focused) {
        mark_input(w);
        ImGui_ImplGlfw_WindowFocusCallback(w, focused);
    });
    glfwSetFramebufferSizeCallback(handle, [](GLFWwindow* w, int, int) { mark_input(w); });
    glfwSetWindowRefreshCallback(handle, [](GLFWwindow* w) { mark_input(w); });
    glfwSetWindowCloseCallback(handle, [](GLFWwindow* w) { mark_input(w); });
    glfwSetDropCallback(handle, [](GLFWwindow* w, int count, const char** paths) {
        double x = 0.0;
        double y = 0.0;
        glfwGetCursorPos(w, &x, &y);
        events_of(w).dropped.push_back({std::vector<std::filesystem::path>(paths, paths + count),
                                        static_cast<float>(x), static_cast<float>(y)});
        mark_input(w);
    });
}

constexpr float kDoubleClickSeconds = 0.4f;

/// What one frame has been given so far.
struct FrameInput {
    bool moved = false;
    bool button_changed = false;
    bool key_changed = false;
    bool key_pressed = false;  ///< one that is no modifier
    std::vector<int> buttons;
    std::vector<int> keys;
};

bool is_modifier(int key) {
    return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
}

/// Whether the event may follow what the frame has: nothing may change twice, the pointer stays
/// where a button changed, the end of a drag is seen before the button goes up, a key is of another
/// frame than a click before or after it, and the modifiers stay as they were when a key went down.
bool fits(const HandEvent& event, const FrameInput& frame) {
    const auto among = [](const std::vector<int>& changed, int one) {
        return std::find(changed.begin(), changed.end(), one) != changed.end();
    };
    if (const auto* button = std::get_if<ButtonChange>(&event))
        return !frame.key_changed && !among(frame.buttons, button->button) &&
               (button->down || !frame.moved);
    if (const auto* key = std::get_if<KeyChange>(&event))
        return !frame.button_changed && !among(frame.keys, key->key) &&
               !(frame.key_pressed && (key->action == GLFW_RELEASE || is_modifier(key->key)));
    return !frame.button_changed;
}

void give(GLFWwindow* handle, const HandEvent& event, Pointer& pointer, FrameInput& frame) {
    if (const auto* move = std::get_if<PointerMove>(&event)) {
        pointer.position = move->position;
        frame.moved = true;
    }
    if (const auto* button = std::get_if<ButtonChange>(&event)) {
        pointer.down[static_cast<std::size_t>(button->button)] = button->down;
        frame.button_changed = true;
        frame.buttons.push_back(button->button);
    }
    if (const auto* key = std::get_if<KeyChange>(&event)) {
        ImGui_ImplGlfw_KeyCallback(handle, key->key, key->scancode, key->action, key->modifiers);
        frame.key_changed = true;
        frame.key_pressed |= key->action != GLFW_RELEASE && !is_modifier(key->key);
        frame.keys.push_back(key->key);
    }
    if (const auto* letter = std::get_if<Letter>(&event))
        ImGui_ImplGlfw_CharCallback(handle, letter->codepoint);
}

/// Dear ImGui 1.86 sees pointer and keys only as they are when a frame begins: in a slow frame a
/// click, a drag or a key would be lost or come in the wrong order. So a frame gets as much as it
/// can tell apart, and the next one the rest.
void feed(GLFWwindow* handle, Events& events) {
    FrameInput frame;
    while (!events.hand.empty() && fits(events.hand.front(), frame)) {
        give(handle, events.hand.front(), events.pointer, frame);
        events.hand.pop_front();
    }
    ImGuiIO& io = ImGui::GetIO();
    // Press, release, press and release are four frames: slow ones must not part a double click.
    io.MouseDoubleClickTime = std::min(kDoubleClickSeconds + 4.0f * io.DeltaTime, 1.5f);
    io.MousePos = events.pointer.position;
    std::copy(events.pointer.down.begin(), events.pointer.down.end(), io.MouseDown);
}

}  // namespace

Window::Window(std::unique_ptr<State> state) : state_(std::move(state)) {}
Window::~Window() = default;
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;

Result<Window> Window::open(const Description& description) {
    if (glfwInit() == GLFW_FALSE)
        return failure("no window: {}; `patina bake` and `patina render` need none", last_error());
    auto state = std::make_unique<State>();
    state->handle = try_window(description, GLFW_EGL_CONTEXT_API);
    if (state->handle == nullptr) state->handle = try_window(description, GLFW_NATIVE_CONTEXT_API);
    if (state->handle == nullptr)
        return failure("no window with OpenGL 4.1: {}; update the graphics driver", last_error());
    glfwMakeContextCurrent(state->handle);
    if (description.report_errors) state->errors.emplace(report_gl_error);
    glfwSwapInterval(1);
    glfwSetWindowSizeLimits(state->handle, 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetWindowUserPointer(state->handle, &state->events);
    install_callbacks(state->handle);
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    if (!ImGui_ImplGlfw_InitForOpenGL(state->handle, false) ||
        !ImGui_ImplOpenGL3_Init("#version 410 core"))
        return failure("Dear ImGui did not start on this OpenGL; update the graphics driver");
    return Window(std::move(state));
}

void Window::wait(double seconds) {
    if (seconds < 0.0)
        glfwWaitEvents();
    else if (seconds > 0.0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
}

void Window::poll() {
    glfwPollEvents();
}

void Window::wake() {
    glfwPostEmptyEvent();
}

bool Window::close_wanted() const {
    return glfwWindowShouldClose(state_->handle) != GLFW_FALSE;
}

void Window::refuse_close() {
    glfwSetWindowShouldClose(state_->handle, GLFW_FALSE);
}

void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(state_->handle, title.c_str());
}

std::array<int, 2> Window::size() const {
    std::array<int, 2> size{};
    glfwGetWindowSize(state_->handle, size.data(), &size[1]);
    return size;
}

float Window::content_scale() const {
    float x = 1.0f;
    float y = 1.0f;
    glfwGetWindowContentScale(state_->handle, &x, &y);
    return x > y ? x : y;
}

bool Window::take_input() {
    return std::exchange(state_->events.input, false) || !state_->events.hand.empty();
}

std::vector<Window::Dropped> Window::take_dropped() {
    return std::exchange(state_->events.dropped, {});
}

void Window::begin_frame() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    feed(state_->handle, state_->events);
    ImGui::NewFrame();
}

void Window::end_frame() {
    ImGui::Render();
    render::draw_to_window();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (state_->errors) state_->errors->poll();
    glfwSwapBuffers(state_->handle);
}

void Window::upload_fonts() {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

}  // namespace patina::editor

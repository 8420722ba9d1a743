// SPDX-License-Identifier: MIT
#include "editor/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <deque>
#include <utility>

#include "render/window_target.h"

namespace patina::editor {

namespace {

/// A key or a letter that has not been given to Dear ImGui yet.
struct Typed {
    int key = 0;
    int scancode = 0;
    int action = 0;
    int modifiers = 0;
    unsigned letter = 0;  ///< set: a letter, not a key
};

/// What GLFW's callbacks find through the window.
struct Events {
    bool input = true;
    std::vector<std::filesystem::path> dropped;
    std::deque<Typed> typed;
};

}  // namespace

struct Window::State {
    GLFWwindow* handle = nullptr;
    Events events;

    ~State() {
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
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    return glfwCreateWindow(description.width, description.height, description.title.c_str(),
                            nullptr, nullptr);
}

Events& events_of(GLFWwindow* handle) {
    return *static_cast<Events*>(glfwGetWindowUserPointer(handle));
}

void mark_input(GLFWwindow* handle) {
    events_of(handle).input = true;
}

/// The pointer goes to Dear ImGui at once, keys and letters by feed_typed().
void install_callbacks(GLFWwindow* handle) {
    glfwSetCursorPosCallback(handle, [](GLFWwindow* w, double, double) { mark_input(w); });
    glfwSetMouseButtonCallback(handle, [](GLFWwindow* w, int button, int action, int modifiers) {
        mark_input(w);
        ImGui_ImplGlfw_MouseButtonCallback(w, button, action, modifiers);
    });
    glfwSetScrollCallback(handle, [](GLFWwindow* w, double x, double y) {
        mark_input(w);
        ImGui_ImplGlfw_ScrollCallback(w, x, y);
    });
    glfwSetKeyCallback(handle, [](GLFWwindow* w, int key, int code, int action, int modifiers) {
        mark_input(w);
        events_of(w).typed.push_back({key, code, action, modifiers, 0});
    });
    glfwSetCharCallback(handle, [](GLFWwindow* w, unsigned letter) {
        mark_input(w);
        events_of(w).typed.push_back({.letter = letter});
    });
    glfwSetCursorEnterCallback(handle, [](GLFWwindow* w, int entered) {
        mark_input(w);
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
        for (int i = 0; i < count; ++i) events_of(w).dropped.emplace_back(paths[i]);
        mark_input(w);
    });
}

/// Dear ImGui 1.86 sees keys only as they are when a frame begins: one that went down and up since
/// the last frame would be lost. So a frame gets what was typed up to the second change of one key.
void feed_typed(GLFWwindow* handle, std::deque<Typed>& typed) {
    std::vector<int> changed;
    while (!typed.empty()) {
        const Typed next = typed.front();
        if (next.letter != 0) {
            ImGui_ImplGlfw_CharCallback(handle, next.letter);
        } else {
            if (std::find(changed.begin(), changed.end(), next.key) != changed.end()) return;
            changed.push_back(next.key);
            ImGui_ImplGlfw_KeyCallback(handle, next.key, next.scancode, next.action,
                                       next.modifiers);
        }
        typed.pop_front();
    }
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

float Window::content_scale() const {
    float x = 1.0f;
    float y = 1.0f;
    glfwGetWindowContentScale(state_->handle, &x, &y);
    return x > y ? x : y;
}

bool Window::take_input() {
    return std::exchange(state_->events.input, false) || !state_->events.typed.empty();
}

std::vector<std::filesystem::path> Window::take_dropped() {
    return std::exchange(state_->events.dropped, {});
}

void Window::begin_frame() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    feed_typed(state_->handle, state_->events.typed);
    ImGui::NewFrame();
}

void Window::end_frame() {
    ImGui::Render();
    render::draw_to_window();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(state_->handle);
}

void Window::upload_fonts() {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

}  // namespace patina::editor

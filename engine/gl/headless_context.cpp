// SPDX-License-Identifier: MIT
#include "gl/headless_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace patina::gl {

struct HeadlessContext::Parts {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    std::optional<DebugOutput> debug_output;

    Parts(EGLDisplay on_display, EGLContext of_context)
        : display(on_display), context(of_context) {}
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts() {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
        debug_output.reset();
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        // The display is not terminated: EGL hands the same one to every context of the process.
        eglDestroyContext(display, context);
    }
};

namespace {

bool has_client_extension(std::string_view name) {
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    return extensions != nullptr &&
           std::string_view(extensions).find(name) != std::string_view::npos;
}

EGLDisplay surfaceless_display() {
    if (!has_client_extension("EGL_EXT_platform_base") ||
        !has_client_extension("EGL_MESA_platform_surfaceless"))
        return EGL_NO_DISPLAY;
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
}

std::vector<EGLDeviceEXT> devices() {
    if (!has_client_extension("EGL_EXT_platform_base") ||
        !has_client_extension("EGL_EXT_platform_device") ||
        !has_client_extension("EGL_EXT_device_enumeration"))
        return {};
    EGLint count = 0;
    if (!eglQueryDevicesEXT(0, nullptr, &count) || count < 1) return {};
    std::vector<EGLDeviceEXT> found(static_cast<std::size_t>(count));
    if (!eglQueryDevicesEXT(count, found.data(), &count)) return {};
    found.resize(static_cast<std::size_t>(count));
    return found;
}

/// A core context of OpenGL 4.1 that needs no surface; EGL_NO_CONTEXT when the display has none.
EGLContext context_of(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) ||
        !eglBindAPI(EGL_OPENGL_API) ||
        !epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context") ||
        !epoxy_has_egl_extension(display, "EGL_KHR_create_context"))
        return EGL_NO_CONTEXT;

    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1) {
        if (!epoxy_has_egl_extension(display, "EGL_KHR_no_config_context")) return EGL_NO_CONTEXT;
        config = EGL_NO_CONFIG_KHR;
    }
    const EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION_KHR,
        4,
        EGL_CONTEXT_MINOR_VERSION_KHR,
        1,
        EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
        EGL_CONTEXT_FLAGS_KHR,
        EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE_BIT_KHR | EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR,
        EGL_NONE};
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT) return EGL_NO_CONTEXT;
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        eglDestroyContext(display, context);
        return EGL_NO_CONTEXT;
    }
    return context;
}

}  // namespace

HeadlessContext::HeadlessContext(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
HeadlessContext::HeadlessContext(HeadlessContext&&) noexcept = default;
HeadlessContext& HeadlessContext::operator=(HeadlessContext&&) noexcept = default;
HeadlessContext::~HeadlessContext() = default;

Result<HeadlessContext> HeadlessContext::make(ErrorCallback on_error) {
    EGLDisplay display = surfaceless_display();
    EGLContext context = context_of(display);
    if (context == EGL_NO_CONTEXT)
        for (EGLDeviceEXT device : devices()) {
            display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
            context = context_of(display);
            if (context != EGL_NO_CONTEXT) break;
        }
    if (context == EGL_NO_CONTEXT)
        return failure(
            "no OpenGL 4.1 without a window: EGL offers neither Mesa's surfaceless platform nor a "
            "device with it; install Mesa's drivers (Debian: libegl1 libgl1-mesa-dri)");
    auto parts = std::make_unique<Parts>(display, context);
    parts->debug_output.emplace(std::move(on_error));
    return HeadlessContext(std::move(parts));
}

const DebugOutput& HeadlessContext::debug_output() const {
    return *parts_->debug_output;
}

}  // namespace patina::gl

// SPDX-License-Identifier: MIT
#pragma once

/// What the driver reports: errors to a callback, and groups that name the passes in a capture.

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace patina::gl {

/// Whether the current context has KHR_debug: labels, groups and messages.
bool has_debug_output();

/// Called with one line of text for each OpenGL error and each message of high severity.
using ErrorCallback = std::function<void(std::string_view message)>;

/// Reports the current context's errors to a callback while it lives: at the call that makes them
/// where the context has KHR_debug, otherwise at poll(). Tests fail on any report.
class DebugOutput {
  public:
    explicit DebugOutput(ErrorCallback on_error);
    ~DebugOutput();
    DebugOutput(const DebugOutput&) = delete;
    DebugOutput& operator=(const DebugOutput&) = delete;

    /// Reports what glGetError has; call it once a frame.
    void poll() const;

  private:
    ErrorCallback on_error_;
};

/// A named group of commands in a capture, from construction to destruction.
class DebugGroup {
  public:
    explicit DebugGroup(std::string_view label);
    ~DebugGroup();
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
};

/// "VENDOR, RENDERER, VERSION" of the current context, for logs, tests and bug reports.
std::string renderer_description();

}  // namespace patina::gl

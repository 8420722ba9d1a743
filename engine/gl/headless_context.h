// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "core/result.h"
#include "gl/debug.h"

namespace patina::gl {

/// An OpenGL 4.1 core context without a window or display: EGL on Mesa's surfaceless platform, else
/// on the first EGL device that has one. It is current on the thread that makes it.
class HeadlessContext {
  public:
    /// `on_error` hears of every OpenGL error and message of high severity.
    static Result<HeadlessContext> make(ErrorCallback on_error);
    HeadlessContext(HeadlessContext&&) noexcept;
    HeadlessContext& operator=(HeadlessContext&&) noexcept;
    ~HeadlessContext();

    const DebugOutput& debug_output() const;

  private:
    struct Parts;
    explicit HeadlessContext(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace patina::gl

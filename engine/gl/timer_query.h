// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "gl/object.h"

namespace patina::gl {

/// GPU time between begin() and end(). Only one timer can run at a time.
class TimerQuery {
  public:
    static TimerQuery make(std::string_view label);
    void begin();
    void end();
    /// The last measured time; nothing while the GPU is not done. Never waits.
    std::optional<double> elapsed_ms() const;

  private:
    bool ended_ = false;
    Object object_;
};

}  // namespace patina::gl

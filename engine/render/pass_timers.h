// SPDX-License-Identifier: MIT
#pragma once

/// GPU time of each pass, without ever waiting for the GPU: what is reported is the last
/// measurement that has ended.

#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "gl/timer_query.h"
#include "render/renderer.h"

namespace patina::render {

/// What a pass is drawn for.
enum class FrameSide { Shared, Left, Right };

class PassTimers {
  public:
    /// Measures from construction to destruction. One at a time.
    class Scope {
      public:
        explicit Scope(gl::TimerQuery* query) : query_(query) {
            if (query_ != nullptr) query_->begin();
        }
        ~Scope() {
            if (query_ != nullptr) query_->end();
        }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        gl::TimerQuery* query_;
    };

    /// While one lives nothing is measured, and the frame before is still the one reported.
    class Pause {
      public:
        explicit Pause(PassTimers& timers) : timers_(timers) { timers_.paused_ = true; }
        ~Pause() { timers_.paused_ = false; }
        Pause(const Pause&) = delete;
        Pause& operator=(const Pause&) = delete;

      private:
        PassTimers& timers_;
    };

    /// Forgets which passes the frame before had.
    void begin_frame() { frame_ += paused_ ? 0 : 1; }
    /// @param name  a literal: it is kept
    Scope measure(FrameSide side, std::string_view name);

    /// The passes of this frame that served a side, shared ones first.
    std::vector<PassCost> costs(FrameSide side);

  private:
    struct Timer {
        gl::TimerQuery query;
        bool pending = false;
        double last_ms = 0.0;
        long frame = 0;
        int order = 0;
    };
    void collect(Timer& timer);

    std::map<std::pair<FrameSide, std::string_view>, Timer> timers_;
    long frame_ = 0;
    int passes_ = 0;
    bool paused_ = false;
};

}  // namespace patina::render

// SPDX-License-Identifier: MIT
#pragma once

/// Progress and cancellation of long work, shared between the worker that does it and whoever
/// watches. Anything that can take half a second takes a Progress.

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace patina {

/// A handle; copies share one state. All functions may be called from any thread.
class Progress {
  public:
    Progress() : state_(std::make_shared<State>()) {}

    /// Worker: `fraction` of the whole that is done, 0 to 1.
    void report(float fraction) const {
        state_->fraction.store(fraction, std::memory_order_relaxed);
    }
    /// Worker: what is being done now, such as "Baking 4 maps at 4096".
    void set_stage(std::string_view stage) const {
        const std::lock_guard lock(state_->stage_mutex);
        state_->stage = stage;
    }
    /// Worker: whether to stop soon and return a failure that says "cancelled".
    bool cancelled() const { return state_->cancelled.load(std::memory_order_relaxed); }

    /// Watcher: asks the worker to stop.
    void cancel() const { state_->cancelled.store(true, std::memory_order_relaxed); }
    float fraction() const { return state_->fraction.load(std::memory_order_relaxed); }
    std::string stage() const {
        const std::lock_guard lock(state_->stage_mutex);
        return state_->stage;
    }

  private:
    struct State {
        std::atomic<float> fraction = 0.0f;
        std::atomic<bool> cancelled = false;
        std::mutex stage_mutex;
        std::string stage;
    };
    std::shared_ptr<State> state_;
};

}  // namespace patina

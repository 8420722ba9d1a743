// SPDX-License-Identifier: MIT
#pragma once

/// Long work on threads of its own, with progress and cancellation. The work returns a delivery,
/// which runs on the thread that draws: values come back, nothing is shared while it runs.

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/progress.h"
#include "editor/state/shown.h"

namespace patina::editor {

class Jobs {
  public:
    using Delivery = std::function<void()>;
    using Work = std::function<Delivery(const Progress&)>;

    /// @param wake  called from the worker when a delivery is ready
    explicit Jobs(std::function<void()> wake) : wake_(std::move(wake)) {}
    /// Cancels what runs and waits for it.
    ~Jobs();
    Jobs(const Jobs&) = delete;
    Jobs& operator=(const Jobs&) = delete;

    int start(std::string stage, Work work);
    void cancel(int id);
    /// Runs the deliveries of what has ended.
    void deliver();
    bool running() const { return !jobs_.empty(); }
    std::vector<JobShown> shown() const;

  private:
    struct Job {
        int id = 0;
        std::string stage;
        Progress progress;
        std::chrono::steady_clock::time_point begun;
        std::atomic<bool> done = false;
        Delivery delivery;
        std::thread thread;
    };
    std::function<void()> wake_;
    std::vector<std::unique_ptr<Job>> jobs_;
    int next_id_ = 1;
};

}  // namespace patina::editor

// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <csignal>
#include <mutex>
#include <thread>

#include "core/progress.h"

namespace patina::cli {

/// While it lives: shows how far the work has come, when the standard error stream is a terminal
/// and `shown`; and turns the first Ctrl-C into a request to stop, so that nothing half-made is
/// left behind (a second one ends the program at once). One at a time.
class ProgressBar {
  public:
    ProgressBar(Progress progress, bool shown);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

  private:
    void watch();
    void draw() const;

    Progress progress_;
    bool shown_;
    struct sigaction before_ = {};
    std::mutex mutex_;
    std::condition_variable ended_changed_;
    bool ended_ = false;
    std::thread watcher_;  // last: it uses all the others
};

}  // namespace patina::cli

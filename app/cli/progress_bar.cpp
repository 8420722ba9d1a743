// SPDX-License-Identifier: MIT
#include "cli/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string>

namespace patina::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void on_interrupt(int /*signal*/) {
    interrupted = 1;
}

}  // namespace

ProgressBar::ProgressBar(Progress progress, bool shown)
    : progress_(std::move(progress)), shown_(shown && ::isatty(STDERR_FILENO) != 0) {
    interrupted = 0;
    struct sigaction action = {};
    action.sa_handler = on_interrupt;
    action.sa_flags = static_cast<int>(SA_RESETHAND);  // the second Ctrl-C is the system's own
    ::sigaction(SIGINT, &action, &before_);
    watcher_ = std::thread([this] { watch(); });
}

ProgressBar::~ProgressBar() {
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
    }
    ended_changed_.notify_all();
    watcher_.join();
    ::sigaction(SIGINT, &before_, nullptr);
    if (shown_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressBar::watch() {
    constexpr std::chrono::milliseconds kPeriod(100);
    std::unique_lock lock(mutex_);
    while (!ended_changed_.wait_for(lock, kPeriod, [this] { return ended_; })) {
        if (interrupted != 0) progress_.cancel();
        if (shown_) draw();
    }
}

void ProgressBar::draw() const {
    constexpr int kWidth = 30;
    const float fraction = std::clamp(progress_.fraction(), 0.0f, 1.0f);
    const auto filled = static_cast<std::size_t>(fraction * kWidth);
    fmt::print(stderr, "\r[{}{}] {:3.0f}%  {}\x1b[K", std::string(filled, '#'),
               std::string(kWidth - filled, '.'), 100.0f * fraction, progress_.stage());
    std::fflush(stderr);
}

}  // namespace patina::cli

// SPDX-License-Identifier: MIT
#include "render/pass_timers.h"

#include <algorithm>
#include <tuple>

namespace patina::render {
namespace {

/// Mesa's software rasteriser gives the time since the machine was started for the first query that
/// ends in a context; no pass takes as long.
constexpr double kLongestPassMs = 60'000.0;

}  // namespace

void PassTimers::collect(Timer& timer) {
    if (!timer.pending) return;
    if (const std::optional<double> elapsed_ms = timer.query.elapsed_ms()) {
        if (*elapsed_ms < kLongestPassMs) timer.last_ms = *elapsed_ms;
        timer.pending = false;
    }
}

PassTimers::Scope PassTimers::measure(FrameSide side, std::string_view name) {
    if (paused_) return Scope(nullptr);
    const std::pair key(side, name);
    auto found = timers_.find(key);
    if (found == timers_.end())
        found = timers_.emplace(key, Timer{.query = gl::TimerQuery::make(name)}).first;
    Timer& timer = found->second;
    timer.frame = frame_;
    timer.order = passes_++;
    collect(timer);
    if (timer.pending) return Scope(nullptr);
    timer.pending = true;
    return Scope(&timer.query);
}

std::vector<PassCost> PassTimers::costs(FrameSide side) {
    std::vector<std::tuple<bool, int, PassCost>> found;
    for (auto& [key, timer] : timers_) {
        const bool shared = key.first == FrameSide::Shared;
        if (timer.frame != frame_ || (!shared && key.first != side)) continue;
        collect(timer);
        found.emplace_back(!shared, timer.order, PassCost{key.second, timer.last_ms});
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return std::tie(std::get<0>(a), std::get<1>(a)) < std::tie(std::get<0>(b), std::get<1>(b));
    });
    std::vector<PassCost> costs;
    for (const auto& entry : found) costs.push_back(std::get<2>(entry));
    return costs;
}

}  // namespace patina::render

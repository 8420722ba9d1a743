// SPDX-License-Identifier: MIT
#include "core/log.h"

#include <cstdio>
#include <mutex>

namespace patina {
namespace {

struct Sink {
    std::mutex mutex;
    LogSink function;
};

Sink& sink() {
    static Sink instance;
    return instance;
}

}  // namespace

void set_log_sink(LogSink function) {
    const std::lock_guard lock(sink().mutex);
    sink().function = std::move(function);
}

void log_line(LogLevel level, std::string_view line) {
    const std::lock_guard lock(sink().mutex);
    if (sink().function) {
        sink().function(level, line);
    } else if (level != LogLevel::Info) {
        fmt::print(stderr, "patina: {}\n", line);
    }
}

}  // namespace patina

// SPDX-License-Identifier: MIT
#pragma once

/// Warnings that belong to no single call's result. They go to the standard error stream of a
/// command, one line each with "patina: " before it, and to the editor's log.

#include <fmt/format.h>

#include <functional>
#include <string>
#include <string_view>

namespace patina {

enum class LogLevel { Info, Warning, Error };

/// Called for each line, from any thread, one call at a time. An empty function restores the
/// default, which prints warnings and errors to the standard error stream.
using LogSink = std::function<void(LogLevel, std::string_view line)>;
void set_log_sink(LogSink sink);

void log_line(LogLevel level, std::string_view line);

template <typename... Args>
void log_info(fmt::format_string<Args...> format, Args&&... args) {
    log_line(LogLevel::Info, fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args>
void log_warning(fmt::format_string<Args...> format, Args&&... args) {
    log_line(LogLevel::Warning, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace patina

// SPDX-License-Identifier: MIT
#pragma once

/// Options that several commands share, and kinds of values that CLI11 does not know. A value that
/// cannot be read is wrong usage.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/parallel.h"

namespace patina::cli {

/// `--size 1280x720`: two whole numbers of 1 to 16384.
CLI::Option* add_size_option(CLI::App& app, const std::string& flag, int& width, int& height,
                             const std::string& help);

/// `--camera-position 1,0.5,-2`: three numbers.
CLI::Option* add_vector_option(CLI::App& app, const std::string& flag,
                               std::optional<glm::vec3>& value, const std::string& help);

/// `--uv 0.25,0.5`: two numbers.
CLI::Option* add_uv_option(CLI::App& app, const std::string& flag, glm::vec2& value,
                           const std::string& help);

/// `-o FILE`, required. Its extension has to be one of `extensions`, such as ".glb".
CLI::Option* add_output_option(CLI::App& app, std::filesystem::path& path,
                               std::vector<std::string> extensions, const std::string& help);

/// A flag such as `--no-shadows` that turns off what is on. (CLI11's own way to say that writes
/// "{false}" behind it in the help.)
CLI::Option* add_off_flag(CLI::App& app, const std::string& flag, bool& value,
                          const std::string& help);

/// A pick from a table of entries with an `id`; `pick` gets the entry.
template <typename Table, typename Pick>
CLI::Option* add_choice_option(CLI::App& app, const std::string& flag, const Table& table,
                               Pick pick, const std::string& help) {
    std::vector<std::string_view> ids;
    for (const auto& entry : table) ids.push_back(entry.id);
    const auto choose = [&table, pick, flag, ids](const std::string& id) {
        for (const auto& entry : table)
            if (entry.id == id) return pick(entry);
        throw CLI::ValidationError(flag,
                                   fmt::format("'{}' is none of {}", id, fmt::join(ids, ", ")));
    };
    return app.add_option_function<std::string>(flag, choose, help)
        ->type_name(fmt::format("{}", fmt::join(ids, "|")));
}

/// `--threads N`, `--json` and `--quiet`: how a command goes about its work.
struct WorkOptions {
    int threads = 0;  ///< 0: one a processor
    bool json = false;
    bool quiet = false;
};
void add_work_options(CLI::App& app, WorkOptions& options);

/// Holds the parallel loops to the threads that were asked for while it lives.
class ThreadScope {
  public:
    explicit ThreadScope(const WorkOptions& options) {
        if (options.threads > 0) limit_.emplace(options.threads);
    }

  private:
    std::optional<ThreadLimit> limit_;
};

}  // namespace patina::cli

// SPDX-License-Identifier: MIT
#include "cli/arguments.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace patina::cli {
namespace {

/// Reads all of `text` as one number, without regard to the locale.
template <typename Number>
std::optional<Number> number_of(std::string_view text) {
    Number number = {};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t at = text.find(separator);
        parts.push_back(text.substr(0, at));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + 1);
    }
}

std::optional<int> side_of(std::string_view text) {
    const auto side = number_of<int>(text);
    return side && *side >= 1 && *side <= 16384 ? side : std::nullopt;
}

}  // namespace

CLI::Option* add_size_option(CLI::App& app, const std::string& flag, int& width, int& height,
                             const std::string& help) {
    const auto read = [flag, &width, &height](const std::string& text) {
        const auto parts = split(text, 'x');
        const auto w = parts.size() == 2 ? side_of(parts[0]) : std::nullopt;
        const auto h = parts.size() == 2 ? side_of(parts[1]) : std::nullopt;
        if (!w || !h)
            throw CLI::ValidationError(
                flag, fmt::format("'{}' is no size such as 1280x720, of 1 to 16384 a side", text));
        width = *w;
        height = *h;
    };
    CLI::Option* option = app.add_option_function<std::string>(flag, read, help)->type_name("WxH");
    if (width > 0) option->default_str(fmt::format("{}x{}", width, height));
    return option;
}

CLI::Option* add_uv_option(CLI::App& app, const std::string& flag, glm::vec2& value,
                           const std::string& help) {
    const auto read = [flag, &value](const std::string& text) {
        const auto parts = split(text, ',');
        const auto u = parts.size() == 2 ? number_of<float>(parts[0]) : std::nullopt;
        const auto v = parts.size() == 2 ? number_of<float>(parts[1]) : std::nullopt;
        if (!u || !v || !std::isfinite(*u) || !std::isfinite(*v))
            throw CLI::ValidationError(flag,
                                       fmt::format("'{}' is no place such as 0.25,0.5", text));
        value = {*u, *v};
    };
    return app.add_option_function<std::string>(flag, read, help)->type_name("U,V");
}

CLI::Option* add_vector_option(CLI::App& app, const std::string& flag,
                               std::optional<glm::vec3>& value, const std::string& help) {
    const auto read = [flag, &value](const std::string& text) {
        const auto parts = split(text, ',');
        glm::vec3 vector(0.0f);
        bool good = parts.size() == 3;
        for (std::size_t i = 0; good && i < 3; ++i) {
            const auto number = number_of<float>(parts[i]);
            good = number && std::isfinite(*number);
            if (good) vector[static_cast<int>(i)] = *number;
        }
        if (!good)
            throw CLI::ValidationError(flag,
                                       fmt::format("'{}' is no vector such as 1,0.5,-2", text));
        value = vector;
    };
    return app.add_option_function<std::string>(flag, read, help)->type_name("X,Y,Z");
}

CLI::Option* add_off_flag(CLI::App& app, const std::string& flag, bool& value,
                          const std::string& help) {
    return app.add_flag_callback(
        flag, [&value] { value = false; }, help);
}

CLI::Option* add_output_option(CLI::App& app, std::filesystem::path& path,
                               std::vector<std::string> extensions, const std::string& help) {
    const auto check = [extensions](const std::string& text) {
        const std::string extension = std::filesystem::path(text).extension().string();
        if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end())
            return std::string();
        return fmt::format("'{}' does not end in {}", text, fmt::join(extensions, " or "));
    };
    return app.add_option("-o,--output", path, help)->required()->check(check)->type_name("FILE");
}

void add_work_options(CLI::App& app, WorkOptions& options) {
    app.add_option("--threads", options.threads,
                   "Threads to work on; the result does not depend on it [one a processor]")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    app.add_flag("--json", options.json, "Report as JSON on the standard output");
    app.add_flag("--quiet", options.quiet, "Show no progress and no report");
}

}  // namespace patina::cli

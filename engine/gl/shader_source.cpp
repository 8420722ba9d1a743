// SPDX-License-Identifier: MIT
#include "gl/shader_source.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "core/files.h"

namespace patina::gl {
namespace {

constexpr std::uint64_t kShaderLimitBytes = std::uint64_t{1} << 20;

/// The path of `#include "path"`; nothing when the line is another one.
std::optional<std::string_view> included_path(std::string_view line) {
    const std::size_t start = line.find_first_not_of(" \t");
    if (start == std::string_view::npos || !line.substr(start).starts_with("#include"))
        return std::nullopt;
    const std::size_t open = line.find('"');
    const std::size_t close = line.rfind('"');
    if (open == close) return std::nullopt;
    return line.substr(open + 1, close - open - 1);
}

bool stays_inside(std::string_view file) {
    const std::filesystem::path path(file);
    return path.is_relative() &&
           std::none_of(path.begin(), path.end(), [](const auto& part) { return part == ".."; });
}

/// Collects the text of one shader, file by file.
class Assembler {
  public:
    explicit Assembler(std::span<const std::filesystem::path> folders) : folders_(folders) {}

    void add_line(std::string_view text, ShaderLine origin) {
        source_.text.append(text).push_back('\n');
        source_.lines.push_back(std::move(origin));
    }

    Status add_file(std::string_view file) {
        if (std::find(files_.begin(), files_.end(), file) != files_.end()) return {};
        files_.emplace_back(file);
        const Result<std::string> text = read(file);
        if (!text) return passed_on(text);
        return add_lines(*text, file);
    }

    ShaderSource take() { return std::move(source_); }

  private:
    Result<std::string> read(std::string_view file) const {
        if (!stays_inside(file))
            return failure("shader {}: a path must stay inside the shader folder",
                           quoted_for_message(file));
        for (const std::filesystem::path& folder : folders_)
            if (std::filesystem::exists(folder / file))
                return read_text_file(folder / file, kShaderLimitBytes);
        return failure("shader {}: no such file in {}", quoted_for_message(file),
                       folders_.empty() ? std::string("any folder")
                                        : quoted_for_message(folders_.front().string()));
    }

    Status add_lines(std::string_view text, std::string_view file) {
        for (int line_number = 1; !text.empty(); ++line_number) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            const std::string_view line = text.substr(0, end);
            text.remove_prefix(std::min(end + 1, text.size()));
            const auto path = included_path(line);
            if (!path) {
                add_line(line, {.file = std::string(file), .line = line_number});
            } else if (const Status included = add_file(*path); !included) {
                return failure("{} (included by {}:{})", included.error().message, file,
                               line_number);
            }
        }
        return {};
    }

    std::span<const std::filesystem::path> folders_;
    std::vector<std::string> files_;
    ShaderSource source_;
};

/// The line number that a message starts with and where it ends in the message. Mesa and AMD write
/// "0:17(5): error", NVIDIA "0(17) : error".
struct MessageLine {
    std::size_t number = 0;
    std::size_t end = 0;
};
std::optional<MessageLine> message_line(std::string_view message) {
    const std::size_t separator = message.find_first_not_of("0123456789");
    if (separator == 0 || separator == std::string_view::npos ||
        (message[separator] != ':' && message[separator] != '('))
        return std::nullopt;
    MessageLine found;
    const char* end = message.data() + message.size();
    const auto [rest, error] = std::from_chars(message.data() + separator + 1, end, found.number);
    if (error != std::errc()) return std::nullopt;
    found.end = static_cast<std::size_t>(rest - message.data());
    if (message[separator] == '(' && found.end < message.size()) ++found.end;  // the closing one
    return found;
}

}  // namespace

Result<ShaderSource> load_shader_source(std::span<const std::filesystem::path> folders,
                                        std::string_view file,
                                        std::span<const ShaderDefine> defines) {
    Assembler assembler(folders);
    assembler.add_line("#version 410 core", {});
    for (const ShaderDefine& define : defines)
        assembler.add_line(fmt::format("#define {} {}", define.name, define.value), {});
    if (Status prelude = assembler.add_file("shared/prelude.glsl"); !prelude)
        return passed_on(prelude);
    if (Status main = assembler.add_file(file); !main) return passed_on(main);
    return assembler.take();
}

std::string log_with_file_names(std::string_view log, const ShaderSource& source) {
    std::string named;
    while (!log.empty()) {
        const std::size_t end = std::min(log.find('\n'), log.size());
        std::string_view message = log.substr(0, end);
        log.remove_prefix(std::min(end + 1, log.size()));
        const auto at = message_line(message);
        if (at && at->number >= 1 && at->number <= source.lines.size()) {
            const ShaderLine& origin = source.lines[at->number - 1];
            named += fmt::format("{}:{}", origin.file, origin.line);
            message.remove_prefix(at->end);
        }
        named.append(message).push_back('\n');
    }
    return named;
}

}  // namespace patina::gl

// SPDX-License-Identifier: MIT
#include "io/uri.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

namespace patina::io {
namespace {

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

/// A percent sign without two digits after it stays as it is: some exporters do not encode.
std::string percent_decoded(std::string_view text) {
    std::string decoded;
    decoded.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const int high = text[i] == '%' && i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
        const int low = high >= 0 ? hex_digit(text[i + 2]) : -1;
        if (low < 0) {
            decoded += text[i];
            continue;
        }
        decoded += static_cast<char>(high * 16 + low);
        i += 2;
    }
    return decoded;
}

int base64_digit(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+' || c == '-') return 62;
    if (c == '/' || c == '_') return 63;
    return -1;
}

std::optional<Bytes> base64_decoded(std::string_view text) {
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    if (text.size() % 4 == 1) return std::nullopt;
    Bytes bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : text) {
        const int digit = base64_digit(c);
        if (digit < 0) return std::nullopt;
        bits = (bits << 6 | static_cast<std::uint32_t>(digit)) & 0xFFFFFF;
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes.push_back(static_cast<std::byte>(bits >> held & 0xFF));
    }
    return bytes;
}

bool has_scheme(std::string_view uri) {
    const auto colon = uri.find(':');
    if (colon == std::string_view::npos || colon == 0) return false;
    return std::all_of(uri.begin(), uri.begin() + static_cast<std::ptrdiff_t>(colon), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '-' || c == '.';
    });
}

bool is_control(char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}

}  // namespace

bool is_data_uri(std::string_view uri) {
    return uri.substr(0, 5) == "data:";
}

Result<DataUri> decode_data_uri(std::string_view uri) {
    const auto comma = uri.find(',');
    if (!is_data_uri(uri) || comma == std::string_view::npos)
        return failure("the data: URI has no comma before its data");
    std::string_view head = uri.substr(5, comma - 5);
    const std::string_view payload = uri.substr(comma + 1);
    constexpr std::string_view kBase64 = ";base64";
    const bool is_base64 = head.ends_with(kBase64);
    if (is_base64) head.remove_suffix(kBase64.size());
    DataUri data{.mime_type = std::string(head.substr(0, head.find(';'))), .bytes = {}};
    if (!is_base64) {
        const std::string text = percent_decoded(payload);
        const auto bytes = bytes_of(text);
        data.bytes.assign(bytes.begin(), bytes.end());
        return data;
    }
    // '+', '/' and '=' may be percent-encoded.
    auto bytes = payload.find('%') == std::string_view::npos
                     ? base64_decoded(payload)
                     : base64_decoded(percent_decoded(payload));
    if (!bytes) return failure("the data: URI is not valid base64");
    data.bytes = std::move(*bytes);
    return data;
}

Result<std::filesystem::path> relative_path_of_uri(std::string_view uri) {
    const std::string shown = quoted_for_message(uri, 100);
    if (has_scheme(uri))
        return failure("\"{}\" has a scheme; only files beside the model and data: are read",
                       shown);
    const std::string decoded = percent_decoded(uri);
    if (decoded.empty()) return failure("the URI is empty");
    if (std::any_of(decoded.begin(), decoded.end(), is_control) ||
        decoded.find('\\') != std::string::npos)
        return failure("\"{}\" has a backslash or a control character in it", shown);
    const std::filesystem::path path(decoded);
    if (path.is_absolute())
        return failure("\"{}\" is an absolute path; only files beside the model are read", shown);
    if (std::find(path.begin(), path.end(), "..") != path.end())
        return failure("\"{}\" leads out of the model's folder", shown);
    return path;
}

Result<std::optional<std::filesystem::path>> file_under(const std::filesystem::path& folder,
                                                        const std::filesystem::path& relative) {
    std::error_code error;
    const auto base = std::filesystem::canonical(folder.empty() ? "." : folder, error);
    if (error) return failure("the model's folder cannot be read: {}", error.message());
    const auto file = std::filesystem::canonical(base / relative, error);
    if (error) return std::nullopt;
    const auto [base_end, rest] = std::mismatch(base.begin(), base.end(), file.begin(), file.end());
    if (base_end != base.end() || rest == file.end())
        return failure("\"{}\" leads out of the model's folder",
                       quoted_for_message(relative.string(), 100));
    if (!std::filesystem::is_regular_file(file, error))
        return failure("\"{}\" is not a regular file", quoted_for_message(relative.string(), 100));
    return file;
}

}  // namespace patina::io

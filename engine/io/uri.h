// SPDX-License-Identifier: MIT
#pragma once

/// What a glTF file may point to: data inside itself and files under its own folder, nothing else.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/files.h"

namespace patina::io {

/// The bytes of a `data:` URI and the media type it states (may be empty).
struct DataUri {
    std::string mime_type;
    Bytes bytes;
};

bool is_data_uri(std::string_view uri);
/// Base64 (RFC 4648, with or without its padding) or percent-encoded text.
Result<DataUri> decode_data_uri(std::string_view uri);

/// Percent-decoded once. Refused: a scheme such as http:, an absolute path, a backslash, a NUL or
/// another control character, and any `..`.
Result<std::filesystem::path> relative_path_of_uri(std::string_view uri);

/// The regular file that a relative path means under `folder`; links are followed, and one that
/// leads out of the folder is refused. Nothing when no such file exists.
Result<std::optional<std::filesystem::path>> file_under(const std::filesystem::path& folder,
                                                        const std::filesystem::path& relative);

}  // namespace patina::io

// SPDX-License-Identifier: MIT
#pragma once

/// Names from a model made fit for a file name.

#include <string>
#include <string_view>

namespace patina::io {

/// `name` with every byte but A-Z, a-z, 0-9, '.', '_' and '-' made '_', no '.' first, and at most
/// `limit_bytes` long; "unnamed" where nothing is left.
std::string safe_file_name(std::string_view name, std::size_t limit_bytes = 100);

}  // namespace patina::io

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace patina::io {

/// Base64 with padding (RFC 4648), as data: URIs hold it.
std::string base64(std::span<const std::byte> bytes);

}  // namespace patina::io

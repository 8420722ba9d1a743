// SPDX-License-Identifier: MIT
#pragma once

/// Asking before much memory is taken: the system hands out more than it has, and ends the program
/// when it is used.

#include <cstdint>
#include <string_view>

#include "core/result.h"

namespace patina {

/// Fails where that much is more than is free now; where the system does not say, all is well.
/// @param what  that takes it, for the message: "maps of 16384 texels a side"
Status check_free_memory(std::uint64_t bytes, std::string_view what);

}  // namespace patina

// SPDX-License-Identifier: MIT
#pragma once

namespace patina {

/// The linear light of each of the 256 sRGB-encoded bytes.
const float* decoded_bytes();

}  // namespace patina

// SPDX-License-Identifier: MIT
#pragma once

/// Loads what may be anything: it may open or be refused, but never crash, hang or answer with more
/// than clean lines.

#include <string>

#include "core/files.h"

namespace patina::io::test {

/// Stands in files that no model may reach; no message may ever show it.
inline constexpr const char* kSecret = "CANARY-5f3a";

/// No control character, not too long, no secret.
void expect_one_clean_line(const std::string& message);

/// Loads a .glb or .gltf from memory, with small limits for the memory that it may take. Failures
/// are reported to the running test. Returns whether it opened.
bool load_quietly(Bytes file);

}  // namespace patina::io::test

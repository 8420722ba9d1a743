// SPDX-License-Identifier: MIT
#pragma once

/// A validator for the part of JSON Schema 2020-12 that presets/schema.json uses. A keyword that it
/// does not know makes every value invalid, so that the schema cannot outgrow it unnoticed.

#include <nlohmann/json.hpp>
#include <string>

namespace patina::test_support {

/// The first fault as "POINTER: reason", or empty when `value` is valid against `schema`, a part of
/// `root` (which $ref looks up).
std::string schema_fault(const nlohmann::json& root, const nlohmann::json& schema,
                         const nlohmann::json& value, const std::string& pointer = "");

}  // namespace patina::test_support

// SPDX-License-Identifier: MIT
#pragma once

/// The two JSON values that Patina works with. Who makes or reads one includes <nlohmann/json.hpp>.

#include <nlohmann/json_fwd.hpp>

namespace patina {

/// Members stay in the order in which they were added or lie in the file: what Patina writes.
using Json = nlohmann::ordered_json;

/// Members are found in logarithmic time, whatever a stranger's file holds.
using SortedJson = nlohmann::json;

}  // namespace patina

// SPDX-License-Identifier: MIT
#pragma once

/// An edit: a function from one snapshot to the next, with the label that the history shows.

#include <functional>
#include <string>
#include <vector>

#include "core/result.h"
#include "document/document.h"

namespace patina {

/// Successive edits with equal keys become one undo step (a slider's drag) until the history is
/// sealed (the mouse button is released). An empty `action` never merges.
struct MergeKey {
    std::string action;
    std::uint64_t target = 0;
    bool operator==(const MergeKey&) const = default;
};

struct Edit {
    std::string label;  ///< "Opacity of Tarnish"
    MergeKey merge_key;
    /// Pure. Refuses what would break the document (a value out of range, an unknown id, a cycle).
    std::function<Result<Document>(const Document& before)> apply;
};

using Edits = std::vector<Edit>;

}  // namespace patina

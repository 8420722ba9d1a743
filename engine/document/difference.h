// SPDX-License-Identifier: MIT
#pragma once

/// What differs between two documents, in words: what `patina compare` prints.

#include <string>
#include <vector>

#include "document/document.h"

namespace patina {

struct Difference {
    std::string material;  ///< empty: of the scene
    std::string layer;     ///< names from the stack down, such as "Rust / Spots"; empty: none
    std::string what;      ///< "opacity is 0.5, was 1"
    bool operator==(const Difference&) const = default;
};

/// Materials and layers are taken for the same by their names, of equal names the first, the second
/// and so on; ids do not count. In the order of `after`, then what is gone.
std::vector<Difference> differences(const Document& before, const Document& after);

}  // namespace patina

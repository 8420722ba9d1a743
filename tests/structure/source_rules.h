// SPDX-License-Identifier: MIT
#pragma once

/// The rules that every file of the tree keeps. Each function returns one line for each breach,
/// with the file, the line where there is one, and the reason; none when the rule holds.

#include <string>
#include <vector>

#include "structure/source_tree.h"

namespace patina::structure {

using Faults = std::vector<std::string>;

/// core <- scene <- document <- composite <- render; gl under render alone; io above scene,
/// document and composite; app above all, its commands and its editor apart. Includes name a path
/// from engine/, app/ or shaders/.
Faults include_direction_faults(const SourceTree& tree);

/// Each library is known to the folders that wrap it: ImGui to app/editor, GL to gl and render ...
Faults library_faults(const SourceTree& tree);

/// No file includes itself in the end, and no two folders include each other.
Faults include_cycle_faults(const SourceTree& tree);

/// Every source starts with the licence's one line.
Faults licence_faults(const SourceTree& tree);

/// Unfinished business, paths of somebody's machine, hosts of package registries, and names of
/// files that say nothing.
Faults wording_faults(const SourceTree& tree);

}  // namespace patina::structure

// SPDX-License-Identifier: MIT
#pragma once

/// Resolving a source of the document for the program.

#include "composite/operations.h"

namespace patina {

/// Everything but the numbers of images and patterns, which are the program's matter.
SourceRecord source_record(const Source& source, Reading reading);

/// Numbers the patterns of procedural sources that are wanted more than once: by several sources
/// or, where heights are composited for themselves, again for other channels.
void number_patterns(ProgramData& program);

}  // namespace patina

// SPDX-License-Identifier: MIT
#pragma once

/// Resolving a source of the document for the program.

#include "composite/operations.h"

namespace patina {

/// Everything but the index of the image, which is the program's matter.
SourceRecord source_record(const Source& source, Reading reading);

}  // namespace patina

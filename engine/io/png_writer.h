// SPDX-License-Identifier: MIT
#pragma once

/// PNG out, fast: strips of about 1 MiB are filtered and deflated side by side and joined into one
/// standard stream.

#include "core/files.h"
#include "core/progress.h"
#include "core/result.h"
#include "scene/image.h"

namespace patina::io {

struct PngOptions {
    /// ISA-L's level, 1 to 3. Of filtered rows 2 makes the smallest files, hardly slower than 1.
    int level = 2;
};

/// Encodes U8 and U16 images of 1 to 4 channels; the numbers are written as they are and nothing is
/// said of their colour space. The same bytes on one machine at any number of threads. Fails for
/// F32, for sizes outside 1 to 16384, for data of the wrong length, and when cancelled.
Result<Bytes> encode_png(const Image& image, const PngOptions& options = {},
                         const Progress& progress = {});

}  // namespace patina::io

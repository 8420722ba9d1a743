// SPDX-License-Identifier: MIT
#pragma once

/// From where `patina render` looks.

#include "cli/render_options.h"
#include "document/document.h"

namespace patina::cli {

/// Sets the camera of the request: one of the file, one that was placed, or automatic framing. A
/// camera that the file has not is a failure that names those that it has.
Status set_camera(const RenderOptions& options, const Document& document,
                  render::OffscreenRequest& request);

}  // namespace patina::cli

// SPDX-License-Identifier: MIT
#include "render/window_target.h"

#include <epoxy/gl.h>

namespace patina::render {

void draw_to_window() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    // Colours of the interface are sRGB-encoded already.
    glDisable(GL_FRAMEBUFFER_SRGB);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace patina::render

// SPDX-License-Identifier: MIT
// Linked into every program of tests that draws, or starts one that draws.

#include <cstdlib>

namespace {

/// Mesa gives who asks for OpenGL 4.1 the newest that it has, in which newer functions and shaders
/// work too. This holds it to the floor that the design states. It has to be said before the first
/// context of a process, so it is before main().
[[maybe_unused]] const bool kHeldToOpenGl41 =
    ::setenv("MESA_GL_VERSION_OVERRIDE", "4.1FC", 1) == 0 &&
    ::setenv("MESA_GLSL_VERSION_OVERRIDE", "410", 1) == 0;

}  // namespace

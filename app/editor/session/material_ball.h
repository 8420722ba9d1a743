// SPDX-License-Identifier: MIT
#pragma once

/// A material on a ball in the studio, as a small picture with a transparent surround. Needs the
/// window's OpenGL context.

#include <optional>

#include "core/result.h"
#include "render/renderer.h"
#include "render/surface.h"
#include "scene/uv_surface.h"

namespace patina::editor {

/// The ball, as what materials on it can read.
UvSurfacePtr ball_surface();

class MaterialBall {
  public:
    /// Compiles shaders and filters the studio: a good part of a second.
    static Result<MaterialBall> create();
    /// RGBA U8, sRGB-encoded, straight alpha, `side` texels a side.
    Result<Image> picture(const render::SurfaceMaterial& surface, int side);

  private:
    MaterialBall(render::Renderer renderer, render::View view)
        : renderer_(std::move(renderer)), view_(view) {}
    render::Renderer renderer_;
    render::View view_;
};

}  // namespace patina::editor

// SPDX-License-Identifier: MIT
#pragma once

/// Small pictures for an interface that draws with OpenGL: thumbnails.

#include <cstdint>
#include <memory>

#include "core/result.h"
#include "scene/image.h"

namespace patina::render {

/// An image as a texture with mip levels. Belongs to the context that is current when it is made.
class InterfaceImage {
  public:
    /// @param image  U8, 1 to 4 channels, sRGB-encoded, straight alpha; grey is spread to RGB
    static Result<InterfaceImage> make(const Image& image);
    ~InterfaceImage();
    InterfaceImage(InterfaceImage&&) noexcept;
    InterfaceImage& operator=(InterfaceImage&&) noexcept;

    /// The texture's name for Dear ImGui (ImTextureID), row 0 of the image at v = 0.
    std::uintptr_t texture() const;
    std::size_t bytes() const;

  private:
    struct State;
    explicit InterfaceImage(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace patina::render

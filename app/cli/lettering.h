// SPDX-License-Identifier: MIT
#pragma once

/// Words on pictures, in the font of the interface, without a window.

#include <memory>
#include <string_view>

#include "core/result.h"
#include "scene/paint.h"

namespace patina::cli {

/// What words stand on: nearly black, and the picture shines through.
inline constexpr glm::vec4 kPlateColor(0.07f, 0.07f, 0.07f, 0.78f);

class Lettering {
  public:
    /// @param em_pixels  height of the letters' em, above 0
    static Result<Lettering> make(int em_pixels);
    ~Lettering();
    Lettering(Lettering&&) noexcept;
    Lettering& operator=(Lettering&&) noexcept;

    int em_pixels() const;
    /// Pixels from the first letter's origin to the end of the last one.
    int width(std::string_view ascii) const;
    /// Draws words from x on, with their letters standing on the row above `baseline`. Nothing
    /// outside of `clip` is touched.
    void draw(Image& picture, glm::ivec2 baseline, std::string_view ascii,
              const TexelBox& clip) const;

  private:
    struct Face;
    explicit Lettering(std::unique_ptr<Face> face);
    std::unique_ptr<Face> face_;
};

/// Words on a dark plate, whose lower left corner is that of `within`; cut off where that ends.
void draw_plate(Image& picture, const TexelBox& within, std::string_view ascii,
                const Lettering& lettering);

}  // namespace patina::cli

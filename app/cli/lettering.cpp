// SPDX-License-Identifier: MIT
#include "cli/lettering.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>

#include "core/font_file.h"

namespace patina::cli {
namespace {

constexpr glm::vec3 kLetterColor(0.93f);

struct CloseLibrary {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
struct CloseFace {
    void operator()(FT_Face face) const { FT_Done_Face(face); }
};

/// FreeType counts in 64ths of a pixel.
int whole_pixels(FT_Pos length) {
    return static_cast<int>((length + 32) >> 6);
}

}  // namespace

struct Lettering::Face {
    std::unique_ptr<FT_LibraryRec_, CloseLibrary> library;
    std::unique_ptr<FT_FaceRec_, CloseFace> face;  // below its library: closed before it
    int em_pixels = 0;

    /// Calls `visit(glyph, x)` for each letter, drawn, and returns where the last one ends.
    template <typename Visit>
    int for_each_glyph(std::string_view ascii, const Visit& visit) const {
        int x = 0;
        for (const char letter : ascii) {
            if (FT_Load_Char(face.get(), static_cast<unsigned char>(letter),
                             FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT) != 0)
                continue;
            visit(*face->glyph, x);
            x += whole_pixels(face->glyph->advance.x);
        }
        return x;
    }
};

Lettering::Lettering(std::unique_ptr<Face> face) : face_(std::move(face)) {}
Lettering::~Lettering() = default;
Lettering::Lettering(Lettering&&) noexcept = default;
Lettering& Lettering::operator=(Lettering&&) noexcept = default;

Result<Lettering> Lettering::make(int em_pixels) {
    const auto file = font_file({"Inter-Medium.otf", "Inter-Medium.ttf"});
    if (!file) return passed_on(file);
    auto opened = std::make_unique<Face>();
    opened->em_pixels = em_pixels;
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    const bool started = FT_Init_FreeType(&library) == 0;
    opened->library.reset(library);
    const bool read = started && FT_New_Face(library, file->c_str(), 0, &face) == 0;
    opened->face.reset(face);
    if (!read || FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(em_pixels)) != 0)
        return failure("{} could not be read as a font: install fonts-inter anew", file->string());
    return Lettering(std::move(opened));
}

int Lettering::em_pixels() const {
    return face_->em_pixels;
}

int Lettering::width(std::string_view ascii) const {
    return face_->for_each_glyph(ascii, [](const FT_GlyphSlotRec_&, int) {});
}

void Lettering::draw(Image& picture, glm::ivec2 baseline, std::string_view ascii,
                     const TexelBox& clip) const {
    face_->for_each_glyph(ascii, [&](const FT_GlyphSlotRec_& glyph, int along) {
        const FT_Bitmap& bitmap = glyph.bitmap;
        for (int row = 0; row < static_cast<int>(bitmap.rows); ++row)
            for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
                const int x = baseline.x + along + glyph.bitmap_left + column;
                const int y = baseline.y - glyph.bitmap_top + row;
                if (x < clip.x0 || x >= clip.x1 || y < clip.y0 || y >= clip.y1) continue;
                const float coverage =
                    static_cast<float>(bitmap.buffer[row * bitmap.pitch + column]) / 255.0f;
                lay_over(picture, x, y, glm::vec4(kLetterColor, coverage));
            }
    });
}

void draw_plate(Image& picture, const TexelBox& within, std::string_view ascii,
                const Lettering& lettering) {
    const int em = lettering.em_pixels();
    const int margin = em / 3;
    const int right = within.x0 + lettering.width(ascii) + 2 * margin;
    const TexelBox plate{.x0 = within.x0,
                         .y0 = std::max(within.y0, within.y1 - em - 2 * margin),
                         .x1 = std::min(within.x1, right),
                         .y1 = within.y1};
    lay_over(picture, plate, kPlateColor);
    // A quarter of the em hangs below the baseline.
    lettering.draw(picture, {plate.x0 + margin, plate.y1 - margin - em / 4}, ascii, plate);
}

}  // namespace patina::cli

// SPDX-License-Identifier: MIT
#include "editor/widgets/fonts.h"

#include <imgui_freetype.h>

#include <array>
#include <cmath>
#include <string>

#include "core/font_file.h"

namespace patina::editor {
namespace {

struct FontFiles {
    std::string regular;
    std::string medium;
    std::string semibold;
    std::string icons;
};

Result<FontFiles> find_fonts() {
    const auto regular = font_file({"Inter-Regular.otf", "Inter-Regular.ttf"});
    if (!regular) return passed_on(regular);
    const auto medium = font_file({"Inter-Medium.otf", "Inter-Medium.ttf"});
    if (!medium) return passed_on(medium);
    const auto semibold = font_file({"Inter-SemiBold.otf", "Inter-SemiBold.ttf"});
    if (!semibold) return passed_on(semibold);
    const auto icons = font_file({"FontAwesome.otf", "fontawesome-webfont.ttf"});
    if (!icons) return passed_on(icons);
    return FontFiles{regular->string(), medium->string(), semibold->string(), icons->string()};
}

constexpr std::array<ImWchar, 3> kDigits = {'0', '9', 0};
constexpr std::array<ImWchar, 17> kLetters = {0x20,   '/',    ':',    0x24F,  0x370,  0x52F,
                                              0x2010, 0x2027, 0x2030, 0x203A, 0x20AC, 0x20AC,
                                              0x2190, 0x2193, 0x2212, 0x2212, 0};
constexpr std::array<ImWchar, 3> kIcons = {0xF000, 0xF2E0, 0};

/// Inter's ascent and descent make 1.21 em, and ImGui's size counts both.
constexpr float kHeightOfEm = 1.21f;
/// The widest digit of Inter in em; its bearings leave room to round to the nearest pixel.
constexpr float kDigitOfEm = 0.63f;
/// FreeType's LightHinting (ImGuiFreeTypeBuilderFlags).
constexpr unsigned kHinting = ImGuiFreeTypeBuilderFlags_LightHinting;

struct FaceRequest {
    const std::string& file;
    float size_pixels;  ///< at scale 1
};

/// Digits come first and all as wide as the widest, so that numbers do not dance.
ImFont* add_face(const FaceRequest& request, const std::string& icons, float scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    const float size = std::round(request.size_pixels * scale);
    ImFontConfig config;
    config.FontBuilderFlags = kHinting;
    config.OversampleH = 1;
    config.OversampleV = 1;
    config.PixelSnapH = true;  // or digits would be centred in their width between two pixels
    config.GlyphMinAdvanceX = std::round(kDigitOfEm * size / kHeightOfEm);
    config.GlyphMaxAdvanceX = config.GlyphMinAdvanceX;
    ImFont* font = atlas.AddFontFromFileTTF(request.file.c_str(), size, &config, kDigits.data());
    config.MergeMode = true;
    config.GlyphMinAdvanceX = 0.0f;
    config.GlyphMaxAdvanceX = 3.4e38f;
    atlas.AddFontFromFileTTF(request.file.c_str(), size, &config, kLetters.data());
    config.GlyphMinAdvanceX = std::round(size);
    config.GlyphOffset.y = std::round(0.5f * scale);
    atlas.AddFontFromFileTTF(icons.c_str(), std::round(size * 0.875f), &config, kIcons.data());
    return font;
}

}  // namespace

Result<Fonts> load_fonts(float scale) {
    const Result<FontFiles> files = find_fonts();
    if (!files) return passed_on(files);
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    atlas.Flags |= ImFontAtlasFlags_NoMouseCursors;
    Fonts fonts;
    fonts.body13 = add_face({files->regular, 16.0f}, files->icons, scale);
    fonts.medium13 = add_face({files->medium, 16.0f}, files->icons, scale);
    fonts.title13 = add_face({files->semibold, 16.0f}, files->icons, scale);
    fonts.name15 = add_face({files->semibold, 18.0f}, files->icons, scale);
    fonts.value12 = add_face({files->regular, 15.0f}, files->icons, scale);
    fonts.medium12 = add_face({files->medium, 15.0f}, files->icons, scale);
    fonts.caption11 = add_face({files->regular, 14.0f}, files->icons, scale);
    fonts.medium11 = add_face({files->medium, 14.0f}, files->icons, scale);
    if (!atlas.Build()) return failure("the fonts could not be drawn: FreeType refused them");
    return fonts;
}

}  // namespace patina::editor

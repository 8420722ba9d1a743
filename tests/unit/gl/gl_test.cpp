// SPDX-License-Identifier: MIT
#include <algorithm>
#include <glm/vec3.hpp>
#include <numeric>

#include "gl/headless_test_context.h"
#include "gl/pass.h"
#include "gl/shader_files.h"
#include "gl/timer_query.h"

namespace patina {
namespace {

using gl::Format;

constexpr std::string_view kTintedTexture = R"(
uniform sampler2D image;
uniform vec3 tint;
layout(location = 0) out vec4 color;
void main() { color = vec4(texture(image, gl_FragCoord.xy / 4.0).rgb * tint, 0.5); }
)";

TEST_F(GlTest, AHeadlessContextHasOpenGl41AndOfMesaNothingNewer) {
    const std::string description = gl::renderer_description();
    RecordProperty("renderer", description);
    EXPECT_EQ(description.find("unknown"), std::string::npos) << description;
    if (description.find("Mesa") == std::string::npos) return;
    EXPECT_NE(description.find(", 4.1 "), std::string::npos) << description;
}

TEST(SoftwareRenderer, IsToldByItsNameFromAGraphicsCard) {
    for (const char* name : {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Software Rasterizer",
                             "Google SwiftShader", "GDI Generic", "Apple Software Renderer"})
        EXPECT_TRUE(gl::is_software_renderer(name)) << name;
    for (const char* name :
         {"NVIDIA GeForce RTX 3060/PCIe/SSE2", "Mesa Intel(R) UHD Graphics 620 (KBL GT2)",
          "AMD Radeon RX 6600 (navi23, LLVM 15.0.6, DRM 3.49)", "Apple M1", ""})
        EXPECT_FALSE(gl::is_software_renderer(name)) << name;
}

TEST_F(GlTest, UploadedTexelsReadBackAsTheyWere) {
    auto texture = gl::Texture::make({.label = "bytes", .size = {3, 2}, .format = Format::R8});
    ASSERT_TRUE(texture) << texture.error().message;
    std::vector<std::uint8_t> texels(3 * 2);  // rows that end between words
    std::iota(texels.begin(), texels.end(), std::uint8_t{10});
    texture->upload({.size = {3, 2}}, texels);
    EXPECT_EQ(texture->read_bytes(), texels);
    EXPECT_EQ(texture->bytes(), 6u);
}

TEST_F(GlTest, ARegionUploadChangesOnlyItsRegionAndMayHaveGapsBetweenRows) {
    auto texture = gl::Texture::make({.label = "region", .size = {4, 4}, .format = Format::R8});
    ASSERT_TRUE(texture);
    texture->upload({.size = {4, 4}}, std::vector<std::uint8_t>(16, 1));
    const std::vector<std::uint8_t> source = {2, 3, 9, 4, 5, 9};  // rows of 2, every 3 texels
    texture->upload({.offset = {1, 2}, .size = {2, 2}, .row_texels = 3}, source);
    const std::vector<std::uint8_t> expected = {1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 3, 1, 1, 4, 5, 1};
    EXPECT_EQ(texture->read_bytes(), expected);
}

TEST_F(GlTest, CubeFacesAndLevelsAreKeptApart) {
    auto cube = gl::Texture::make({.label = "cube",
                                   .size = {4, 4},
                                   .format = Format::Rgba16F,
                                   .shape = gl::TextureShape::Cube,
                                   .levels = 3});
    ASSERT_TRUE(cube);
    for (int face = 0; face < 6; ++face)
        for (int level = 0; level < 3; ++level) {
            const glm::ivec2 size = cube->size(level);
            const float value = static_cast<float>(face * 3 + level);
            cube->upload({.size = size, .level = level, .face = face},
                         std::vector<float>(static_cast<std::size_t>(size.x * size.y * 4), value));
        }
    EXPECT_EQ(cube->read_floats(2, 5), std::vector<float>(4, 17.0f));
    EXPECT_EQ(cube->read_floats(0, 1)[0], 3.0f);
    EXPECT_EQ(cube->bytes(), (16u + 4u + 1u) * 8u * 6u);
}

TEST_F(GlTest, ATextureLargerThanTheDriverTakesIsAnError) {
    const auto texture = gl::Texture::make({.label = "huge", .size = {1 << 20, 4}});
    ASSERT_FALSE(texture);
    EXPECT_NE(texture.error().message.find("texture huge: 1048576 x 4"), std::string::npos);
}

TEST_F(GlTest, APassClearsDrawsAndReadsTexturesIntoItsTarget) {
    const ShaderFiles files;
    files.write("full.vert", kFullScreenVertexShader);
    files.write("tint.frag", kTintedTexture);
    auto program = gl::Program::make({.label = "tint",
                                      .folders = files.folders(),
                                      .vertex_file = "full.vert",
                                      .fragment_file = "tint.frag"});
    ASSERT_TRUE(program) << program.error().message;
    auto image = gl::Texture::make({.label = "image", .size = {1, 1}, .format = Format::Rgba32F});
    ASSERT_TRUE(image);
    image->upload({.size = {1, 1}}, std::vector<float>{0.5f, 2.0f, 8.0f, 1.0f});
    auto target = gl::Framebuffer::make({.label = "target",
                                         .size = {4, 4},
                                         .colors = {{"color", Format::Rgba32F}},
                                         .depth = Format::Depth32F});
    ASSERT_TRUE(target) << target.error().message;
    const gl::VertexArray triangle = gl::VertexArray::make({.label = "triangle"});
    const gl::Sampler sampler = gl::Sampler::make({.label = "sampler", .wrap_u = gl::Wrap::Repeat});
    gl::TimerQuery timer = gl::TimerQuery::make("timer");
    timer.begin();
    {
        gl::Pass pass({.label = "tint",
                       .target = &*target,
                       .viewport = gl::Viewport{.offset = {2, 0}, .size = {2, 4}},
                       .state = {.depth_test = gl::DepthTest::Off},
                       .clear_colors = {{9, 9, 9, 9}},
                       .clear_depth = 1.0f});
        program->set("tint", glm::vec3(1.0f, 0.5f, 0.25f));
        program->set("not_there", 1.0f);
        pass.bind_texture(*program, "image", 0, *image, &sampler);
        pass.draw(*program, triangle, {.count = 3});
    }
    timer.end();
    EXPECT_EQ(target->read_color(0, {3, 1}, {1, 1}), (std::vector<float>{0.5f, 1.0f, 2.0f, 0.5f}));
    EXPECT_TRUE(timer.elapsed_ms().has_value());

    ASSERT_TRUE(target->resize({8, 2}));
    EXPECT_EQ(target->color(0).size(), glm::ivec2(8, 2));
    EXPECT_EQ(target->bytes(), 16u * (16 + 4));
}

TEST_F(GlTest, AnErrorInAnIncludedShaderNamesItsFileAndLine) {
    const ShaderFiles files;
    files.write("full.vert", kFullScreenVertexShader);
    files.write("parts/broken.glsl", "// fine\nfloat half_of(float x) { return x * wrong; }\n");
    files.write("main.frag",
                "#include \"parts/broken.glsl\"\nout vec4 color;\n"
                "void main() { color = vec4(half_of(1.0)); }\n");
    const auto program = gl::Program::make({.label = "broken",
                                            .folders = files.folders(),
                                            .vertex_file = "full.vert",
                                            .fragment_file = "main.frag"});
    ASSERT_FALSE(program);
    EXPECT_NE(program.error().message.find("parts/broken.glsl:2"), std::string::npos)
        << program.error().message;
    EXPECT_EQ(program.error().message.find('\n'), std::string::npos);
}

TEST(ShaderSource, IncludesOnceRemembersLinesAndPutsDefinesFirst) {
    const ShaderFiles files;
    files.write("a.glsl", "float a;\n");
    files.write("main.frag", "#include \"a.glsl\"\n#include \"a.glsl\"\nfloat b;");
    const std::vector<gl::ShaderDefine> defines = {{"SIZE", "4"}};
    const auto source = gl::load_shader_source(files.folders(), "main.frag", defines);
    ASSERT_TRUE(source) << source.error().message;
    EXPECT_TRUE(source->text.starts_with("#version 410 core\n#define SIZE 4\n"));
    EXPECT_TRUE(source->text.ends_with("\nfloat a;\nfloat b;\n")) << source->text;
    EXPECT_EQ(source->lines.back(), (gl::ShaderLine{.file = "main.frag", .line = 3}));
    EXPECT_EQ(source->lines.size(),
              static_cast<std::size_t>(std::count(source->text.begin(), source->text.end(), '\n')));
}

TEST(ShaderSource, MessagesOfAllDriversAreGivenFilesAndLines) {
    const gl::ShaderSource source = {.text = "\n\n", .lines = {{}, {.file = "a.glsl", .line = 7}}};
    EXPECT_EQ(gl::log_with_file_names("0:2(5): error: mesa\n0(2) : error nvidia\nother", source),
              "a.glsl:7(5): error: mesa\na.glsl:7 : error nvidia\nother\n");
    EXPECT_EQ(gl::log_with_file_names("0:99(5): error", source), "0:99(5): error\n");
}

TEST(ShaderSource, MissingAndOutsideFilesAreErrorsThatNameTheIncluder) {
    const ShaderFiles files;
    files.write("main.frag", "\n#include \"none.glsl\"\n");
    files.write("outside.frag", "#include \"../etc/passwd\"\n");
    const auto missing = gl::load_shader_source(files.folders(), "main.frag", {});
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().message.find("none.glsl"), std::string::npos);
    EXPECT_NE(missing.error().message.find("included by main.frag:2"), std::string::npos);
    EXPECT_FALSE(gl::load_shader_source(files.folders(), "outside.frag", {}));
}

}  // namespace
}  // namespace patina

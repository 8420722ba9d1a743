// SPDX-License-Identifier: MIT
#pragma once

/// What the tests of the renderer share: a context without a window in which any OpenGL error fails
/// the test, small scenes, and pixels.

#include <gtest/gtest.h>

#include <cstring>
#include <optional>

#include "gl/headless_test_context.h"
#include "render/renderer.h"
#include "scene/shapes.h"

namespace patina::render {

/// Moves the content of a Result out, or fails the test with its message.
template <typename T>
T value_of(Result<T> result) {
    if (!result) {
        ADD_FAILURE() << result.error().message;
        std::abort();
    }
    return std::move(*result);
}

inline FilteredEnvironment filtered_builtin(std::string_view id) {
    return value_of(
        filter_environment(value_of(builtin_environment(id, 64)), FilterQuality::First));
}

inline ScenePtr scene_of(Mesh mesh, const glm::mat4& world_from_local = glm::mat4(1.0f)) {
    auto scene = std::make_shared<Scene>();
    scene->meshes.push_back(std::move(mesh));
    scene->instances.push_back({.mesh = 0, .world_from_local = world_from_local, .name = "shape"});
    return scene;
}

/// One colour everywhere, with factors alone.
inline SurfaceMaterial constant_surface(const glm::vec3& base_color, float metalness,
                                        float roughness) {
    SurfaceMaterial surface = plain_surface();
    surface[Slot::BaseColor].multiply = glm::vec4(base_color, 1.0f);
    surface[Slot::MetallicRoughness].multiply = glm::vec4(1.0f, roughness, metalness, 1.0f);
    return surface;
}

/// The pixel of an RGBA F32 image.
inline glm::vec4 pixel_of(const Image& image, int x, int y) {
    glm::vec4 pixel;
    std::memcpy(&pixel,
                image.data.data() + static_cast<std::size_t>(y) * image.row_bytes() +
                    static_cast<std::size_t>(x) * sizeof pixel,
                sizeof pixel);
    return pixel;
}

/// A renderer with a sphere of 1 m resting on the floor, seen from the front, in white light.
class RenderTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        renderer_.emplace(value_of(Renderer::create()));
        ASSERT_TRUE(renderer_->set_environment(filtered_builtin("white")));
        show(scene_of(shape_mesh(Shape::Sphere)));
        view_.background.kind = Background::Kind::Transparent;
        view_.anti_aliasing = AntiAliasing::None;
        view_.tone_map = ToneMap::None;
    }
    void TearDown() override {
        renderer_.reset();
        GlTest::TearDown();
    }
    void show(const ScenePtr& scene) {
        ASSERT_TRUE(renderer_->set_scene(scene));
        view_.camera = framed(renderer_->bounds_world(), 1.0f, ViewDirection::Front);
    }
    /// The raw numbers of a channel, one sample in the middle of each pixel.
    Image channel(ChannelView channel, PictureSize size = kSize) {
        View view = view_;
        view.channel = channel;
        return value_of(renderer_->still_linear(view, size, 1));
    }
    /// What a channel holds in the middle of the picture.
    glm::vec3 middle(ChannelView wanted) {
        return glm::vec3(pixel_of(channel(wanted), kSize.width / 2, kSize.height / 2));
    }
    Renderer& renderer() { return *renderer_; }

    static constexpr PictureSize kSize = {64, 64};
    View view_;

  private:
    std::optional<Renderer> renderer_;
};

}  // namespace patina::render

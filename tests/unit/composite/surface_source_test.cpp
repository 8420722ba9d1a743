// SPDX-License-Identifier: MIT

/// Sources that read the model: parts of it, and projections on it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "composite/composite.h"
#include "composite/dilate.h"
#include "composite/small_stack.h"
#include "core/parallel.h"
#include "document/choices.h"
#include "scene/shapes.h"
#include "scene/small_surface.h"

namespace patina {
namespace {

/// Texels a side of the maps of a surface.
constexpr int kSurfaceSide = 48;

std::size_t texel(int x, int y) {
    return static_cast<std::size_t>(y) * kSurfaceSide + static_cast<std::size_t>(x);
}

/// Two parts side by side in the texture, with room around each.
UvSurfacePtr two_parts() {
    FlatPart left = front_quad({0, 0}, {1, 1}, 0, {0.05f, 0.05f}, {0.45f, 0.95f});
    left.name = "Left";
    left.material = "Steel";
    FlatPart right = front_quad({1, 0}, {2, 1}, 0.5f, {0.55f, 0.05f}, {0.95f, 0.95f});
    right.name = "Right";
    right.material = "Rust";
    return surface_of({left, right});
}

/// One quad whose UVs are its places, turned so that its front faces another way.
UvSurfacePtr turned_quad(const glm::mat4& turn) {
    FlatPart quad = front_quad({-0.5f, -0.5f}, {0.5f, 0.5f}, 0, {0, 0}, {1, 1});
    quad.world_from_local = turn;
    return surface_of({quad});
}

glm::mat4 columns(const glm::vec3& right, const glm::vec3& up) {
    glm::mat4 turn(1.0f);
    turn[0] = glm::vec4(right, 0.0f);
    turn[1] = glm::vec4(up, 0.0f);
    turn[2] = glm::vec4(glm::cross(right, up), 0.0f);
    return turn;
}

/// So that the front of a quad faces each way, upright as seen from there.
const std::vector<glm::mat4>& six_turns() {
    static const std::vector<glm::mat4> turns = {
        columns({1, 0, 0}, {0, 1, 0}),  columns({-1, 0, 0}, {0, 1, 0}),
        columns({0, 0, -1}, {0, 1, 0}), columns({0, 0, 1}, {0, 1, 0}),
        columns({1, 0, 0}, {0, 0, -1}), columns({1, 0, 0}, {0, 0, 1})};
    return turns;
}

UvSurfacePtr ball() {
    const auto scene = std::make_shared<Scene>();
    scene->meshes.push_back(shape_mesh(Shape::Sphere));
    std::vector<SurfacePart> parts;
    for (const Primitive& primitive : scene->meshes[0].primitives) {
        parts.push_back({.primitive = &primitive});
        for (const glm::vec3& place : primitive.positions) scene->bounds_world.include(place);
    }
    return std::make_shared<const UvSurface>(scene, std::move(parts), 0);
}

Layer rough(const Source& source) {
    Layer layer{.id = {1}};
    set(layer, Channel::Roughness, source);
    return layer;
}

Layer smooth_through(const GeometrySource& parts) {
    Layer layer = rough(ConstantSource{glm::vec3(1.0f, 0.0f, 0.0f)});
    layer.mask.entries.push_back({.id = {2}, .source = parts});
    return layer;
}

ChannelPlanes planes_on(const UvSurfacePtr& surface, const Layer& layer, Channel channel,
                        ImageTable& images) {
    return bake_channels(Program::compile(stack_of({shared(layer)}), surface), images, kSurfaceSide,
                         {channel})
        .value();
}

PixelVector<float> roughness_on(const UvSurfacePtr& surface, const Layer& layer) {
    ImageTable images;
    return planes_on(surface, layer, Channel::Roughness, images).plane(Channel::Roughness);
}

Hash128 roughness_hash(const Layer& layer, const UvSurfacePtr& surface) {
    return Program::compile(stack_of({shared(layer)}), surface).slot_hash(Slot::MetallicRoughness);
}

ProceduralSource projected(ProceduralKind kind, const Projection& projection) {
    return {.kind = kind, .scale = 4.0f, .projection = projection};
}

const Projection kTriPlanar = {.kind = ProjectionKind::TriPlanar};

TEST(GeometryMask, CoversThePartThatIsNamedUpToTheMiddleOfTheRoomBetweenParts) {
    const auto by_part = roughness_on(two_parts(), smooth_through({.meshes = {"Left", "Gone"}}));
    for (int y = 0; y < kSurfaceSide; ++y)
        for (int x = 0; x < kSurfaceSide; ++x)
            ASSERT_EQ(by_part[texel(x, y)], x < kSurfaceSide / 2 ? 1.0f : 0.5f) << x << ", " << y;
    const auto by_material = roughness_on(two_parts(), smooth_through({.materials = {"Steel"}}));
    EXPECT_EQ(by_part, by_material);
}

TEST(GeometryMask, WithoutAMeshItIsOneEverywhere) {
    const Layer masked = smooth_through({.meshes = {"Left"}});
    const Layer plain = rough(ConstantSource{glm::vec3(1.0f, 0.0f, 0.0f)});
    EXPECT_EQ(roughness_hash(masked, nullptr), roughness_hash(plain, nullptr));
    // As without UVs, in which nothing lies anywhere.
    const UvSurfacePtr no_uvs = surface_of({{.uvs = uv_quad({0, 0}, {1, 1})}}, 1);
    EXPECT_EQ(roughness_hash(masked, no_uvs), roughness_hash(plain, nullptr));
}

TEST(GeometryMask, OfAllPartsOrOfNoneIsNoMaskOrNoLayer) {
    const Layer plain = rough(ConstantSource{glm::vec3(1.0f, 0.0f, 0.0f)});
    const Layer all = smooth_through({.meshes = {"Left"}, .materials = {"Rust"}});
    EXPECT_EQ(roughness_hash(all, two_parts()), roughness_hash(plain, two_parts()));
    const Layer none = smooth_through({.meshes = {"Gone"}});
    EXPECT_EQ(roughness_hash(none, two_parts()),
              Program::compile(stack_of({}), two_parts()).slot_hash(Slot::MetallicRoughness));
}

TEST(GeometryMask, JoinsOtherEntriesAndCanBeInverted) {
    Layer layer = smooth_through({.meshes = {"Left"}});
    layer.mask.entries[0].invert = true;
    layer.mask.entries.push_back(
        {.id = {3}, .source = ConstantSource{glm::vec3(0.5f)}, .combine = BlendMode::Multiply});
    const auto plane = roughness_on(two_parts(), layer);
    EXPECT_EQ(plane[texel(10, 20)], 0.5f);
    EXPECT_EQ(plane[texel(40, 20)], 0.75f);
}

TEST(GeometryMask, FeedsSingleNumbersToo) {
    const auto plane = roughness_on(two_parts(), rough(GeometrySource{.meshes = {"Right"}}));
    EXPECT_EQ(plane[texel(10, 20)], 0.0f);
    EXPECT_EQ(plane[texel(40, 20)], 1.0f);
}

/// How many of the texels are further apart than that.
int differing(const PixelVector<float>& a, const PixelVector<float>& b, float tolerance) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += std::abs(a[i] - b[i]) > tolerance;
    return count;
}

TEST(Projection, WithoutAMeshItIsThatOfTheUvs) {
    const Layer plain = rough(projected(ProceduralKind::PerlinNoise, {}));
    for (const ProjectionKind kind : {ProjectionKind::Planar, ProjectionKind::TriPlanar})
        EXPECT_EQ(roughness_on(nullptr, rough(projected(ProceduralKind::PerlinNoise, {kind}))),
                  roughness_on(nullptr, plain));
}

TEST(Projection, OnAQuadThatLiesInItsUvsShowsEveryPatternAsItsUvsDo) {
    for (std::size_t i = 0; i < kProceduralKinds.size(); ++i) {
        const auto kind = static_cast<ProceduralKind>(i);
        const auto expected = roughness_on(nullptr, rough(projected(kind, {})));
        for (const Projection& projection :
             {Projection{.kind = ProjectionKind::Planar}, kTriPlanar})
            // Cells are decided by the last digit at their borders.
            EXPECT_LE(differing(roughness_on(turned_quad(glm::mat4(1.0f)),
                                             rough(projected(kind, projection))),
                                expected, 0.01f),
                      kSurfaceSide * kSurfaceSide / 50)
                << kProceduralKinds[i].id;
    }
}

TEST(Projection, TriPlanarIsUprightAndUnmirroredFromAllSixSides) {
    ProceduralSource plain = projected(ProceduralKind::PerlinNoise, {});
    plain.transform = {.offset = {0.1f, 0.3f}, .scale = {0.7f, 1.3f}, .rotation_degrees = 20.0f};
    ProceduralSource source = plain;
    source.projection = kTriPlanar;
    const auto expected = roughness_on(nullptr, rough(plain));
    for (const glm::mat4& turn : six_turns())
        EXPECT_EQ(differing(roughness_on(turned_quad(turn), rough(source)), expected, 0.005f), 0);
}

TEST(Projection, PlanarLooksAlongItsAxisThroughTheModel) {
    const auto expected = roughness_on(nullptr, rough(projected(ProceduralKind::Marble, {})));
    for (const auto& [axis, turn] :
         {std::pair(ProjectionAxis::Z, 0), {ProjectionAxis::X, 2}, {ProjectionAxis::Y, 4}}) {
        const Projection along = {.kind = ProjectionKind::Planar, .axis = axis};
        const Layer layer = rough(projected(ProceduralKind::Marble, along));
        const auto& turns = six_turns();
        const auto front = roughness_on(turned_quad(turns[static_cast<std::size_t>(turn)]), layer);
        EXPECT_EQ(differing(front, expected, 0.01f), 0);
        // Behind lies the same, so that it is mirrored as seen from there.
        const auto back =
            roughness_on(turned_quad(turns[static_cast<std::size_t>(turn + 1)]), layer);
        const bool upright = axis != ProjectionAxis::Y;
        for (int y = 0; y < kSurfaceSide; ++y)
            for (int x = 0; x < kSurfaceSide; ++x)
                ASSERT_NEAR(
                    back[upright ? texel(kSurfaceSide - 1 - x, y) : texel(x, kSurfaceSide - 1 - y)],
                    front[texel(x, y)], 0.01f);
    }
}

Image noise_image(int side, int channels) {
    Image image{.width = side, .height = side, .channels = channels, .type = SampleType::U8};
    image.data.resize(image.row_bytes() * static_cast<std::size_t>(side));
    std::mt19937 random(11);
    for (std::byte& value : image.data) value = static_cast<std::byte>(random() % 256);
    return image;
}

TEST(Projection, ShowsImagesAndTheirCoverageAsUvsDo) {
    ImageTable images;
    ImageSource source{.image = images.add(noise_image(16, 4)), .alpha_is_coverage = true};
    const auto expected = planes_on(nullptr, rough(source), Channel::Roughness, images);
    source.projection = kTriPlanar;
    for (const glm::mat4& turn : six_turns()) {
        const auto shown = planes_on(turned_quad(turn), rough(source), Channel::Roughness, images);
        EXPECT_EQ(
            differing(shown.plane(Channel::Roughness), expected.plane(Channel::Roughness), 0.002f),
            0);
    }
}

/// A slope, the same everywhere.
ImageSource slope(ImageTable& images, const glm::vec3& normal) {
    Image image{.width = 1, .height = 1, .channels = 3, .type = SampleType::F32};
    image.data.resize(12);
    const glm::vec3 stored = glm::normalize(normal) * 0.5f + 0.5f;
    std::memcpy(image.data.data(), &stored, 12);
    return {.image = images.add(std::move(image)), .projection = kTriPlanar};
}

TEST(Projection, NormalsLeanTheWayThatThePictureDoesWhateverTheUvsAreLike) {
    ImageTable images;
    const glm::vec3 normal = glm::normalize(glm::vec3(0.4f, 0.2f, 1.0f));
    Layer layer{.id = {1}};
    set(layer, Channel::Normal, slope(images, normal));
    const auto normal_on = [&](const UvSurfacePtr& surface) {
        const ChannelPlanes planes = planes_on(surface, layer, Channel::Normal, images);
        const std::size_t at = texel(20, 30);
        return glm::vec3(planes.plane(Channel::Normal, 0)[at], planes.plane(Channel::Normal, 1)[at],
                         planes.plane(Channel::Normal, 2)[at]);
    };
    for (const glm::mat4& turn : six_turns()) {
        const glm::vec3 shown = normal_on(turned_quad(turn));
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(shown[k], normal[k], 1e-4f);
    }
    // UVs a quarter turned: u runs up the picture, v to its right.
    FlatPart quad = front_quad({-0.5f, -0.5f}, {0.5f, 0.5f}, 0, {0, 0}, {1, 1});
    for (glm::vec2& uv : quad.uvs) uv = {1.0f - uv.y, uv.x};
    const glm::vec3 turned = normal_on(surface_of({quad}));
    EXPECT_NEAR(turned.x, normal.y, 1e-4f);
    EXPECT_NEAR(turned.y, -normal.x, 1e-4f);
    EXPECT_NEAR(turned.z, normal.z, 1e-4f);
}

TEST(Projection, OneValueStaysWhatItIsHoweverSidesAreBlended) {
    ImageTable images;
    Image image{.width = 2, .height = 2, .channels = 1, .type = SampleType::U8};
    image.data.assign(4, std::byte{51});
    ImageSource source{.image = images.add(std::move(image))};
    for (const float blend : {0.0f, 0.3f, 1.0f}) {
        source.projection = {.kind = ProjectionKind::TriPlanar, .blend = blend};
        const auto planes = planes_on(ball(), rough(source), Channel::Roughness, images);
        for (const float value : planes.plane(Channel::Roughness)) ASSERT_NEAR(value, 0.2f, 1e-6f);
    }
}

/// All that reads the model at once.
Material reading_stack(float opacity) {
    Layer lowest = rough(projected(ProceduralKind::Grunge, kTriPlanar));
    set(lowest, Channel::Height, projected(ProceduralKind::Bricks, kTriPlanar));
    Layer above = rough(projected(ProceduralKind::Marble,
                                  {.kind = ProjectionKind::Planar, .axis = ProjectionAxis::Y}));
    above.id = {5};
    above.opacity = opacity;
    above.mask.entries.push_back(
        {.id = {6}, .source = projected(ProceduralKind::Spots, kTriPlanar)});
    above.mask.entries.push_back({.id = {7}, .source = GeometrySource{.meshes = {"Left"}}});
    Layer top = rough(ReferenceSource{.layer = {5}, .result = LayerResult::Mask});
    top.id = {8};
    top.opacity = 0.3f;
    Material material = stack_of({shared(lowest), shared(above), shared(top)});
    return material;
}

TEST(Projection, GivesTheSameTexelsWithAnyNumberOfThreads) {
    ImageTable images;
    const auto hash_with = [&](int threads) {
        const ThreadLimit limit(threads);
        const Program program = Program::compile(reading_stack(0.7f), two_parts());
        const MapSet maps = bake_maps(program, images, 200, maps_of(program)).value();
        Hasher hasher;
        for (const ImagePtr& map : maps.maps)
            if (map) hasher.add(content_hash(*map));
        return hasher.finish();
    };
    EXPECT_EQ(hash_with(1), hash_with(2));
    EXPECT_EQ(hash_with(1), hash_with(16));
}

TEST(Projection, TheLiveCompositeEqualsAColdBakeWholeOrInPart) {
    ImageTable images;
    LiveComposite live;
    const UvSurfacePtr surface = two_parts();
    for (const float opacity : {0.7f, 0.6f, 0.2f, 1.0f}) {
        const Program program = Program::compile(reading_stack(opacity), surface);
        ASSERT_TRUE(live.update(program, images, 96));
        const MapSet cold = bake_maps(program, images, 96, maps_of(program)).value();
        for (const BakedMap map : maps_of(program)) EXPECT_EQ(*live.maps()[map], *cold[map]);
    }
    const Program moved = Program::compile(reading_stack(1.0f), turned_quad(six_turns()[2]));
    EXPECT_FALSE(live.update(moved, images, 96)->changed_maps.empty());
    const MapSet cold = bake_maps(moved, images, 96, maps_of(moved)).value();
    for (const BakedMap map : maps_of(moved)) EXPECT_EQ(*live.maps()[map], *cold[map]);
}

TEST(Projection, AnImageThatIsProjectedIsBakedWhereThereIsAMesh) {
    ImageSource source{.image = {1, 2}, .pick = ChannelPick::Green};
    const auto plan = [&](const Projection& projection) {
        source.projection = projection;
        Layer layer = rough(source);
        ImageSource blue = source;
        blue.pick = ChannelPick::Blue;
        set(layer, Channel::Metalness, blue);
        const Program program = Program::compile(stack_of({shared(layer)}), ball());
        return program.slots()[static_cast<std::size_t>(Slot::MetallicRoughness)];
    };
    EXPECT_TRUE(std::holds_alternative<SlotImage>(plan({})));
    EXPECT_TRUE(std::holds_alternative<SlotBaked>(plan(kTriPlanar)));
}

TEST(Dilation, ChangesNoTexelOfAnIslandAndGivesTheOthersThatOfTheNearest) {
    const UvSurfacePtr surface = two_parts();
    const UvMapPtr map = surface->map(kSurfaceSide);
    auto before = std::make_shared<Image>(noise_image(kSurfaceSide, 4));
    MapSet maps{.size = kSurfaceSide};
    maps.maps[0] = before;
    dilate(*surface, maps);
    ASSERT_NE(maps.maps[0], nullptr);
    const auto pixel = [](const Image& image, int x, int y) {
        std::uint32_t value = 0;
        std::memcpy(&value, image.data.data() + 4 * texel(x, y), 4);
        return value;
    };
    int outside = 0;
    for (int y = 0; y < kSurfaceSide; ++y)
        for (int x = 0; x < kSurfaceSide; ++x) {
            const UvMap::Texel from = map->at(x, y);
            if (map->touched(x, y)) {
                ASSERT_EQ(std::pair(from.x, from.y), std::pair(x, y));
            }
            outside += !map->touched(x, y);
            ASSERT_EQ(pixel(*maps.maps[0], x, y), pixel(*before, from.x, from.y));
        }
    EXPECT_GT(outside, 0);
    MapSet again{.size = kSurfaceSide};
    again.maps[0] = maps.maps[0];
    dilate(*surface, again);
    EXPECT_EQ(*again.maps[0], *maps.maps[0]);
}

}  // namespace
}  // namespace patina

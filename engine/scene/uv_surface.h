// SPDX-License-Identifier: MIT
#pragma once

/// The surface that a material lies on: the triangles of all parts that wear it, laid out in its
/// texture. What a texel shows of the model is asked here: which part, where in space, which way
/// it faces.
///
/// Model space is the scene as it stands, moved and scaled so that its bounds are centred in 0..1
/// and 0..1 long along their longest side: x right, y up, z towards the viewer in front.

#include <cstdint>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "core/hash.h"
#include "scene/scene.h"
#include "scene/uv_triangle.h"

namespace patina {

/// One part: a primitive and where the first node that shows it puts it.
struct SurfacePart {
    const Primitive* primitive = nullptr;  ///< in the scene of the surface
    glm::mat4 world_from_local = glm::mat4(1.0f);
    std::vector<std::string> names = {};  ///< of the part, its mesh and the nodes that show it
    std::string material = {};            ///< that the file gives it
    bool operator==(const SurfacePart&) const = default;
};

/// What lies at a place of the texture, in model space.
struct SurfacePoint {
    glm::vec3 position = glm::vec3(0.0f);
    glm::vec3 normal = glm::vec3(0.0f, 0.0f, 1.0f);  ///< unit
    /// The way u and the way -v run along the surface: unit, at right angles to the normal, as
    /// tangent-space normals are drawn.
    glm::vec3 tangent = glm::vec3(1.0f, 0.0f, 0.0f);
    glm::vec3 bitangent = glm::vec3(0.0f, 1.0f, 0.0f);
};

class UvMap;

/// Immutable; may be asked from several threads.
class UvSurface {
  public:
    /// @param scene  what the parts point into; kept alive
    UvSurface(ScenePtr scene, std::vector<SurfacePart> parts, int uv_set);
    ~UvSurface();
    UvSurface(const UvSurface&) = delete;
    UvSurface& operator=(const UvSurface&) = delete;

    const ScenePtr& scene() const { return scene_; }
    const std::vector<SurfacePart>& parts() const { return parts_; }
    int uv_set() const { return uv_set_; }
    /// Hash of all that decides what it answers.
    const Hash128& hash() const { return hash_; }
    /// Numbered through all parts in order; those without UVs are left out of everything but the
    /// numbers.
    std::uint32_t triangle_count() const { return first_triangles_.back(); }
    /// Whether there is a triangle with UVs.
    bool has_uvs() const { return has_uvs_; }
    /// The length in model space of what is 1 long in the texture, in the mean over the surface.
    float length_per_uv() const { return length_per_uv_; }

    std::size_t part_of(std::uint32_t triangle) const;
    /// Unset for one without UVs.
    std::optional<UvCorners> corners_of(std::uint32_t triangle) const;

    /// What the triangle has at (u, v) of the first tile; of what lies beyond it the nearest that
    /// it has.
    SurfacePoint point_at(std::uint32_t triangle, double u, double v) const;

    /// Which triangle each texel shows, `size` texels a side: 1 to 16384. Made when first asked
    /// for; the last few are kept. Null, with a line in the log, where that is too much work.
    std::shared_ptr<const UvMap> map(int size) const;

  private:
    struct Frames;

    const std::uint32_t* indices_of(std::uint32_t triangle, std::size_t& part) const;
    void measure();

    ScenePtr scene_;
    std::vector<SurfacePart> parts_;
    int uv_set_;
    std::vector<std::uint32_t> first_triangles_ = {0};  ///< of each part; then the count
    std::vector<Frames> frames_;
    Hash128 hash_;
    bool has_uvs_ = false;
    float length_per_uv_ = 1.0f;
    mutable std::mutex mutex_;
    mutable std::vector<std::shared_ptr<const UvMap>> maps_;  ///< the last ones
    mutable std::set<int> sizes_without_map_;
};

using UvSurfacePtr = std::shared_ptr<const UvSurface>;

}  // namespace patina

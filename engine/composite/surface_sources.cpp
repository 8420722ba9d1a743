// SPDX-License-Identifier: MIT
#include "composite/surface_sources.h"

#include <algorithm>

#include "core/formulae/formulae.h"

namespace patina {
namespace {

const Source kAll = ConstantSource{glm::vec3(1.0f, 0.0f, 0.0f)};
const Source kNoSource = ConstantSource{glm::vec3(0.0f)};

bool holds(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_chosen(const GeometrySource& source, const SurfacePart& part) {
    return holds(source.materials, part.material) ||
           std::any_of(part.names.begin(), part.names.end(),
                       [&](const std::string& name) { return holds(source.meshes, name); });
}

void keep(const glm::vec3& value, int at, float (&planes)[3][kTileTexels]) {
    for (int k = 0; k < 3; ++k) planes[k][at] = value[k];
}

formulae::Real3 at(const float (&planes)[3][kTileTexels], int i) {
    return {planes[0][i], planes[1][i], planes[2][i]};
}

/// Fills the planes with the model at the texels of the tile, unless they hold it already.
void look_at_surface(const SurfaceTexels& texels, const TileSpan& span, SurfacePlanes& planes) {
    if (planes.surface == texels.map && planes.span == span) return;
    planes.surface = texels.map;
    planes.span = span;
    const double side = span.size;
    for (int i = 0; i < span.count; ++i) {
        const UvMap::Texel texel = texels.map->at(span.x + i, span.y);
        const SurfacePoint point = texels.surface->point_at(texel.triangle, (texel.x + 0.5) / side,
                                                            (texel.y + 0.5) / side);
        keep(point.position, i, planes.position);
        keep(point.normal, i, planes.normal);
        keep(point.tangent, i, planes.tangent);
        keep(point.bitangent, i, planes.bitangent);
    }
}

/// One source, projected on one tile.
class ProjectedTile {
  public:
    ProjectedTile(const SourceRecord& record, int count, SurfacePlanes& planes)
        : record_(record), count_(count), planes_(planes) {
        for (auto& plane : planes_.sum) std::fill_n(plane, count_, 0.0f);
        const bool planar = record.projection.kind == ProjectionKind::Planar;
        for (int i = 0; i < count_; ++i) {
            const formulae::Real3 weights =
                planar
                    ? formulae::Real3(0.0f)
                    : formulae::projection_weights(at(planes_.normal, i), record.projection.blend);
            keep({weights.x, weights.y, weights.z}, i, planes_.weight);
        }
        if (planar)
            std::fill_n(planes_.weight[static_cast<int>(record.projection.axis)], count_, 1.0f);
    }

    bool shows(int axis) const {
        const float* const weights = planes_.weight[axis];
        return std::any_of(weights, weights + count_, [](float weight) { return weight > 0.0f; });
    }

    /// Of a planar one always the side from which it is projected.
    float side(int axis, int i) const {
        const bool behind =
            record_.projection.kind == ProjectionKind::TriPlanar && planes_.normal[axis][i] < 0.0f;
        return behind ? -1.0f : 1.0f;
    }

    TileCoordinates coordinates(int axis) {
        for (int i = 0; i < count_; ++i) {
            const formulae::Real2 place =
                formulae::projected_place(axis, at(planes_.position, i), side(axis, i));
            planes_.u[i] = record_.to_u.x * place.x + record_.to_u.y * place.y + record_.to_u.z;
            planes_.v[i] = record_.to_v.x * place.x + record_.to_v.y * place.y + record_.to_v.z;
        }
        return {planes_.u, planes_.v};
    }

    void add(int axis, const FetchedSource& source) {
        const float* const weights = planes_.weight[axis];
        const ReadPlane& coverage = source.coverage;
        for (int i = 0; i < count_; ++i)
            planes_.sum[3][i] +=
                weights[i] * coverage.data[static_cast<std::size_t>(i) * coverage.step];
        if (record_.reading == Reading::Normal) return add_normals(axis, source);
        for (int k = 0; k < components(); ++k)
            for (int i = 0; i < count_; ++i)
                planes_.sum[k][i] += weights[i] * source.components[k].data[i];
    }

    FetchedSource finish(float* const target[3], float* coverage) {
        if (record_.reading == Reading::Normal)
            for (int i = 0; i < count_; ++i) {
                const formulae::Real3 unit = formulae::unit_normal(
                    {planes_.sum[0][i], planes_.sum[1][i], planes_.sum[2][i]});
                planes_.sum[0][i] = unit.x;
                planes_.sum[1][i] = unit.y;
                planes_.sum[2][i] = unit.z;
            }
        FetchedSource result{.coverage = {.data = coverage}};
        for (int k = 0; k < components(); ++k) {
            std::copy_n(planes_.sum[k], count_, target[k]);
            result.components[k] = {.data = target[k]};
        }
        std::copy_n(planes_.sum[3], count_, coverage);
        // Weights sum up to 1 but for rounding, and what is opaque is so exactly.
        if (!may_be_clear()) result.coverage = uniform_one();
        return result;
    }

  private:
    bool may_be_clear() const {
        const auto* const image = std::get_if<ImageSource>(&record_.source);
        return image != nullptr && image->alpha_is_coverage;
    }
    int components() const { return is_vector(record_.reading) ? 3 : 1; }

    /// In the frame of the surface: what leans along it, and what stands out of it as it stands out
    /// of the picture.
    void add_normals(int axis, const FetchedSource& source) {
        for (int i = 0; i < count_; ++i) {
            const formulae::Real3 normal(source.components[0].data[i], source.components[1].data[i],
                                         source.components[2].data[i]);
            const formulae::Real3 lean = formulae::projected_lean(axis, normal, side(axis, i));
            const float weight = planes_.weight[axis][i];
            planes_.sum[0][i] += weight * dot(lean, at(planes_.tangent, i));
            planes_.sum[1][i] += weight * dot(lean, at(planes_.bitangent, i));
            planes_.sum[2][i] += weight * normal.z;
        }
    }

    const SourceRecord& record_;
    int count_;
    SurfacePlanes& planes_;
};

}  // namespace

std::vector<std::uint8_t> chosen_parts(const GeometrySource& source, const UvSurface& surface) {
    std::vector<std::uint8_t> chosen;
    for (const SurfacePart& part : surface.parts()) chosen.push_back(is_chosen(source, part));
    return chosen;
}

const Source& resolved_source(const Source& source, const UvSurface* surface) {
    const auto* const geometry = std::get_if<GeometrySource>(&source);
    if (geometry == nullptr) return source;
    if (surface == nullptr) return kAll;
    const std::vector<std::uint8_t> chosen = chosen_parts(*geometry, *surface);
    const auto count = std::count(chosen.begin(), chosen.end(), std::uint8_t{1});
    if (count == 0) return kNoSource;
    return count == static_cast<std::ptrdiff_t>(chosen.size()) ? kAll : source;
}

void fetch_chosen_parts(const SurfaceTexels& texels, const std::vector<std::uint8_t>& chosen,
                        const TileSpan& span, float* to) {
    std::uint32_t last = 0;
    bool value = chosen[texels.surface->part_of(last)] != 0;
    for (int i = 0; i < span.count; ++i) {
        const std::uint32_t triangle = texels.map->at(span.x + i, span.y).triangle;
        if (triangle != last) value = chosen[texels.surface->part_of(triangle)] != 0;
        last = triangle;
        to[i] = value ? 1.0f : 0.0f;
    }
}

FetchedSource fetch_projected(const SourceRecord& record, const SurfaceTexels& texels,
                              const TileSpan& span, float* const target[3], TilePlanes& planes,
                              const ReadAtCoordinates& read) {
    SurfacePlanes& surface = planes.surface();
    look_at_surface(texels, span, surface);
    ProjectedTile tile(record, span.count, surface);
    float* const value[3] = {surface.value[0], surface.value[1], surface.value[2]};
    for (int axis = 0; axis < 3; ++axis)
        if (tile.shows(axis)) tile.add(axis, read(tile.coordinates(axis), value));
    return tile.finish(target, planes.source_coverage());
}

}  // namespace patina

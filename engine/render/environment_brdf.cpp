// SPDX-License-Identifier: MIT
#include "render/environment_brdf.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/formulae/formulae.h"
#include "core/parallel.h"
#include "render/environment.h"

namespace patina::render {
namespace {

constexpr unsigned kSamples = 512;

/// Point i of `count`, spread over the unit square and off its edges, where lobes never end.
formulae::Real2 lobe_point(unsigned i, unsigned count) {
    formulae::Real2 u = formulae::hammersley(i, count);
    u.y = u.y * (1.0f - 1.0f / static_cast<float>(count)) + 0.5f / static_cast<float>(count);
    return u;
}

/// Sums over the directions of a lobe, in the plane of the view: x away from the eye, y along the
/// normal; what lies across is the same on both sides. What is seen of a lobe is its core: the long
/// tail of GGX, which would decide about plain moments, counts less when each direction is weighted
/// by the root of the lobe's own value there too.
class LobeMoments {
  public:
    /// @param weight   of the direction; all of a lobe add up to anything
    /// @param density  of such directions where they are drawn, a steradian
    void add(const glm::dvec2& direction, double weight, double density) {
        const double counted = weight * std::sqrt(weight * density);
        first_ += counted * direction;
        second_ += counted * glm::outerProduct(direction, direction);
        total_ += counted;
    }
    glm::dvec2 axis() const { return glm::normalize(first_); }
    /// The mean square of the distance from the axis, in the plane, along which a lobe is longest.
    double width() const {
        const glm::dvec2 off(axis().y, -axis().x);
        return glm::dot(off, second_ * off) / total_;
    }

  private:
    glm::dvec2 first_{0.0};
    glm::dmat2 second_{0.0};
    double total_ = 0.0;
};

/// How wide each level of the cube is.
using LevelWidths = std::array<double, kPrefilteredLevels>;

LevelWidths level_widths() {
    LevelWidths widths = {};
    for (std::size_t i = 1; i < widths.size(); ++i) {
        const float share = static_cast<float>(i) / (kPrefilteredLevels - 1);
        LobeMoments lobe;
        for (const LobeDirection& each : prefiltered_lobe(prefiltered_roughness(share), kSamples))
            lobe.add({each.direction.x, each.direction.z}, each.weight, 1.0 / each.solid_angle);
        widths[i] = lobe.width();
    }
    return widths;
}

/// Between two levels the cube gives their mix, which is as wide as the mix of their widths.
double level_share_for(double width, const LevelWidths& widths) {
    for (std::size_t i = 1; i < widths.size(); ++i)
        if (width < widths[i])
            return (static_cast<double>(i - 1) +
                    (width - widths[i - 1]) / (widths[i] - widths[i - 1])) /
                   (kPrefilteredLevels - 1);
    return 1.0;
}

formulae::BrdfTerms shared_terms(const PbrTerms& terms) {
    return formulae::ambient_terms({.distribution = static_cast<int>(terms.distribution),
                                    .geometry = static_cast<int>(terms.geometry),
                                    .fresnel = static_cast<int>(terms.fresnel),
                                    .diffuse = static_cast<int>(terms.diffuse)});
}

EnvironmentBrdf table_entry(const formulae::BrdfTerms& terms, float n_dot_v, float roughness,
                            const LevelWidths& widths) {
    const float alpha = formulae::alpha_from_roughness(roughness);
    double scale = 0.0;
    double bias = 0.0;
    LobeMoments lobe;
    for (unsigned i = 0; i < kSamples; ++i) {
        const formulae::SplitSumSample sample =
            formulae::split_sum_sample(terms, lobe_point(i, kSamples), n_dot_v, alpha);
        const double weight = double{sample.scale} + sample.bias;
        if (weight <= 0.0) continue;
        scale += sample.scale;
        bias += sample.bias;
        lobe.add({-sample.light.x, sample.light.z}, weight, sample.density);
    }
    const double sine = std::sqrt(std::max(1.0 - double{n_dot_v} * n_dot_v, 1e-8));
    return {.scale = static_cast<float>(scale / kSamples),
            .bias = static_cast<float>(bias / kSamples),
            .tangent_scale = static_cast<float>(lobe.axis().x / sine),
            .level_share = static_cast<float>(level_share_for(lobe.width(), widths))};
}

EnvironmentDiffuse diffuse_entry(const formulae::BrdfTerms& terms, float n_dot_v, float roughness) {
    double entering = 0.0;
    double grazing = 0.0;
    for (unsigned i = 0; i < kSamples; ++i) {
        const formulae::DiffuseSample sample =
            formulae::diffuse_sample(terms, formulae::hammersley(i, kSamples), n_dot_v, roughness);
        entering += sample.entering;
        grazing += sample.grazing;
    }
    return {static_cast<float>(entering / kSamples), static_cast<float>(grazing / kSamples)};
}

/// A row for each roughness, a column for each n.v, in the middle of each texel.
template <typename Entry, typename Make>
std::vector<Entry> table_of(int size, const Make& make) {
    std::vector<Entry> table(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    const auto middle = [size](std::int64_t i) {
        return (static_cast<float>(i) + 0.5f) / static_cast<float>(size);
    };
    parallel_for(0, size, 2, [&](std::int64_t first, std::int64_t last) {
        for (std::int64_t j = first; j < last; ++j)
            for (int i = 0; i < size; ++i)
                table[static_cast<std::size_t>(j * size + i)] = make(middle(i), middle(j));
    });
    return table;
}

}  // namespace

std::vector<LobeDirection> prefiltered_lobe(float roughness, unsigned count) {
    const float alpha = formulae::alpha_from_roughness(roughness);
    std::vector<LobeDirection> lobe;
    float total = 0.0f;
    for (unsigned i = 0; i < count; ++i) {
        const formulae::Real3 h = formulae::sample_ggx_half_vector(lobe_point(i, count), alpha);
        const glm::vec3 l(2.0f * h.z * h.x, 2.0f * h.z * h.y, 2.0f * h.z * h.z - 1.0f);
        if (l.z <= 0.0f) continue;
        const float density = formulae::ggx_mirrored_density(h.z, h.z, alpha);
        lobe.push_back({l, l.z, 1.0f / (static_cast<float>(count) * density)});
        total += l.z;
    }
    for (LobeDirection& each : lobe) each.weight /= total;
    return lobe;
}

std::vector<EnvironmentBrdf> environment_brdf_table(int size, const PbrTerms& terms) {
    const LevelWidths widths = level_widths();
    return table_of<EnvironmentBrdf>(size, [&](float n_dot_v, float roughness) {
        return table_entry(shared_terms(terms), n_dot_v, roughness, widths);
    });
}

std::vector<EnvironmentDiffuse> environment_diffuse_table(int size, const PbrTerms& terms) {
    return table_of<EnvironmentDiffuse>(size, [&](float n_dot_v, float roughness) {
        return diffuse_entry(shared_terms(terms), n_dot_v, roughness);
    });
}

}  // namespace patina::render

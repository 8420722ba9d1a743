// SPDX-License-Identifier: MIT
#include "render/environment_suns.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <numeric>

namespace patina::render {
namespace {

constexpr float kTimesMedian = 30.0f;
constexpr float kLeastShare = 0.01f;     ///< of all light of the map
constexpr float kWidestRadians = 0.15f;  ///< of a sun's radius; soft boxes are filtered

using Region = std::vector<std::size_t>;  ///< indices of texels

/// The luminance that half of the sphere is darker than.
float median_luminance(const RadianceMap& map) {
    std::vector<std::pair<float, float>> texels;  // luminance, solid angle
    texels.reserve(map.texels.size());
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            texels.emplace_back(luminance_of(map.at(x, y)), texel_solid_angle(map, y));
    // Halves the range that holds it: in order as a whole it would take longer than the filtering.
    auto low = texels.begin();
    auto high = texels.end();
    double below = 0.0;  // steradians of what is before `low`
    while (high - low > 1) {
        const auto middle = low + (high - low) / 2;
        std::nth_element(low, middle, high);
        const double part = std::accumulate(low, middle, 0.0, [](double sum, const auto& texel) {
            return sum + double{texel.second};
        });
        if (below + part >= glm::two_pi<double>()) {
            high = middle;
        } else {
            below += part;
            low = middle;
        }
    }
    return low->first;
}

/// Calls `visit(x, y)` for the eight texels around one; the map goes round.
template <typename Visit>
void for_each_neighbour(const RadianceMap& map, int x, int y, const Visit& visit) {
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            if ((dx == 0 && dy == 0) || y + dy < 0 || y + dy >= map.height) continue;
            visit((x + dx + map.width) % map.width, y + dy);
        }
}

class Regions {
  public:
    Regions(const RadianceMap& map, float threshold) : map_(map), bright_(map.texels.size()) {
        for (std::size_t i = 0; i < bright_.size(); ++i)
            bright_[i] = luminance_of(map.texels[i]) > threshold ? 1 : 0;
    }
    /// Connected texels that are bright; each texel is in one region.
    std::vector<Region> take_all() {
        std::vector<Region> regions;
        for (std::size_t i = 0; i < bright_.size(); ++i)
            if (bright_[i] != 0) regions.push_back(take_from(i));
        return regions;
    }

  private:
    Region take_from(std::size_t first) {
        Region region = {first};
        bright_[first] = 0;
        for (std::size_t next = 0; next < region.size(); ++next) {
            const int x = static_cast<int>(region[next]) % map_.width;
            const int y = static_cast<int>(region[next]) / map_.width;
            for_each_neighbour(map_, x, y, [&](int nx, int ny) {
                const auto i = static_cast<std::size_t>(ny) * static_cast<std::size_t>(map_.width) +
                               static_cast<std::size_t>(nx);
                if (bright_[i] == 0) return;
                bright_[i] = 0;
                region.push_back(i);
            });
        }
        return region;
    }

    const RadianceMap& map_;
    std::vector<std::uint8_t> bright_;
};

struct Candidate {
    Region region;
    glm::vec3 around;  ///< radiance beside it
    EnvironmentSun sun;
};

glm::vec3 mean_around(const RadianceMap& map, const Region& region) {
    std::vector<std::size_t> sorted = region;
    std::sort(sorted.begin(), sorted.end());
    glm::vec3 sum(0.0f);
    float count = 0.0f;
    for (const std::size_t i : region)
        for_each_neighbour(map, static_cast<int>(i) % map.width, static_cast<int>(i) / map.width,
                           [&](int x, int y) {
                               const auto beside = static_cast<std::size_t>(y) *
                                                       static_cast<std::size_t>(map.width) +
                                                   static_cast<std::size_t>(x);
                               if (std::binary_search(sorted.begin(), sorted.end(), beside)) return;
                               sum += map.texels[beside];
                               count += 1.0f;
                           });
    return count > 0.0f ? sum / count : sum;
}

Candidate candidate_of(const RadianceMap& map, Region region) {
    Candidate candidate{.region = std::move(region), .around = {}, .sun = {}};
    candidate.around = mean_around(map, candidate.region);
    glm::dvec3 power(0.0);
    glm::dvec3 direction(0.0);
    double weight = 0.0;
    for (const std::size_t i : candidate.region) {
        const int y = static_cast<int>(i) / map.width;
        const int x = static_cast<int>(i) % map.width;
        const glm::vec3 excess = glm::max(map.texels[i] - candidate.around, glm::vec3(0.0f));
        const glm::dvec3 part = double{texel_solid_angle(map, y)} * glm::dvec3(excess);
        const double share = luminance_of(glm::vec3(part));
        power += part;
        weight += share;
        direction += share * glm::dvec3(texel_direction(map, x, y));
    }
    const double length = glm::length(direction);
    candidate.sun.irradiance_linear = power;
    candidate.sun.towards_map = length > 0.0 ? direction / length : glm::dvec3(0.0, 1.0, 0.0);
    // A disc of that radius has the same mean direction: its length is 1 - radius^2 / 4.
    const double mean_length = weight > 0.0 ? length / weight : 1.0;
    candidate.sun.radius_radians =
        static_cast<float>(2.0 * std::sqrt(std::max(1.0 - mean_length, 0.0)));
    return candidate;
}

double total_light(const RadianceMap& map) {
    double total = 0.0;
    for (int y = 0; y < map.height; ++y) {
        double row = 0.0;
        for (int x = 0; x < map.width; ++x) row += luminance_of(map.at(x, y));
        total += row * texel_solid_angle(map, y);
    }
    return total;
}

}  // namespace

MapWithoutSuns take_out_suns(const RadianceMap& map) {
    MapWithoutSuns result{.suns = {}, .rest = map};
    const float threshold = kTimesMedian * median_luminance(map);
    if (threshold <= 0.0f) return result;
    const double least = kLeastShare * total_light(map);
    std::vector<Candidate> candidates;
    for (Region& region : Regions(map, threshold).take_all()) {
        Candidate candidate = candidate_of(map, std::move(region));
        if (luminance_of(candidate.sun.irradiance_linear) > least &&
            candidate.sun.radius_radians < kWidestRadians)
            candidates.push_back(std::move(candidate));
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return luminance_of(a.sun.irradiance_linear) > luminance_of(b.sun.irradiance_linear);
    });
    if (candidates.size() > kMostSuns) candidates.resize(kMostSuns);
    for (const Candidate& each : candidates) {
        result.suns.push_back(each.sun);
        for (const std::size_t i : each.region)
            result.rest.texels[i] = glm::min(result.rest.texels[i], each.around);
    }
    return result;
}

}  // namespace patina::render

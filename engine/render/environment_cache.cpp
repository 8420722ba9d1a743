// SPDX-License-Identifier: MIT
#include "render/environment_cache.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <span>

#include "core/files.h"
#include "core/user_folder.h"

namespace patina::render {
namespace {

namespace fs = std::filesystem;

/// To be raised with every change of what filter_environment makes or of how it is laid out here.
constexpr std::uint32_t kVersion = 3;

constexpr std::string_view kEnding = ".environment";
constexpr std::uint64_t kLargestFileBytes = std::uint64_t{64} << 20;
constexpr int kLargestFace = 4096;

/// At the front of a file, before the payload.
struct Header {
    std::array<char, 8> magic = {'P', 'A', 'T', 'I', 'N', 'A', 'E', 'N'};
    std::uint32_t version = kVersion;
    std::uint32_t sun_count = 0;
    Hash128 source;
    Hash128 payload;
};
static_assert(sizeof(Header) == 48, "no padding: it would be written undefined");

fs::path file_of(const EnvironmentCache& cache, const Hash128& source) {
    return cache.folder /
           (to_hex(Hasher().add(kVersion).add(source).finish()) + std::string(kEnding));
}

class Writer {
  public:
    template <typename T>
    void add(std::span<const T> values) {
        const auto bytes = std::as_bytes(values);
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }
    void add(const glm::vec3& v) { add(std::span<const float>(&v.x, 3)); }
    void add(int value) { add(std::span<const int>(&value, 1)); }
    void add(const HalfCube& cube) {
        add(cube.face_size);
        add(static_cast<int>(cube.levels.size()));
        for (const std::vector<std::uint16_t>& level : cube.levels)
            add(std::span<const std::uint16_t>(level));
    }
    const Bytes& bytes() const { return bytes_; }

  private:
    Bytes bytes_;
};

/// Reads what Writer wrote. Past the end it gives zeros, and is_whole() says so.
class Reader {
  public:
    explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}
    template <typename T>
    void read(std::span<T> values) {
        if (rest_.size() < values.size_bytes()) {
            failed_ = true;
            return;
        }
        std::memcpy(values.data(), rest_.data(), values.size_bytes());
        rest_ = rest_.subspan(values.size_bytes());
    }
    glm::vec3 vector() {
        glm::vec3 v(0.0f);
        read(std::span<float>(&v.x, 3));
        return v;
    }
    float number() {
        float value = 0.0f;
        read(std::span<float>(&value, 1));
        return value;
    }
    int whole_number() {
        int value = 0;
        read(std::span<int>(&value, 1));
        return value;
    }
    HalfCube cube() {
        std::array<int, 2> sizes = {};
        read(std::span<int>(sizes));
        const auto [face, levels] = sizes;
        if (face < 1 || face > kLargestFace || levels < 1 || levels > 16) failed_ = true;
        HalfCube cube{face, {}};
        for (int i = 0; i < levels && !failed_; ++i) {
            const auto side = static_cast<std::size_t>(face >> i);
            const std::size_t values = 6 * side * side * kHalfCubeChannels;
            if (values == 0 || rest_.size() < values * sizeof(std::uint16_t)) {
                failed_ = true;  // before memory is taken
                break;
            }
            cube.levels.emplace_back(values);
            read(std::span<std::uint16_t>(cube.levels.back()));
        }
        return cube;
    }
    bool is_whole() const { return !failed_ && rest_.empty(); }

  private:
    std::span<const std::byte> rest_;
    bool failed_ = false;
};

Bytes payload_of(const FilteredEnvironment& environment) {
    Writer writer;
    writer.add(environment.specular);
    writer.add(environment.diffuse);
    for (const EnvironmentSun& sun : environment.suns) {
        writer.add(sun.towards_map);
        writer.add(sun.irradiance_linear);
        writer.add(std::span<const float>(&sun.radius_radians, 1));
    }
    writer.add(environment.ambient_linear);
    writer.add(static_cast<int>(environment.keys.size()));
    for (const EnvironmentKey& key : environment.keys) {
        writer.add(key.direction_map);
        writer.add(key.irradiance_linear);
    }
    return writer.bytes();
}

/// All but the map and its backdrop.
std::optional<FilteredEnvironment> environment_from(const Bytes& file, const Hash128& source) {
    Header header;
    if (file.size() < sizeof header) return std::nullopt;
    std::memcpy(&header, file.data(), sizeof header);
    const auto payload = std::span(file).subspan(sizeof header);
    if (header.magic != Header().magic || header.version != kVersion || header.source != source ||
        header.sun_count > kMostSuns || header.payload != hash_bytes(payload))
        return std::nullopt;
    Reader reader(payload);
    FilteredEnvironment environment;
    environment.source = source;
    environment.quality = FilterQuality::Finished;
    environment.specular = reader.cube();
    environment.diffuse = reader.cube();
    for (std::uint32_t i = 0; i < header.sun_count; ++i) {
        EnvironmentSun sun;
        sun.towards_map = reader.vector();
        sun.irradiance_linear = reader.vector();
        sun.radius_radians = reader.number();
        environment.suns.push_back(sun);
    }
    environment.ambient_linear = reader.vector();
    const int key_count = reader.whole_number();
    if (key_count < 1 || key_count > static_cast<int>(kMostKeys)) return std::nullopt;
    environment.keys.resize(static_cast<std::size_t>(key_count));
    for (EnvironmentKey& key : environment.keys) {
        key.direction_map = reader.vector();
        key.irradiance_linear = reader.vector();
    }
    if (!reader.is_whole()) return std::nullopt;
    return environment;
}

struct Kept {
    fs::path file;
    std::uint64_t bytes = 0;
    fs::file_time_type read;
};

/// What lies in the folder, what was read last in front. Other programs may take files away
/// meanwhile.
std::vector<Kept> all_kept(const fs::path& folder) {
    std::vector<Kept> kept;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        std::error_code gone;
        if (at->path().extension() != kEnding || !at->is_regular_file(gone)) continue;
        Kept each{.file = at->path(), .bytes = at->file_size(gone), .read = {}};
        if (!gone) each.read = at->last_write_time(gone);
        if (!gone) kept.push_back(std::move(each));
    }
    std::sort(kept.begin(), kept.end(),
              [](const Kept& a, const Kept& b) { return a.read > b.read; });
    return kept;
}

void keep_within_budget(const EnvironmentCache& cache) {
    std::uint64_t total = 0;
    for (const Kept& each : all_kept(cache.folder)) {
        total += each.bytes;
        std::error_code gone;
        if (total > cache.budget_bytes) fs::remove(each.file, gone);
    }
}

}  // namespace

EnvironmentCache user_environment_cache() {
    const fs::path folder = user_folder("XDG_CACHE_HOME", ".cache");
    return {.folder = folder.empty() ? folder : folder / "environments"};
}

std::optional<FilteredEnvironment> kept_environment(const EnvironmentCache& cache,
                                                    const Image& equirect) {
    if (cache.folder.empty()) return std::nullopt;
    const Hash128 source = content_hash(equirect);
    const fs::path file = file_of(cache, source);
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return std::nullopt;
    const Result<Bytes> bytes = read_file(file, kLargestFileBytes);
    if (!bytes) return std::nullopt;
    std::optional<FilteredEnvironment> environment = environment_from(*bytes, source);
    if (!environment) return std::nullopt;
    if (!set_map(equirect, *environment)) return std::nullopt;
    environment->sky = sky_shares(*environment->map, environment->suns);
    fs::last_write_time(file, fs::file_time_type::clock::now(), error);
    return environment;
}

void keep_environment(const EnvironmentCache& cache, const FilteredEnvironment& environment) {
    if (cache.folder.empty() || environment.quality != FilterQuality::Finished) return;
    std::error_code error;
    fs::create_directories(cache.folder, error);
    if (error) return;
    const Bytes payload = payload_of(environment);
    Header header;
    header.sun_count = static_cast<std::uint32_t>(environment.suns.size());
    header.source = environment.source;
    header.payload = hash_bytes(payload);
    const std::array<std::span<const std::byte>, 2> pieces = {std::as_bytes(std::span(&header, 1)),
                                                              std::span<const std::byte>(payload)};
    if (write_file_atomically(file_of(cache, environment.source), pieces))
        keep_within_budget(cache);
}

Result<FilteredEnvironment> finished_environment(const EnvironmentCache& cache,
                                                 const Image& equirect, const Progress& progress) {
    if (std::optional<FilteredEnvironment> kept = kept_environment(cache, equirect)) return *kept;
    Result<FilteredEnvironment> filtered =
        filter_environment(equirect, FilterQuality::Finished, progress);
    if (filtered) keep_environment(cache, *filtered);
    return filtered;
}

}  // namespace patina::render

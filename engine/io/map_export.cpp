// SPDX-License-Identifier: MIT
#include "io/map_export.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

#include "composite/bake_channels.h"
#include "composite/dilate.h"
#include "composite/operations.h"
#include "io/last_channel.h"
#include "io/packed_bytes.h"
#include "io/packed_channels.h"
#include "io/safe_name.h"

namespace patina::io {
namespace {

int bits_of(const MapExportOptions& options) {
    return options.bits.value_or(options.format == ImageFormat::Exr ? 16 : 8);
}

/// Whether the numbers are kept as floats, colours linear.
bool keeps_floats(const MapExportOptions& options) {
    return options.format == ImageFormat::Exr || options.bits == 32;
}

bool holds_bytes(const MapExportOptions& options) {
    return !keeps_floats(options) && bits_of(options) == 8;
}

ImageFormat format_of(const PackedMap& map, const MapExportOptions& options) {
    const auto named = options.format_of_map.find(map.id);
    if (named != options.format_of_map.end()) return named->second;
    const bool spoilt = options.format == ImageFormat::Jpeg && map.has_normals();
    return spoilt ? ImageFormat::Png : options.format;
}

/// Whether the fourth channel of files cannot be a plain number: floats are multiplied by it, JPEG
/// has none.
bool lacks_alpha(const PackedMap& map, const MapExportOptions& options) {
    return keeps_floats(options) || format_of(map, options) == ImageFormat::Jpeg;
}

SampleType sample_type_of(const MapExportOptions& options) {
    if (keeps_floats(options)) return SampleType::F32;
    return holds_bytes(options) ? SampleType::U8 : SampleType::U16;
}

/// Of maps that are made at once.
constexpr std::uint64_t kBytesTogether = std::uint64_t{512} << 20;

/// Opacity in a file of its own, where that of the colours has no place for it.
std::vector<PackedMap> maps_to_write(const MapExportOptions& options) {
    std::vector<PackedMap> maps(options.packing->maps.begin(), options.packing->maps.end());
    bool has_opacity = false;
    for (PackedMap& map : maps) {
        if (!map.has_opacity() || !lacks_alpha(map, options)) continue;
        has_opacity = true;
        map.channels = 3;
    }
    if (has_opacity)
        maps.push_back({.id = "opacity", .values = {PackedValue{.channel = Channel::Opacity}}});
    return maps;
}

class Exporter {
  public:
    Exporter(const Document& document, ImageProvider& images, const std::filesystem::path& folder,
             const MapExportOptions& options, const Progress& progress)
        : document_(document),
          images_(images),
          folder_(folder),
          options_(options),
          progress_(progress) {}

    Status write_material(const Material& material) {
        const Status written = write_maps(material);
        if (!written)
            return failure("material \"{}\": {}", quoted_for_message(material.name, 60),
                           written.error().message);
        for (auto& [place, path] : written_) files_.push_back(std::move(path));
        written_.clear();
        return {};
    }
    std::vector<std::filesystem::path> take_files() { return std::move(files_); }

  private:
    /// A map in which something varies, and its place among the files of its material.
    struct Wanted {
        std::size_t place;
        PackedMap map;
    };
    /// The maps of 8 bits of one material, and the files of those that a save has encoded.
    struct BakedBytes {
        EncodedMaps encoded;
        MapSet maps;
    };

    Status write_maps(const Material& material) {
        const Program program = Program::compile(document_, material);
        const int size = options_.size.value_or(material.resolution);
        const UvSurfacePtr islands = dilated_by(document_, material, program);
        std::vector<Wanted> of_floats = varying_maps(program);
        if (holds_bytes(options_)) {
            const std::vector<Wanted> of_bytes = taken_out_bytes(of_floats);
            const auto baked = baked_bytes(material, program, islands, size, of_bytes);
            if (!baked) return passed_on(baked);
            for (const Wanted& wanted : of_bytes)
                if (const Status done = write_bytes(material, wanted, *baked, size); !done)
                    return done;
        }
        for (const std::vector<Wanted>& group : made_together(of_floats, size))
            if (const Status written = write_channels(material, program, islands, size, group);
                !written)
                return written;
        return {};
    }

    /// Takes those maps out that are put together of the bytes of baked ones.
    static std::vector<Wanted> taken_out_bytes(std::vector<Wanted>& maps) {
        const auto split = std::stable_partition(maps.begin(), maps.end(), [](const Wanted& each) {
            return !baked_maps_of(each.map).has_value();
        });
        const std::vector<Wanted> taken(split, maps.end());
        maps.erase(split, maps.end());
        return taken;
    }

    /// What a save has baked of the material, of `size`.
    EncodedMaps known_maps(const Material& material, int size) const {
        EncodedMaps known;
        if (options_.baked == nullptr) return known;
        const auto found = options_.baked->find(material.id);
        if (found == options_.baked->end()) return known;
        for (std::size_t i = 0; i < known.size(); ++i)
            if (found->second[i] && found->second[i]->image->width == size)
                known[i] = found->second[i];
        return known;
    }

    /// The baked maps that `wanted` are put together of: those that a save has, and the others.
    Result<BakedBytes> baked_bytes(const Material& material, const Program& program,
                                   const UvSurfacePtr& islands, int size,
                                   const std::vector<Wanted>& wanted) const {
        BakedBytes baked{.encoded = known_maps(material, size), .maps = {}};
        std::set<BakedMap> missing;
        for (const Wanted& each : wanted) {
            const auto needed = baked_maps_of(each.map);
            for (const BakedMap map : *needed)
                if (!baked.encoded[static_cast<std::size_t>(map)]) missing.insert(map);
        }
        auto made = bake_for_files(program, islands, images_, size,
                                   {missing.begin(), missing.end()}, progress_);
        if (!made) return passed_on(made);
        baked.maps = std::move(*made);
        for (std::size_t i = 0; i < baked.encoded.size(); ++i)
            if (baked.encoded[i]) baked.maps.maps[i] = baked.encoded[i]->image;
        return baked;
    }

    std::vector<Wanted> varying_maps(const Program& program) const {
        std::vector<Wanted> wanted;
        for (const PackedMap& map : maps_to_write(options_)) {
            const std::vector<Channel> channels = channels_of({map});
            if (std::any_of(channels.begin(), channels.end(),
                            [&](Channel channel) { return varies(program, channel); }))
                wanted.push_back({wanted.size(), map});
        }
        return wanted;
    }

    static std::vector<PackedMap> maps_of(const std::vector<Wanted>& group) {
        std::vector<PackedMap> maps;
        for (const Wanted& wanted : group) maps.push_back(wanted.map);
        return maps;
    }

    /// In groups that fit into memory together: what their channels share is computed once.
    std::vector<std::vector<Wanted>> made_together(const std::vector<Wanted>& maps,
                                                   int size) const {
        const std::uint64_t texels =
            static_cast<std::uint64_t>(size) * static_cast<std::uint64_t>(size);
        std::vector<std::vector<Wanted>> groups;
        std::uint64_t bytes = 0;
        for (const Wanted& wanted : maps) {
            const std::uint64_t own = texels * static_cast<std::uint64_t>(wanted.map.channels) *
                                      sample_bytes(sample_type_of(options_));
            if (groups.empty() || bytes + own > kBytesTogether) {
                groups.emplace_back();
                bytes = 0;
            }
            groups.back().push_back(wanted);
            bytes += own;
        }
        return groups;
    }

    Status write_channels(const Material& material, const Program& program,
                          const UvSurfacePtr& islands, int size, const std::vector<Wanted>& group) {
        auto made = packed_channels(program, images_, size, maps_of(group),
                                    sample_type_of(options_), progress_);
        if (!made) return passed_on(made);
        for (std::size_t i = 0; i < group.size(); ++i) {
            Image image = std::move((*made)[i]);
            if (const Status written = write_map(material, group[i], islands, image); !written)
                return written;
        }
        return {};
    }

    Status write_bytes(const Material& material, const Wanted& wanted, const BakedBytes& baked,
                       int size) {
        const auto same = same_map(wanted.map, baked.maps, size);
        if (same && format_of(wanted.map, options_) == ImageFormat::Png)
            if (const auto& file = baked.encoded[static_cast<std::size_t>(*same)])
                return write_file(material, wanted, *file->png);
        if (same) return write_image(material, wanted, *baked.maps[*same]);
        const auto image = packed_bytes(wanted.map, baked.maps, size);
        assert(image);
        if (is_opacity_alone(wanted.map) && last_is_one(*image)) return {};
        return write_image(material, wanted, *image);
    }

    Status write_image(const Material& material, const Wanted& wanted, const Image& image) {
        const auto bytes = encode_image(
            image, format_of(wanted.map, options_),
            {.png_level = options_.png_level, .jpeg_quality = options_.jpeg_quality}, progress_);
        if (!bytes) return passed_on(bytes);
        return write_file(material, wanted, *bytes);
    }

    /// All of it 1 says nothing, in a file of its own too.
    static bool is_opacity_alone(const PackedMap& map) {
        return map.channels == 1 && map.values[0].channel == Channel::Opacity;
    }

    Status write_map(const Material& material, const Wanted& wanted, const UvSurfacePtr& islands,
                     Image& image) {
        if (islands != nullptr) dilate(*islands, image);
        if (wanted.map.has_opacity() && last_is_one(image)) image = without_last(image);
        if (is_opacity_alone(wanted.map) && last_is_one(image)) return {};
        const bool half =
            format_of(wanted.map, options_) == ImageFormat::Exr && bits_of(options_) == 16;
        if (!half) return write_image(material, wanted, image);
        const auto bytes = encode_half_exr(image);
        if (!bytes) return passed_on(bytes);
        return write_file(material, wanted, *bytes);
    }

    Status write_file(const Material& material, const Wanted& wanted, const Bytes& bytes) {
        const auto path =
            unused_path(fmt::format("{}_{}", safe_file_name(material.name, 60), wanted.map.id),
                        format_of(wanted.map, options_));
        if (const Status written = write_file_atomically(path, bytes); !written) return written;
        written_.emplace(wanted.place, path);
        return {};
    }

    /// Two materials may have names that become the same.
    std::filesystem::path unused_path(const std::string& name, ImageFormat format) {
        const std::string_view extension = kImageFormats[static_cast<std::size_t>(format)].id;
        std::string unused = name;
        for (int i = 2; !names_.insert(unused).second; ++i) unused = fmt::format("{}-{}", name, i);
        return folder_ / fmt::format("{}.{}", unused, extension);
    }

    const Document& document_;
    ImageProvider& images_;
    const std::filesystem::path& folder_;
    const MapExportOptions& options_;
    const Progress& progress_;
    std::set<std::string> names_;
    std::vector<std::filesystem::path> files_;
    std::map<std::size_t, std::filesystem::path> written_;  ///< of the material at hand
};

/// Whether one map can have a format of its own beside the others' kind of numbers.
Status check_format_of(const std::string& id, ImageFormat format, const MapExportOptions& options) {
    std::string known;
    bool found = false;
    for (const PackedMap& map : maps_to_write(options)) {
        known += (known.empty() ? "" : ", ") + std::string(map.id);
        found = found || map.id == id;
    }
    if (!found)
        return failure("packing {} has no map {}; there are: {}", options.packing->id,
                       quoted_for_message(id, 60), known);
    const bool floats = keeps_floats(options);
    const bool holds = format == ImageFormat::Tiff || (format == ImageFormat::Exr) == floats;
    if (holds && (format != ImageFormat::Jpeg || bits_of(options) == 8)) return {};
    return failure("{} cannot be {} beside maps of {} {}", id,
                   kImageFormats[static_cast<std::size_t>(format)].id, bits_of(options),
                   floats ? "bits in floats" : "bits");
}

}  // namespace

Status check_map_options(const MapExportOptions& options) {
    const int bits = bits_of(options);
    if (bits != 8 && bits != 16 && bits != 32)
        return failure("maps have 8, 16 or 32 bits, not {}", bits);
    if (options.format == ImageFormat::Png && bits == 32)
        return failure("png holds 8 or 16 bits; use tif or exr for 32");
    if (options.format == ImageFormat::Exr && bits == 8)
        return failure("exr holds 16 or 32 bits; use png or tif for 8");
    if (options.format == ImageFormat::Jpeg && bits != 8)
        return failure("jpg holds 8 bits; use png, tif or exr for {}", bits);
    for (const auto& [id, format] : options.format_of_map)
        if (const Status good = check_format_of(id, format, options); !good) return good;
    for (const PackedMap& map : options.packing->maps)
        if (map.channels == 4 && !map.has_opacity() && lacks_alpha(map, options))
            return failure(
                "packing {} keeps data in the alpha of {}, which jpg has not and files of floats "
                "multiply into the other channels; use png, or tif of 8 or 16 bits",
                options.packing->id, map.id);
    return {};
}

std::vector<std::string> warnings_of(const MapExportOptions& options) {
    std::vector<std::string> lines;
    for (const PackedMap& map : options.packing->maps) {
        if (!map.has_normals()) continue;
        if (format_of(map, options) == ImageFormat::Jpeg)
            lines.push_back(fmt::format("{} as jpg: its blocks will show in the light", map.id));
        else if (options.format == ImageFormat::Jpeg && !options.format_of_map.contains(map.id))
            lines.push_back(fmt::format(
                "{0} stays png, since jpg spoils normals; --map-format {0}=jpg insists", map.id));
    }
    return lines;
}

Result<std::vector<std::filesystem::path>> export_maps(const Document& document,
                                                       ImageProvider& images,
                                                       const std::filesystem::path& folder,
                                                       const MapExportOptions& options,
                                                       const Progress& progress) {
    if (const Status good = check_map_options(options); !good) return passed_on(good);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        return failure("{}: cannot make the folder: {}", quoted_for_message(folder.string()),
                       error.message());
    Exporter exporter(document, images, folder, options, progress);
    for (std::size_t i = 0; i < document.materials.size(); ++i) {
        const Material& material = *document.materials[i];
        progress.set_stage(fmt::format("Maps of {}", quoted_for_message(material.name, 60)));
        progress.report(static_cast<float>(i) / static_cast<float>(document.materials.size()));
        if (const Status written = exporter.write_material(material); !written)
            return passed_on(written);
    }
    progress.report(1.0f);
    return exporter.take_files();
}

}  // namespace patina::io

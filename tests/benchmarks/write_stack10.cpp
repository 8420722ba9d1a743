// SPDX-License-Identifier: MIT
#include "write_stack10.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <array>
#include <vector>

#include "core/files.h"
#include "document/preset.h"
#include "io/mesh_to_glb.h"
#include "scene/shapes.h"
#include "stack10.h"

namespace patina::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 6> kModeNames = {"normal",  "multiply", "screen",
                                                   "overlay", "add",      "soft-light"};

/// Patina's own TIFF is compressed, which is not what is measured.
Status write_bare_tiff(const fs::path& path, const Image& image) {
    OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::UINT8);
    spec.attribute("compression", "none");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const auto file = OIIO::ImageOutput::create(path.string());
    if (!file || !file->open(path.string(), spec) ||
        !file->write_image(OIIO::TypeDesc::UINT8, image.data.data()) || !file->close())
        return failure("cannot write {}", path.string());
    return {};
}

/// Writes images and remembers them for the preset.
class Images {
  public:
    explicit Images(const fs::path& folder) : folder_(folder) {}
    Status write(const std::string& name, const Image& image) {
        names_.push_back({.file = name + ".tif", .hash = content_hash(image)});
        return write_bare_tiff(folder_ / names_.back().file, image);
    }
    const std::vector<PresetImage>& names() const { return names_; }

  private:
    const fs::path& folder_;
    std::vector<PresetImage> names_;
};

Status write_images(const Stack10& stack, Images& images) {
    Status written = images.write("base", *stack.base);
    for (std::size_t i = 0; i < kLayers && written; ++i) {
        written = images.write(fmt::format("color{}", i), *stack.color[i]);
        if (written) written = images.write(fmt::format("mask{}", i), *stack.mask[i]);
        if (written) written = images.write(fmt::format("roughness{}", i), *stack.roughness[i]);
    }
    return written;
}

std::string layer_list() {
    std::string text;
    for (int i = 0; i < kLayers; ++i)
        text += fmt::format("{} {} {}\n", kModeNames[static_cast<std::size_t>(mode_of(i))],
                            opacity_of(i), metalness_of(i));
    return text;
}

std::string preset_text(const Images& images) {
    return preset_to_json({.id = "stack10",
                           .name = "Stack 10",
                           .category = "Benchmark",
                           .tags = {},
                           .author = "Patina contributors",
                           .licence = "CC0-1.0",
                           .description = "Ten layers of images.",
                           .knobs = {},
                           .images = images.names(),
                           .layers = stack10_material(BlendSpace::SrgbEncoded).stack});
}

}  // namespace

Status write_stack10(const fs::path& folder, int size) {
    Images images(folder);
    Status written = write_images(stack10(size), images);
    if (written) written = write_file_atomically(folder / "stack10.txt", layer_list());
    if (written) written = write_file_atomically(folder / "stack10.json", preset_text(images));
    if (!written) return written;
    const io::PlainMaterial plain{.name = "Quad"};
    const Bytes quad = io::mesh_to_glb(shape_mesh(Shape::Plane), std::span(&plain, 1));
    return write_file_atomically(folder / "quad.glb", std::span(quad));
}

}  // namespace patina::bench

// SPDX-License-Identifier: MIT
#include "render/interface_image.h"

#include <cassert>
#include <vector>

#include "gl/texture.h"

namespace patina::render {
namespace {

std::vector<std::uint8_t> rgba_of(const Image& image) {
    const auto texels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const auto channels = static_cast<std::size_t>(image.channels);
    const bool grey = channels <= 2;
    const bool has_alpha = channels == 2 || channels == 4;
    std::vector<std::uint8_t> rgba(texels * 4);
    for (std::size_t i = 0; i < texels; ++i) {
        const std::byte* texel = image.data.data() + i * channels;
        for (std::size_t c = 0; c < 3; ++c)
            rgba[4 * i + c] = static_cast<std::uint8_t>(texel[grey ? 0 : c]);
        rgba[4 * i + 3] = has_alpha ? static_cast<std::uint8_t>(texel[channels - 1]) : 255;
    }
    return rgba;
}

}  // namespace

struct InterfaceImage::State {
    gl::Texture texture;
};

InterfaceImage::InterfaceImage(std::unique_ptr<State> state) : state_(std::move(state)) {}
InterfaceImage::~InterfaceImage() = default;
InterfaceImage::InterfaceImage(InterfaceImage&&) noexcept = default;
InterfaceImage& InterfaceImage::operator=(InterfaceImage&&) noexcept = default;

Result<InterfaceImage> InterfaceImage::make(const Image& image) {
    assert(image.type == SampleType::U8);
    const glm::ivec2 size(image.width, image.height);
    Result<gl::Texture> texture = gl::Texture::make({.label = "interface.image",
                                                     .size = size,
                                                     .format = gl::Format::Rgba8,
                                                     .levels = gl::full_level_count(size)});
    if (!texture) return passed_on(texture);
    texture->upload({.size = size}, rgba_of(image));
    texture->generate_mip_levels();
    return InterfaceImage(std::make_unique<State>(State{std::move(*texture)}));
}

std::uintptr_t InterfaceImage::texture() const {
    return state_->texture.name();
}

std::size_t InterfaceImage::bytes() const {
    return state_->texture.bytes();
}

}  // namespace patina::render

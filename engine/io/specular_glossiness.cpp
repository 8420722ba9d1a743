// SPDX-License-Identifier: MIT
#include "io/specular_glossiness.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/formulae/formulae.h"
#include "core/parallel.h"
#include "io/png_writer.h"
#include "io/texture_use.h"
#include "scene/sample_values.h"

namespace patina::io {
namespace {

constexpr const char* kExtension = "KHR_materials_pbrSpecularGlossiness";
constexpr float kDielectricSpecular = 0.04f;
constexpr float kEpsilon = 1e-6f;

/// As the converter beside the extension's specification has it: HSP's brightness (Darel Rex
/// Finley, "HSP color model", 2006).
float perceived_brightness(const glm::vec3& color) {
    const glm::vec3 square = color * color;
    return std::sqrt(formulae::luma_bt601({square.r, square.g, square.b}));
}

float solve_metallic(float diffuse, float specular, float one_minus_specular) {
    if (specular < kDielectricSpecular) return 0.0f;
    const float a = kDielectricSpecular;
    const float b = diffuse * one_minus_specular / (1.0f - kDielectricSpecular) + specular -
                    2.0f * kDielectricSpecular;
    const float c = kDielectricSpecular - specular;
    const float discriminant = std::max(b * b - 4.0f * a * c, 0.0f);
    return std::clamp((-b + std::sqrt(discriminant)) / (2.0f * a), 0.0f, 1.0f);
}

/// A map read at the texels of another size: the mean of the four next ones, by their distance.
class TexelReader {
  public:
    /// @param image  may be null: 1 everywhere
    TexelReader(const Image* image, int width, int height) : image_(image) {
        if (!image) return;
        step_x_ = static_cast<float>(image->width) / static_cast<float>(width);
        step_y_ = static_cast<float>(image->height) / static_cast<float>(height);
    }

    /// rgb in linear light, from sRGB; alpha as it is.
    glm::vec4 at(int x, int y) const {
        if (!image_) return glm::vec4(1.0f);
        if (step_x_ == 1.0f && step_y_ == 1.0f) return texel(x, y);
        const float u = (static_cast<float>(x) + 0.5f) * step_x_ - 0.5f;
        const float v = (static_cast<float>(y) + 0.5f) * step_y_ - 0.5f;
        const int left = static_cast<int>(std::floor(u));
        const int top = static_cast<int>(std::floor(v));
        const glm::vec4 upper =
            glm::mix(texel(left, top), texel(left + 1, top), u - static_cast<float>(left));
        const glm::vec4 lower =
            glm::mix(texel(left, top + 1), texel(left + 1, top + 1), u - static_cast<float>(left));
        return glm::mix(upper, lower, v - static_cast<float>(top));
    }

  private:
    glm::vec4 texel(int x, int y) const {
        const int column = std::clamp(x, 0, image_->width - 1);
        const int row = std::clamp(y, 0, image_->height - 1);
        const int channels = image_->channels;
        glm::vec4 value(1.0f);
        for (int c = 0; c < 3; ++c)
            value[c] = linear_value(*image_, column, row, channels < 3 ? 0 : c);
        if (channels == 2 || channels == 4)
            value.a = std::clamp(stored_value(*image_, column, row, channels - 1), 0.0f, 1.0f);
        return value;
    }

    const Image* image_;
    float step_x_ = 1.0f;
    float step_y_ = 1.0f;
};

std::byte byte_of(float value) {
    return static_cast<std::byte>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

Image blank_image(int width, int height, int channels) {
    Image image{.width = width, .height = height, .channels = channels};
    image.data.resize(image.row_bytes() * static_cast<std::size_t>(height));
    return image;
}

struct ConvertedMaps {
    Image base_color;  ///< sRGB, with alpha where the diffuse map has it
    Image metallic_roughness;
};

ConvertedMaps convert_maps(const Image* diffuse, const Image* specular,
                           const SpecularGlossiness& factors) {
    const auto larger = [&](int Image::*side) {
        return std::max(diffuse ? diffuse->*side : 1, specular ? specular->*side : 1);
    };
    const int width = larger(&Image::width);
    const int height = larger(&Image::height);
    const bool has_alpha = diffuse && (diffuse->channels == 2 || diffuse->channels == 4);
    ConvertedMaps maps = {.base_color = blank_image(width, height, has_alpha ? 4 : 3),
                          .metallic_roughness = blank_image(width, height, 3)};
    const TexelReader diffuse_texels(diffuse, width, height);
    const TexelReader specular_texels(specular, width, height);
    parallel_for(0, height, 16, [&](std::int64_t first, std::int64_t last) {
        for (auto y = static_cast<int>(first); y < static_cast<int>(last); ++y) {
            std::byte* color = maps.base_color.data.data() +
                               static_cast<std::size_t>(y) * maps.base_color.row_bytes();
            std::byte* surface = maps.metallic_roughness.data.data() +
                                 static_cast<std::size_t>(y) * maps.metallic_roughness.row_bytes();
            for (int x = 0; x < width; ++x) {
                const glm::vec4 gloss = specular_texels.at(x, y);
                const MetallicRoughness texel =
                    metallic_roughness_of({.diffuse = diffuse_texels.at(x, y) * factors.diffuse,
                                           .specular = glm::vec3(gloss) * factors.specular,
                                           .glossiness = gloss.a * factors.glossiness});
                for (int c = 0; c < 3; ++c)
                    *color++ = byte_of(formulae::srgb_from_linear(texel.base_color[c]));
                if (has_alpha) *color++ = byte_of(diffuse_texels.at(x, y).a);
                *surface++ = std::byte{255};
                *surface++ = byte_of(texel.roughness);
                *surface++ = byte_of(texel.metallic);
            }
        }
    });
    return maps;
}

class Converter {
  public:
    Converter(tinygltf::Model& model, FileImages& images, ImageStore& store,
              std::vector<std::string>& warnings)
        : model_(model), images_(images), store_(store), warnings_(warnings) {}

    Status convert(std::size_t index) {
        tinygltf::Material& material = model_.materials[index];
        const auto found = material.extensions.find(kExtension);
        if (found == material.extensions.end()) return {};
        const tinygltf::Value extension = std::move(found->second);
        material.extensions.erase(found);
        const SpecularGlossiness factors = factors_of(extension);
        const TextureUse diffuse = texture_use(extension, "diffuseTexture");
        const TextureUse specular = texture_use(extension, "specularGlossinessTexture");
        if (image_index(model_, diffuse) < 0 && image_index(model_, specular) < 0) {
            state_factors(material.pbrMetallicRoughness, metallic_roughness_of(factors));
            return {};
        }
        const bool same_place =
            diffuse.texture < 0 || specular.texture < 0 ||
            (diffuse.uv_set == specular.uv_set && diffuse.transform == specular.transform);
        if (!same_place)
            warnings_.push_back(
                fmt::format("/materials/{}: its diffuse and specular maps lie on different UVs; "
                            "the specular one is left out",
                            index));
        return convert_textures(material, extension, factors, same_place ? specular : TextureUse());
    }

  private:
    static SpecularGlossiness factors_of(const tinygltf::Value& extension) {
        SpecularGlossiness factors;
        numbers_in(extension, "diffuseFactor", std::span(&factors.diffuse.x, 4));
        numbers_in(extension, "specularFactor", std::span(&factors.specular.x, 3));
        factors.glossiness = static_cast<float>(number_in(extension, "glossinessFactor", 1.0));
        factors.diffuse = glm::clamp(factors.diffuse, 0.0f, 1.0f);
        factors.specular = glm::clamp(factors.specular, 0.0f, 1.0f);
        factors.glossiness = std::clamp(factors.glossiness, 0.0f, 1.0f);
        return factors;
    }

    static void state_factors(tinygltf::PbrMetallicRoughness& pbr, const MetallicRoughness& value) {
        pbr = {};
        for (int i = 0; i < 4; ++i)
            pbr.baseColorFactor[static_cast<std::size_t>(i)] =
                static_cast<double>(value.base_color[i]);
        pbr.metallicFactor = static_cast<double>(value.metallic);
        pbr.roughnessFactor = static_cast<double>(value.roughness);
    }

    Status convert_textures(tinygltf::Material& material, const tinygltf::Value& extension,
                            const SpecularGlossiness& factors, const TextureUse& specular) {
        const TextureUse diffuse = texture_use(extension, "diffuseTexture");
        const auto diffuse_pixels = pixels_of(diffuse);
        if (!diffuse_pixels) return passed_on(diffuse_pixels);
        const auto specular_pixels = pixels_of(specular);
        if (!specular_pixels) return passed_on(specular_pixels);
        const ConvertedMaps maps =
            convert_maps(diffuse_pixels->get(), specular_pixels->get(), factors);
        const bool like_diffuse = *diffuse_pixels != nullptr;
        const char* key = like_diffuse ? "diffuseTexture" : "specularGlossinessTexture";
        const int sampler =
            model_.textures[static_cast<std::size_t>((like_diffuse ? diffuse : specular).texture)]
                .sampler;
        const std::string name =
            material.name.empty() ? "Material" : quoted_for_message(material.name, 60);
        state_factors(material.pbrMetallicRoughness,
                      {.base_color = glm::vec4(1.0f, 1.0f, 1.0f, factors.diffuse.a),
                       .metallic = 1.0f,
                       .roughness = 1.0f});
        const auto color = add_texture(maps.base_color, name + " base-color", sampler);
        if (!color) return passed_on(color);
        const auto surface =
            add_texture(maps.metallic_roughness, name + " metallic-roughness", sampler);
        if (!surface) return passed_on(surface);
        tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
        place_like(extension.Get(key), *color, pbr.baseColorTexture);
        place_like(extension.Get(key), *surface, pbr.metallicRoughnessTexture);
        return {};
    }

    /// Null where the use shows no image.
    Result<ImagePtr> pixels_of(const TextureUse& use) {
        const int image = image_index(model_, use);
        if (image < 0) return ImagePtr();
        const ImageAssetPtr& asset = images_[static_cast<std::size_t>(image)];
        return asset ? store_.pixels(asset->hash) : Result<ImagePtr>(ImagePtr());
    }

    /// @return the index of the new texture
    Result<int> add_texture(const Image& image, const std::string& name, int sampler) {
        auto png = encode_png(image);
        if (!png) return passed_on(png);
        const auto asset = store_.add(std::make_shared<const Bytes>(std::move(*png)), name);
        if (!asset) return passed_on(asset);
        images_.push_back(*asset);
        model_.images.emplace_back().name = name;
        tinygltf::Texture& texture = model_.textures.emplace_back();
        texture.source = static_cast<int>(images_.size()) - 1;
        texture.sampler = sampler;
        return static_cast<int>(model_.textures.size()) - 1;
    }

    static void place_like(const tinygltf::Value& slot, int texture, tinygltf::TextureInfo& info) {
        info.index = texture;
        info.texCoord = std::max(index_in(slot, "texCoord"), 0);
        if (slot.Has("extensions") && slot.Get("extensions").Has(kTextureTransform))
            info.extensions[kTextureTransform] = slot.Get("extensions").Get(kTextureTransform);
    }

    tinygltf::Model& model_;
    FileImages& images_;
    ImageStore& store_;
    std::vector<std::string>& warnings_;
};

}  // namespace

MetallicRoughness metallic_roughness_of(const SpecularGlossiness& texel) {
    const glm::vec3 diffuse(texel.diffuse);
    const glm::vec3& specular = texel.specular;
    const float one_minus_specular = 1.0f - std::max({specular.r, specular.g, specular.b});
    const float metallic = solve_metallic(perceived_brightness(diffuse),
                                          perceived_brightness(specular), one_minus_specular);
    const glm::vec3 from_diffuse = diffuse * (one_minus_specular / (1.0f - kDielectricSpecular) /
                                              std::max(1.0f - metallic, kEpsilon));
    const glm::vec3 from_specular =
        (specular - kDielectricSpecular * (1.0f - metallic)) / std::max(metallic, kEpsilon);
    const glm::vec3 color =
        glm::clamp(glm::mix(from_diffuse, from_specular, metallic * metallic), 0.0f, 1.0f);
    return {.base_color = glm::vec4(color, texel.diffuse.a),
            .metallic = metallic,
            .roughness = 1.0f - texel.glossiness};
}

Status convert_specular_glossiness(tinygltf::Model& model, FileImages& images, ImageStore& store,
                                   std::vector<std::string>& warnings) {
    Converter converter(model, images, store, warnings);
    for (std::size_t i = 0; i < model.materials.size(); ++i)
        if (const auto converted = converter.convert(i); !converted)
            return failure("/materials/{}: {}", i, converted.error().message);
    return {};
}

}  // namespace patina::io

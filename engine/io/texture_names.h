// SPDX-License-Identifier: MIT
#pragma once

/// What a texture is for, guessed from the name of its file.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "document/channel.h"
#include "document/source.h"

namespace patina::io {

/// One channel that a texture feeds.
struct TextureChannel {
    Channel channel = Channel::BaseColor;
    ChannelPick pick = ChannelPick::Rgb;
    bool invert = false;  ///< gloss and smoothness are the opposite of roughness
    bool operator==(const TextureChannel&) const = default;
};

struct TextureGuess {
    std::vector<TextureChannel> channels;  ///< empty: nothing in the name says what it is
    bool directx_normal = false;
    std::string word;    ///< of the name, that the guess rests on
    int preference = 0;  ///< of two for one channel the higher one is taken
    /// The words of the name on both sides of `word`, joined by "_", resolutions and formats left
    /// out: "metal_plate" and "" of "Metal-Plate_rough_2k.png".
    std::string before = {};
    std::string after = {};
    /// What tells one material's textures from another's.
    const std::string& stem() const { return before.empty() ? after : before; }
};

/// Guesses from the last word of a file's name that means something: "wood_rough_2k.png",
/// "Bricks_NormalGL.jpg", "T_Rock_ORM.tga", "Suzanne_MetallicRoughness.png". Resolutions and
/// version numbers are passed over; capitals and separators do not matter.
TextureGuess guess_texture(std::string_view file_name);

/// The words of a name as TextureGuess::before has them.
std::string words_as_stem(std::string_view name);

}  // namespace patina::io

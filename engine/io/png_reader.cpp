// SPDX-License-Identifier: MIT
#include "io/png_reader.h"

#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <vector>

#include "io/png_unfilter.h"

namespace patina::io {
namespace {

using ByteSpan = std::span<const std::byte>;

constexpr std::size_t kSignatureBytes = 8;
constexpr std::uint32_t kLargestLength = 0x7FFFFFFF;

enum ColorType : std::uint8_t { Grey = 0, Rgb = 2, Palette = 3, GreyAlpha = 4, Rgba = 6 };

/// What the chunks before the pixels say, and where the pixels are.
struct PngFile {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    int bit_depth = 0;
    ColorType color_type = Grey;
    bool interlaced = false;
    std::array<std::array<std::uint8_t, 4>, 256> palette = {};  ///< RGBA; opaque black beyond it
    std::size_t palette_size = 0;
    bool has_transparency = false;
    std::array<std::uint16_t, 3> transparent_color = {};  ///< of grey and RGB
    std::vector<ByteSpan> pixel_data;                     ///< IDAT chunks

    /// Samples of a pixel as they are stored.
    int stored_channels() const {
        switch (color_type) {
            case Grey:
            case Palette:
                return 1;
            case GreyAlpha:
                return 2;
            case Rgb:
                return 3;
            case Rgba:
                return 4;
        }
        return 1;
    }
    int channels() const {
        const int colors = color_type == Palette ? 3 : stored_channels();
        return colors + (has_transparency ? 1 : 0);
    }
    SampleType sample_type() const { return bit_depth == 16 ? SampleType::U16 : SampleType::U8; }
    std::size_t stored_row_bytes(std::uint32_t pixels) const {
        return (std::size_t{pixels} * static_cast<std::size_t>(stored_channels() * bit_depth) + 7) /
               8;
    }
    /// The distance that filters look back.
    std::size_t filter_bytes() const {
        return static_cast<std::size_t>(std::max(1, stored_channels() * bit_depth / 8));
    }
    std::size_t pixel_bytes() const {
        return static_cast<std::size_t>(channels()) * sample_bytes(sample_type());
    }
};

std::uint32_t big_endian(const std::byte* at) {
    return std::to_integer<std::uint32_t>(at[0]) << 24 |
           std::to_integer<std::uint32_t>(at[1]) << 16 |
           std::to_integer<std::uint32_t>(at[2]) << 8 | std::to_integer<std::uint32_t>(at[3]);
}
std::uint16_t big_endian_16(const std::byte* at) {
    return static_cast<std::uint16_t>(std::to_integer<unsigned>(at[0]) << 8 |
                                      std::to_integer<unsigned>(at[1]));
}

bool is_allowed(int color_type, int bit_depth) {
    const bool is_power = bit_depth == 1 || bit_depth == 2 || bit_depth == 4;
    const bool is_byte = bit_depth == 8;
    switch (color_type) {
        case Grey:
            return is_power || is_byte || bit_depth == 16;
        case Palette:
            return is_power || is_byte;
        case Rgb:
        case GreyAlpha:
        case Rgba:
            return is_byte || bit_depth == 16;
        default:
            return false;
    }
}

Status read_ihdr(ByteSpan data, PngFile& png) {
    if (data.size() != 13) return failure("PNG: the header has the wrong length");
    png.width = big_endian(data.data());
    png.height = big_endian(data.data() + 4);
    png.bit_depth = std::to_integer<int>(data[8]);
    const int color_type = std::to_integer<int>(data[9]);
    if (png.width == 0 || png.height == 0 || png.width > kLargestLength ||
        png.height > kLargestLength)
        return failure("PNG: a size of {} x {} pixels", png.width, png.height);
    if (!is_allowed(color_type, png.bit_depth) || data[10] != std::byte{0} ||
        data[11] != std::byte{0} || data[12] > std::byte{1})
        return failure("PNG: the header states a layout that does not exist");
    png.color_type = static_cast<ColorType>(color_type);
    png.interlaced = data[12] == std::byte{1};
    return {};
}

Status read_palette(ByteSpan data, PngFile& png) {
    if (data.size() % 3 != 0 || data.size() > 3 * png.palette.size())
        return failure("PNG: the palette has the wrong length");
    png.palette_size = data.size() / 3;
    for (std::size_t i = 0; i < data.size(); ++i)
        png.palette[i / 3][i % 3] = std::to_integer<std::uint8_t>(data[i]);
    return {};
}

/// Chunks of transparency that do not fit the image are ignored, as they are elsewhere.
void read_transparency(ByteSpan data, PngFile& png) {
    if (png.color_type == Palette) {
        for (std::size_t i = 0; i < std::min(data.size(), png.palette.size()); ++i)
            png.palette[i][3] = std::to_integer<std::uint8_t>(data[i]);
        png.has_transparency = true;
    } else if (png.color_type == Grey || png.color_type == Rgb) {
        const auto samples = static_cast<std::size_t>(png.stored_channels());
        if (data.size() != 2 * samples) return;
        for (std::size_t i = 0; i < samples; ++i)
            png.transparent_color[i] = big_endian_16(data.data() + 2 * i);
        png.has_transparency = true;
    }
}

constexpr std::uint32_t chunk_name(const char (&name)[5]) {
    return static_cast<std::uint32_t>(name[0]) << 24 | static_cast<std::uint32_t>(name[1]) << 16 |
           static_cast<std::uint32_t>(name[2]) << 8 | static_cast<std::uint32_t>(name[3]);
}

bool crc_is_right(ByteSpan name_and_data, const std::byte* stored) {
    const auto* const bytes = reinterpret_cast<const unsigned char*>(name_and_data.data());
    return crc32_gzip_refl(0, bytes, name_and_data.size()) == big_endian(stored);
}

struct ReadChunk {
    std::uint32_t name = 0;
    ByteSpan data;
    bool intact = false;
};
/// The next chunk; `bytes` is moved past it.
Result<ReadChunk> take_png_chunk(ByteSpan& bytes) {
    constexpr std::size_t kAround = 12;  // length, name, CRC
    if (bytes.size() < kAround) return failure("PNG: cut off");
    const std::uint32_t length = big_endian(bytes.data());
    if (length > kLargestLength || length > bytes.size() - kAround) return failure("PNG: cut off");
    ReadChunk chunk;
    chunk.name = big_endian(bytes.data() + 4);
    chunk.data = bytes.subspan(8, length);
    chunk.intact = crc_is_right(bytes.subspan(4, 4 + length), bytes.data() + 8 + length);
    bytes = bytes.subspan(kAround + length);
    return chunk;
}

/// @param with_pixels  false: stop before the first IDAT
Result<PngFile> read_chunks(ByteSpan encoded, bool with_pixels) {
    ByteSpan rest = encoded.subspan(std::min(kSignatureBytes, encoded.size()));
    PngFile png;
    for (auto& color : png.palette) color[3] = 255;
    const auto header = take_png_chunk(rest);
    if (!header || header->name != chunk_name("IHDR") || !header->intact)
        return failure("PNG: damaged header");
    if (const auto status = read_ihdr(header->data, png); !status) return passed_on(status);
    while (!rest.empty()) {
        const auto chunk = take_png_chunk(rest);
        if (!chunk && !png.pixel_data.empty()) break;  // the pixels may be complete all the same
        if (!chunk) return passed_on(chunk);
        if (chunk->name == chunk_name("IEND")) break;
        if (chunk->name == chunk_name("IDAT")) {
            if (!with_pixels) break;
            if (!chunk->intact) return failure("PNG: damaged pixel data");
            png.pixel_data.push_back(chunk->data);
        } else if (chunk->name == chunk_name("PLTE")) {
            if (!chunk->intact) return failure("PNG: damaged palette");
            if (const auto status = read_palette(chunk->data, png); !status)
                return passed_on(status);
        } else if (chunk->name == chunk_name("tRNS") && chunk->intact) {
            read_transparency(chunk->data, png);
        }
    }
    if (png.color_type == Palette && png.palette_size == 0)
        return failure("PNG: the palette is missing");
    return png;
}

/// The bytes inside the zlib stream that the IDAT chunks hold together.
class InflatedStream {
  public:
    explicit InflatedStream(const std::vector<ByteSpan>& chunks)
        : chunks_(chunks), state_(std::make_unique<inflate_state>()) {
        isal_inflate_init(state_.get());
        state_->crc_flag = ISAL_ZLIB;
    }

    Status read(std::span<std::uint8_t> out) {
        state_->next_out = out.data();
        state_->avail_out = static_cast<std::uint32_t>(out.size());
        while (state_->avail_out > 0) {
            if (state_->block_state == ISAL_BLOCK_FINISH)
                return failure("PNG: the pixel data ends too early");
            if (state_->avail_in == 0 && !next_chunk())
                return failure("PNG: the pixel data ends too early");
            if (isal_inflate(state_.get()) != ISAL_DECOMP_OK)
                return failure("PNG: damaged pixel data");
        }
        return {};
    }

  private:
    bool next_chunk() {
        while (chunk_ < chunks_.size()) {
            const ByteSpan chunk = chunks_[chunk_++];
            if (chunk.empty()) continue;
            // ISA-L takes its input as mutable and leaves it alone.
            auto* const bytes = const_cast<std::byte*>(chunk.data());
            state_->next_in = reinterpret_cast<std::uint8_t*>(bytes);
            state_->avail_in = static_cast<std::uint32_t>(chunk.size());
            return true;
        }
        return false;
    }

    const std::vector<ByteSpan>& chunks_;
    std::unique_ptr<inflate_state> state_;
    std::size_t chunk_ = 0;
};

/// Samples of fewer than 16 bits, one byte each.
std::uint8_t stored_sample(const std::uint8_t* row, std::size_t index, int bits) {
    if (bits == 8) return row[index];
    const std::size_t bit = index * static_cast<std::size_t>(bits);
    const int shift = 8 - bits - static_cast<int>(bit % 8);
    return static_cast<std::uint8_t>(row[bit / 8] >> shift & ((1 << bits) - 1));
}

void expand_palette_row(const PngFile& png, const std::uint8_t* row, std::size_t pixels,
                        std::uint8_t* out) {
    const auto channels = static_cast<std::size_t>(png.channels());
    for (std::size_t i = 0; i < pixels; ++i)
        std::memcpy(out + i * channels, png.palette[stored_sample(row, i, png.bit_depth)].data(),
                    channels);
}

/// 8 bits and fewer: samples are stretched to 0..255; a transparent colour makes an alpha.
void expand_row_8(const PngFile& png, const std::uint8_t* row, std::size_t pixels,
                  std::uint8_t* out) {
    const auto samples = static_cast<std::size_t>(png.stored_channels());
    const int stretch = 255 / ((1 << png.bit_depth) - 1);
    for (std::size_t i = 0; i < pixels; ++i) {
        bool is_transparent = true;
        for (std::size_t k = 0; k < samples; ++k) {
            const std::uint8_t sample = stored_sample(row, i * samples + k, png.bit_depth);
            if (png.has_transparency) is_transparent &= sample == png.transparent_color[k];
            *out++ = static_cast<std::uint8_t>(sample * stretch);
        }
        if (png.has_transparency) *out++ = is_transparent ? 0 : 255;
    }
}

void expand_row_16(const PngFile& png, const std::uint8_t* row, std::size_t pixels,
                   std::uint8_t* out) {
    const auto samples = static_cast<std::size_t>(png.stored_channels());
    const auto put = [&](std::uint16_t value) {
        std::memcpy(out, &value, sizeof value);
        out += sizeof value;
    };
    for (std::size_t i = 0; i < pixels; ++i) {
        bool is_transparent = true;
        for (std::size_t k = 0; k < samples; ++k, row += 2) {
            const auto sample = static_cast<std::uint16_t>(row[0] << 8 | row[1]);
            if (png.has_transparency) is_transparent &= sample == png.transparent_color[k];
            put(sample);
        }
        if (png.has_transparency) put(is_transparent ? 0 : 0xFFFF);
    }
}

void expand_row(const PngFile& png, const std::uint8_t* row, std::size_t pixels,
                std::uint8_t* out) {
    if (png.color_type == Palette) return expand_palette_row(png, row, pixels, out);
    if (png.bit_depth == 16) return expand_row_16(png, row, pixels, out);
    if (png.bit_depth < 8 || png.has_transparency) return expand_row_8(png, row, pixels, out);
    std::memcpy(out, row, png.stored_row_bytes(static_cast<std::uint32_t>(pixels)));
}

/// Reads `rows` rows of `pixels` pixels, unfilters them and hands each to `use(row number, bytes)`.
template <typename Use>
Status read_rows(const PngFile& png, InflatedStream& stream, std::uint32_t pixels,
                 std::uint32_t rows, Use&& use) {
    const std::size_t row_bytes = png.stored_row_bytes(pixels);
    const std::size_t stride = 1 + row_bytes;
    // Inflating many rows at once costs less than one by one.
    const std::size_t rows_at_once =
        std::clamp<std::size_t>((std::size_t{1} << 18) / stride, 1, rows);
    std::vector<std::uint8_t> block(rows_at_once * stride);
    std::vector<std::uint8_t> previous(row_bytes, 0);
    for (std::uint32_t first = 0; first < rows;) {
        const std::size_t count = std::min<std::size_t>(rows_at_once, rows - first);
        if (const auto status = stream.read(std::span(block).first(count * stride)); !status)
            return status;
        const std::uint8_t* above = previous.data();
        for (std::size_t i = 0; i < count; ++i) {
            std::uint8_t* const row = block.data() + i * stride + 1;
            if (!unfilter_png_row(row[-1], row, above, row_bytes, png.filter_bytes()))
                return failure("PNG: damaged pixel data");
            use(first + static_cast<std::uint32_t>(i), row);
            above = row;
        }
        std::copy_n(above, row_bytes, previous.begin());
        first += static_cast<std::uint32_t>(count);
    }
    return {};
}

/// Adam7 (PNG 1.2, section 2.6): where each pass begins and how far apart its pixels are.
struct Pass {
    std::uint32_t x, y, step_x, step_y;
};
constexpr std::array<Pass, 7> kPasses = {{{0, 0, 8, 8},
                                          {4, 0, 8, 8},
                                          {0, 4, 4, 8},
                                          {2, 0, 4, 4},
                                          {0, 2, 2, 4},
                                          {1, 0, 2, 2},
                                          {0, 1, 1, 2}}};

Status read_interlaced(const PngFile& png, InflatedStream& stream, std::uint8_t* out) {
    const std::size_t pixel_bytes = png.pixel_bytes();
    std::vector<std::uint8_t> expanded(png.width * pixel_bytes);
    for (const Pass& pass : kPasses) {
        if (pass.x >= png.width || pass.y >= png.height) continue;
        const std::uint32_t columns = (png.width - pass.x + pass.step_x - 1) / pass.step_x;
        const std::uint32_t rows = (png.height - pass.y + pass.step_y - 1) / pass.step_y;
        const auto scatter = [&](std::uint32_t row, const std::uint8_t* bytes) {
            expand_row(png, bytes, columns, expanded.data());
            const std::size_t y = pass.y + std::size_t{row} * pass.step_y;
            for (std::uint32_t i = 0; i < columns; ++i) {
                const std::size_t x = pass.x + std::size_t{i} * pass.step_x;
                std::memcpy(out + (y * png.width + x) * pixel_bytes,
                            expanded.data() + i * pixel_bytes, pixel_bytes);
            }
        };
        if (const auto status = read_rows(png, stream, columns, rows, scatter); !status)
            return status;
    }
    return {};
}

Status read_pixels(const PngFile& png, std::uint8_t* out) {
    InflatedStream stream(png.pixel_data);
    if (png.interlaced) return read_interlaced(png, stream, out);
    const std::size_t out_row_bytes = png.width * png.pixel_bytes();
    return read_rows(png, stream, png.width, png.height,
                     [&](std::uint32_t row, const std::uint8_t* bytes) {
                         expand_row(png, bytes, png.width, out + row * out_row_bytes);
                     });
}

}  // namespace

Result<ImageHeader> read_png_header(ByteSpan encoded) {
    const auto png = read_chunks(encoded, false);
    if (!png) return passed_on(png);
    return ImageHeader{.width = static_cast<int>(png->width),
                       .height = static_cast<int>(png->height),
                       .channels = png->channels(),
                       .type = png->sample_type(),
                       .format = "png"};
}

Result<ImagePtr> decode_png(ByteSpan encoded) {
    const auto png = read_chunks(encoded, true);
    if (!png) return passed_on(png);
    auto image = std::make_shared<Image>();
    image->width = static_cast<int>(png->width);
    image->height = static_cast<int>(png->height);
    image->channels = png->channels();
    image->type = png->sample_type();
    image->data.resize(std::size_t{png->width} * png->height * png->pixel_bytes());
    const auto status = read_pixels(*png, reinterpret_cast<std::uint8_t*>(image->data.data()));
    if (!status) return passed_on(status);
    return image;
}

}  // namespace patina::io

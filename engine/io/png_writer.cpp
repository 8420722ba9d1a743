// SPDX-License-Identifier: MIT
#include "io/png_writer.h"

#include "core/parallel.h"
#include "io/png_filter.h"

#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>

namespace patina::io {
namespace {

constexpr int kMaxSide = 16384;
constexpr std::size_t kStripBytes = std::size_t{1} << 20;
constexpr std::array<unsigned char, 8> kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
/// Deflate, 32 KiB window, no dictionary, fastest; a multiple of 31 as RFC 1950 wants.
constexpr std::array<unsigned char, 2> kZlibHeader = {0x78, 0x01};
constexpr std::size_t kChunkHead = 8;  // length and type
constexpr std::size_t kChunkCrc = 4;

/// How the file stores the image's rows.
struct RowLayout {
    int channels = 0;
    std::size_t sample = 1;     ///< bytes
    std::size_t row_bytes = 0;  ///< without the filter's number

    std::size_t pixel_bytes() const { return static_cast<std::size_t>(channels) * sample; }
};

void put_u32(unsigned char* at, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) at[i] = static_cast<unsigned char>(value >> (24 - 8 * i));
}

/// A chunk being filled: room for its head, then data, then its CRC once it is closed.
class PngChunk {
  public:
    explicit PngChunk(std::string_view type) : bytes_(kChunkHead) {
        std::memcpy(bytes_.data() + 4, type.data(), 4);
    }
    void append(std::span<const unsigned char> data) {
        bytes_.insert(bytes_.end(), data.begin(), data.end());
    }
    void close() {
        const std::size_t data = bytes_.size() - kChunkHead;
        put_u32(bytes_.data(), static_cast<std::uint32_t>(data));
        const std::uint32_t crc = crc32_gzip_refl(0, bytes_.data() + 4, data + 4);
        bytes_.resize(bytes_.size() + kChunkCrc);
        put_u32(bytes_.data() + bytes_.size() - kChunkCrc, crc);
    }
    const std::vector<unsigned char>& bytes() const { return bytes_; }

  private:
    std::vector<unsigned char> bytes_;
};

Status check(const Image& image, const PngOptions& options) {
    if (image.type == SampleType::F32)
        return failure("PNG holds 8- and 16-bit numbers, not 32-bit floats; write EXR or TIFF");
    if (image.width < 1 || image.width > kMaxSide || image.height < 1 || image.height > kMaxSide)
        return failure("cannot write a PNG of {} x {} pixels; a side is 1 to {}", image.width,
                       image.height, kMaxSide);
    if (image.channels < 1 || image.channels > 4)
        return failure("cannot write a PNG of {} channels; it holds 1 to 4", image.channels);
    if (image.data.size() != image.row_bytes() * static_cast<std::size_t>(image.height))
        return failure("cannot write a PNG: {} bytes of pixels where {} x {} needs {}",
                       image.data.size(), image.width, image.height,
                       image.row_bytes() * static_cast<std::size_t>(image.height));
    if (options.level < 1 || options.level > 3)
        return failure("the PNG level must be 1 to 3, got {}", options.level);
    return {};
}

RowLayout layout_of(const Image& image) {
    return {.channels = image.channels,
            .sample = sample_bytes(image.type),
            .row_bytes = image.row_bytes()};
}

/// Copies one row as PNG stores it: 16-bit numbers high byte first.
void pack_row(const Image& image, const RowLayout& layout, std::size_t y, unsigned char* out) {
    const auto* in =
        reinterpret_cast<const unsigned char*>(image.data.data()) + y * layout.row_bytes;
    if (layout.sample == 1) {
        std::memcpy(out, in, layout.row_bytes);
        return;
    }
    for (std::size_t i = 0; i < layout.row_bytes; i += 2) {
        std::uint16_t value = 0;
        std::memcpy(&value, in + i, 2);
        out[i] = static_cast<unsigned char>(value >> 8);
        out[i + 1] = static_cast<unsigned char>(value & 0xff);
    }
}

/// Two packed rows with the margins that the filters read.
class RowPair {
  public:
    explicit RowPair(std::size_t row_bytes)
        : stride_(row_bytes + 2 * kPngRowMargin), bytes_(2 * stride_) {}
    unsigned char* current() { return bytes_.data() + which_ * stride_ + kPngRowMargin; }
    unsigned char* previous() { return bytes_.data() + (1 - which_) * stride_ + kPngRowMargin; }
    void advance() { which_ = 1 - which_; }

  private:
    std::size_t stride_;
    std::vector<unsigned char> bytes_;
    std::size_t which_ = 0;
};

void filter_strip(const Image& image, const RowLayout& layout, std::size_t first, std::size_t last,
                  PixelVector<unsigned char>& filtered) {
    const std::size_t stride = layout.row_bytes + 1;
    filtered.resize((last - first) * stride);
    RowPair rows(layout.row_bytes);
    if (first > 0) pack_row(image, layout, first - 1, rows.previous());
    for (std::size_t y = first; y < last; ++y, rows.advance()) {
        pack_row(image, layout, y, rows.current());
        filter_png_row(rows.current(), rows.previous(), layout.row_bytes, layout.pixel_bytes(),
                       filtered.data() + (y - first) * stride);
    }
}

constexpr std::uint32_t level_buffer_bytes(int level) {
    constexpr std::array<std::uint32_t, 4> kBytes = {0, ISAL_DEF_LVL1_DEFAULT,
                                                     ISAL_DEF_LVL2_DEFAULT, ISAL_DEF_LVL3_DEFAULT};
    return kBytes[static_cast<std::size_t>(level)];
}

/// What one thread keeps from strip to strip: the deflate state and its tables are some 400 KiB,
/// and memory that is new to the process costs more than deflating into it.
struct StripWorker {
    isal_zstream stream = {};
    std::vector<unsigned char> level_buffer;
    PixelVector<unsigned char> filtered;
    PixelVector<unsigned char> deflated;
};

/// Deflates onto the end of `chunk`; ended by a full flush unless it is the last strip.
bool deflate_strip(StripWorker& worker, int level, bool last, PngChunk& chunk) {
    worker.level_buffer.resize(level_buffer_bytes(level));
    isal_zstream& stream = worker.stream;
    isal_deflate_init(&stream);
    stream.level = static_cast<std::uint32_t>(level);
    stream.level_buf = worker.level_buffer.data();
    stream.level_buf_size = static_cast<std::uint32_t>(worker.level_buffer.size());
    stream.flush = FULL_FLUSH;
    stream.end_of_stream = last ? 1 : 0;
    stream.next_in = worker.filtered.data();
    stream.avail_in = static_cast<std::uint32_t>(worker.filtered.size());
    // Incompressible bytes grow by the tables of each block only; an eighth is ample.
    const std::size_t room = worker.filtered.size() + worker.filtered.size() / 8 + 4096;
    worker.deflated.resize(room);
    stream.next_out = worker.deflated.data();
    stream.avail_out = static_cast<std::uint32_t>(room);
    const int status = isal_deflate(&stream);
    chunk.append(std::span(worker.deflated).first(room - stream.avail_out));
    return status == COMP_OK && stream.avail_in == 0 && stream.avail_out > 0;
}

/// The Adler-32 of two joined byte strings from those of each (RFC 1950): with the second one
/// `length` bytes long, s1 = a1 + b1 - 1 and s2 = a2 + b2 + length (a1 - 1), modulo 65521.
std::uint32_t combined_adler32(std::uint32_t first, std::uint32_t second, std::size_t length) {
    constexpr std::uint64_t kModulus = 65521;
    const std::uint64_t a1 = first & 0xffff, a2 = first >> 16;
    const std::uint64_t b1 = second & 0xffff, b2 = second >> 16;
    const std::uint64_t s1 = (a1 + b1 + kModulus - 1) % kModulus;
    const std::uint64_t s2 = (a2 + b2 + (length % kModulus) * (a1 + kModulus - 1)) % kModulus;
    return static_cast<std::uint32_t>(s2 << 16 | s1);
}

struct Strip {
    PngChunk chunk{"IDAT"};
    std::uint32_t adler = 1;
    std::size_t filtered_bytes = 0;
    bool done = false;
};

std::vector<Strip> compressed_strips(const Image& image, const RowLayout& layout, int level,
                                     const Progress& progress) {
    const auto height = static_cast<std::size_t>(image.height);
    const std::size_t rows =
        std::clamp<std::size_t>(kStripBytes / (layout.row_bytes + 1), 1, height);
    std::vector<Strip> strips((height + rows - 1) / rows);
    const auto count = static_cast<std::int64_t>(strips.size());
    parallel_for(0, count, 1, [&](std::int64_t begin, std::int64_t end) {
        const auto worker = std::make_unique<StripWorker>();
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            if (progress.cancelled()) return;
            Strip& strip = strips[i];
            const std::size_t first = i * rows;
            const bool last_strip = i + 1 == strips.size();
            filter_strip(image, layout, first, std::min(first + rows, height), worker->filtered);
            strip.filtered_bytes = worker->filtered.size();
            strip.adler = isal_adler32(1, worker->filtered.data(), worker->filtered.size());
            if (i == 0) strip.chunk.append(kZlibHeader);
            strip.done = deflate_strip(*worker, level, last_strip, strip.chunk);
            // The last chunk waits for the checksum of the whole.
            if (!last_strip) strip.chunk.close();
        }
    });
    return strips;
}

PngChunk header_chunk(const Image& image, const RowLayout& layout) {
    constexpr std::array<unsigned char, 5> kColorType = {0, 0, 4, 2, 6};
    std::array<unsigned char, 13> data = {};
    put_u32(data.data(), static_cast<std::uint32_t>(image.width));
    put_u32(data.data() + 4, static_cast<std::uint32_t>(image.height));
    data[8] = static_cast<unsigned char>(8 * layout.sample);
    data[9] = kColorType[static_cast<std::size_t>(layout.channels)];
    PngChunk chunk("IHDR");
    chunk.append(data);
    chunk.close();
    return chunk;
}

void close_last_strip(std::vector<Strip>& strips) {
    std::uint32_t adler = 1;
    for (const Strip& strip : strips)
        adler = combined_adler32(adler, strip.adler, strip.filtered_bytes);
    std::array<unsigned char, 4> trailer = {};
    put_u32(trailer.data(), adler);
    strips.back().chunk.append(trailer);
    strips.back().chunk.close();
}

Bytes joined(const PngChunk& header, const std::vector<Strip>& strips) {
    PngChunk end("IEND");
    end.close();
    std::size_t total = kSignature.size() + header.bytes().size() + end.bytes().size();
    for (const Strip& strip : strips) total += strip.chunk.bytes().size();
    Bytes png;
    png.reserve(total);
    const auto append = [&](std::span<const unsigned char> bytes) {
        const auto as_bytes = std::as_bytes(bytes);
        png.insert(png.end(), as_bytes.begin(), as_bytes.end());
    };
    append(kSignature);
    append(header.bytes());
    for (const Strip& strip : strips) append(strip.chunk.bytes());
    append(end.bytes());
    return png;
}

}  // namespace

Result<Bytes> encode_png(const Image& image, const PngOptions& options, const Progress& progress) {
    if (const Status ok = check(image, options); !ok) return passed_on(ok);
    const RowLayout layout = layout_of(image);
    std::vector<Strip> strips = compressed_strips(image, layout, options.level, progress);
    if (progress.cancelled()) return failure("writing a PNG was cancelled");
    for (const Strip& strip : strips)
        if (!strip.done) return failure("ISA-L could not compress a strip of the PNG");
    close_last_strip(strips);
    return joined(header_chunk(image, layout), strips);
}

}  // namespace patina::io

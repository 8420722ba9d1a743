// SPDX-License-Identifier: MIT

/// PNG of a 2048 x 2048 RGB map against what else could write it. `png/ratios` interleaves all of
/// them and takes the least of several runs, as the figures that count.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <benchmark/benchmark.h>
#include <isa-l/igzip_lib.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <limits>

#include "core/parallel.h"
#include "io/png_writer.h"

namespace patina {
namespace {

constexpr int kSize = 2048;

std::uint32_t hash_of(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    std::uint32_t h = x * 0x9e3779b1u ^ y * 0x85ebca77u ^ seed * 0xc2b2ae3du;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    return h ^ h >> 15;
}

/// Value noise of 8 octaves, 0..1.
float noise(int x, int y, std::uint32_t seed) {
    float sum = 0.0f, weight = 0.5f;
    for (int octave = 0; octave < 8; ++octave, weight *= 0.5f) {
        const int cell = 512 >> octave;
        const auto corner = [&](int i, int j) {
            return static_cast<float>(hash_of(static_cast<std::uint32_t>(i),
                                              static_cast<std::uint32_t>(j), seed + octave)) *
                   0x1p-32f;
        };
        const int i = x / cell, j = y / cell;
        const float u = static_cast<float>(x % cell) / static_cast<float>(cell);
        const float v = static_cast<float>(y % cell) / static_cast<float>(cell);
        const float top = corner(i, j) + u * (corner(i + 1, j) - corner(i, j));
        const float bottom = corner(i, j + 1) + u * (corner(i + 1, j + 1) - corner(i, j + 1));
        sum += weight * (top + v * (bottom - top));
    }
    return sum;
}

/// An RGB map as a bake makes it: noise with a grain of 3 % between two colours.
const Image& map_2048() {
    static const Image map = [] {
        Image image{
            .width = kSize, .height = kSize, .channels = 3, .type = SampleType::U8, .data = {}};
        image.data.resize(image.row_bytes() * kSize);
        parallel_for(0, kSize, 16, [&](std::int64_t first, std::int64_t last) {
            for (int y = static_cast<int>(first); y < last; ++y)
                for (int x = 0; x < kSize; ++x) {
                    const float shade = noise(x, y, 7);
                    for (int c = 0; c < 3; ++c) {
                        const float grain =
                            static_cast<float>(hash_of(x, y, 99 + c) & 255u) / 255.0f - 0.5f;
                        const float t = shade + 0.03f * grain;
                        const float low = 20.0f + 15.0f * static_cast<float>(c);
                        const float value = low + t * (180.0f - 30.0f * static_cast<float>(c));
                        image.data[static_cast<std::size_t>((y * kSize + x) * 3 + c)] =
                            static_cast<std::byte>(std::clamp(value, 0.0f, 255.0f));
                    }
                }
        });
        return image;
    }();
    return map;
}

std::size_t with_patina() {
    return io::encode_png(map_2048()).value().size();
}

std::size_t with_oiio() {
    std::vector<unsigned char> out;
    OIIO::Filesystem::IOVecOutput memory(out);
    const auto writer = OIIO::ImageOutput::create("x.png");
    writer->set_ioproxy(&memory);
    writer->open("x.png", OIIO::ImageSpec(kSize, kSize, 3, OIIO::TypeDesc::UINT8));
    writer->write_image(OIIO::TypeDesc::UINT8, map_2048().data.data());
    writer->close();
    return out.size();
}

std::size_t with_libpng(int level) {
    std::size_t size = 0;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &size,
        [](png_structp p, png_bytep, png_size_t n) {
            *static_cast<std::size_t*>(png_get_io_ptr(p)) += n;
        },
        nullptr);
    png_set_compression_level(png, level);
    png_set_IHDR(png, info, kSize, kSize, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (std::size_t y = 0; y < kSize; ++y)
        png_write_row(png, reinterpret_cast<png_const_bytep>(map_2048().data.data() +
                                                             y * map_2048().row_bytes()));
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return size;
}
std::size_t with_libpng1() {
    return with_libpng(1);
}
std::size_t with_libpng6() {
    return with_libpng(6);
}

/// The least that could be done: the pixels, unfiltered, deflated in strips by ISA-L.
std::size_t with_bare_isal() {
    constexpr std::size_t kStrip = std::size_t{1} << 20;
    const auto& data = map_2048().data;
    const std::size_t strips = data.size() / kStrip;
    std::vector<std::size_t> sizes(strips);
    parallel_for(0, static_cast<std::int64_t>(strips), 1, [&](std::int64_t i, std::int64_t) {
        std::vector<unsigned char> out(kStrip + kStrip / 8), tables(ISAL_DEF_LVL2_DEFAULT);
        isal_zstream stream = {};
        isal_deflate_init(&stream);
        stream.level = 2;
        stream.level_buf = tables.data();
        stream.level_buf_size = static_cast<std::uint32_t>(tables.size());
        stream.flush = FULL_FLUSH;
        stream.next_in = reinterpret_cast<unsigned char*>(
            const_cast<std::byte*>(data.data() + static_cast<std::size_t>(i) * kStrip));
        stream.avail_in = kStrip;
        stream.next_out = out.data();
        stream.avail_out = static_cast<std::uint32_t>(out.size());
        isal_deflate(&stream);
        sizes[static_cast<std::size_t>(i)] = stream.total_out;
    });
    std::size_t total = 0;
    for (const std::size_t size : sizes) total += size;
    return total;
}

double process_cpu_seconds() {
    timespec now = {};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void run(benchmark::State& state, std::size_t (*encode)()) {
    map_2048();
    std::size_t size = 0;
    for (auto _ : state) benchmark::DoNotOptimize(size = encode());
    state.counters["bytes"] = static_cast<double>(size);
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(map_2048().data.size()));
}

struct Rival {
    std::size_t (*encode)();
    double cpu_seconds = std::numeric_limits<double>::infinity();
    std::size_t bytes = 0;
};

void ratios(benchmark::State& state) {
    map_2048();
    Rival patina{with_patina}, bare{with_bare_isal}, oiio{with_oiio}, png1{with_libpng1};
    const double libpng6_bytes = static_cast<double>(with_libpng6());
    for (auto _ : state)
        for (Rival* rival : {&patina, &bare, &oiio, &png1}) {
            const double start = process_cpu_seconds();
            rival->bytes = rival->encode();
            rival->cpu_seconds = std::min(rival->cpu_seconds, process_cpu_seconds() - start);
        }
    state.counters["oiio/encode"] = oiio.cpu_seconds / patina.cpu_seconds;
    state.counters["libpng1/encode"] = png1.cpu_seconds / patina.cpu_seconds;
    state.counters["encode/bare"] = patina.cpu_seconds / bare.cpu_seconds;
    state.counters["size/libpng6"] = static_cast<double>(patina.bytes) / libpng6_bytes;
}

BENCHMARK_CAPTURE(run, encode, with_patina)
    ->Name("png/encode/2048")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run, isal, with_bare_isal)
    ->Name("png/isal/2048")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run, oiio, with_oiio)
    ->Name("png/oiio/2048")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run, libpng1, with_libpng1)
    ->Name("png/libpng1/2048")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run, libpng6, with_libpng6)
    ->Name("png/libpng6/2048")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(ratios)->Name("png/ratios/2048")->Iterations(7)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace patina

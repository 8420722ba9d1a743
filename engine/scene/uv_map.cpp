// SPDX-License-Identifier: MIT
#include "scene/uv_map.h"

#include <algorithm>
#include <atomic>

#include "core/log.h"
#include "core/parallel.h"

namespace patina {
namespace {

constexpr std::uint32_t kNoTriangle = 0x7fff'ffffu;
constexpr int kRowsOfBand = 32;
/// Texels looked at, some seconds of two cores.
constexpr std::uint64_t kMostWork = std::uint64_t{1} << 30;

/// The largest multiple of `size` that is at most `value`.
constexpr std::int64_t multiple_below(std::int64_t value, std::int64_t size) {
    return value - (value % size + size) % size;
}

}  // namespace

class UvMapMaker {
  public:
    UvMapMaker(const UvSurface& surface, UvMap& map)
        : surface_(surface), map_(map), size_(map.size_) {}

    /// Whether it can be done in reasonable time.
    bool is_feasible() const {
        std::uint64_t work = 0;
        for (std::uint32_t triangle = 0; triangle < surface_.triangle_count(); ++triangle) {
            if (const auto corners = surface_.corners_of(triangle))
                work += texels_looked_at(*corners, size_);
            if (work > kMostWork) return false;
        }
        return surface_.triangle_count() < kNoTriangle;
    }

    void run() {
        const auto side = static_cast<std::size_t>(size_);
        map_.texels_.resize(side * side);
        sort_into_bands();
        parallel_for(0, static_cast<std::int64_t>(bands_.size()), 1,
                     [&](std::int64_t first, std::int64_t last) {
                         for (auto band = static_cast<int>(first); band < static_cast<int>(last);
                              ++band)
                             fill_band(band);
                     });
        fill_the_rest();
    }

  private:
    /// A triangle without a shape lies on all texels.
    struct Placed {
        std::uint32_t triangle;
        std::optional<UvTriangle> shape;
    };

    std::optional<Placed> placed(std::uint32_t triangle) const {
        const auto corners = surface_.corners_of(triangle);
        if (!corners) return std::nullopt;
        if (is_vast(*corners)) return Placed{triangle, std::nullopt};
        const auto shape = UvTriangle::on_map(*corners, size_);
        if (!shape) return std::nullopt;
        return Placed{triangle, shape};
    }

    /// Which triangles reach each band of rows, in their order.
    void sort_into_bands() {
        bands_.resize(static_cast<std::size_t>((size_ + kRowsOfBand - 1) / kRowsOfBand));
        for (std::uint32_t triangle = 0; triangle < surface_.triangle_count(); ++triangle) {
            const auto here = placed(triangle);
            if (!here) continue;
            const std::int64_t low = here->shape ? here->shape->low_y() : 0;
            const std::int64_t high = here->shape ? here->shape->high_y() : size_ - 1;
            if (high - low >= size_) {
                for (auto& band : bands_) band.push_back(triangle);
                continue;
            }
            std::size_t last = bands_.size();
            const std::size_t begin = wrapped_texel(low, size_) / kRowsOfBand;
            for (std::int64_t y = low; y <= high; ++y) {
                const std::size_t band = wrapped_texel(y, size_) / kRowsOfBand;
                // Once round and back in the first band: it has it.
                if (band == last || (band == begin && last != bands_.size())) continue;
                bands_[band].push_back(triangle);
                last = band;
            }
        }
    }

    /// First the texels whose middles lie inside, then those that are only touched: the first
    /// triangle has them.
    void fill_band(int band) {
        const int first_row = band * kRowsOfBand;
        const int last_row = std::min(first_row + kRowsOfBand, size_);
        std::uint32_t* const texels = map_.texels_.data();
        std::fill(texels + map_.index_of(0, first_row),
                  texels + map_.index_of(0, last_row - 1) + size_, kNoTriangle);
        for (const bool middles : {true, false})
            for (const std::uint32_t triangle : bands_[static_cast<std::size_t>(band)]) {
                const Placed here = *placed(triangle);
                if (here.shape)
                    fill(here, first_row, last_row, middles);
                else if (!middles)
                    for (int y = first_row; y < last_row; ++y)
                        for (int x = 0; x < size_; ++x) claim(x, y, triangle);
            }
    }

    void fill(const Placed& here, int first_row, int last_row, bool middles) {
        const UvTriangle& shape = *here.shape;
        const std::int64_t low_y = shape.low_y(), high_y = shape.high_y();
        const std::int64_t low_x = shape.low_x(), high_x = shape.high_x();
        // Of each tile of the texture that it reaches, the rows of this band.
        for (std::int64_t tile = multiple_below(low_y, size_); tile <= high_y; tile += size_) {
            const std::int64_t end = std::min(tile + last_row, high_y + 1);
            for (std::int64_t y = std::max(tile + first_row, low_y); y < end; ++y)
                for (std::int64_t x = low_x; x <= high_x; ++x)
                    if (middles ? shape.holds(x, y) : shape.touches(x, y))
                        claim(static_cast<int>(wrapped_texel(x, size_)), static_cast<int>(y - tile),
                              here.triangle);
        }
    }

    void claim(int x, int y, std::uint32_t triangle) {
        std::uint32_t& texel = map_.texels_[map_.index_of(x, y)];
        if (texel == kNoTriangle) texel = triangle;
    }

    bool is_touched(int x, int y) const { return map_.texels_[map_.index_of(x, y)] != kNoTriangle; }

    // The nearest touched texel of each other one, exactly: first within its column, then along
    // the row over the columns' distances, as in A. Meijster, J. Roerdink and W. Hesselink, "A
    // General Algorithm for Computing Distance Transforms in Linear Time", 2000; here on a torus.

    void fill_the_rest() {
        const auto begin = map_.texels_.begin();
        const bool any_free =
            std::find(begin, map_.texels_.end(), kNoTriangle) != map_.texels_.end();
        if (!any_free) return;
        nearest_rows_.resize(map_.texels_.size());
        std::atomic<bool> any_touched = false;
        parallel_for(0, size_, 64, [&](std::int64_t first, std::int64_t last) {
            if (find_nearest_rows(static_cast<int>(first), static_cast<int>(last)))
                any_touched = true;
        });
        if (!any_touched) return;
        parallel_for(0, size_, 16, [&](std::int64_t first, std::int64_t last) {
            RowSearch search(size_);
            for (auto y = static_cast<int>(first); y < static_cast<int>(last); ++y)
                fill_row(y, search);
        });
    }

    /// Returns whether any texel of the columns is touched.
    bool find_nearest_rows(int first_x, int last_x) {
        bool any = false;
        const auto columns = static_cast<std::size_t>(last_x - first_x);
        std::vector<int> last(columns, -1);
        // Twice round, so that the second time what lies past the border is known.
        for (int step = 0; step < 2 * size_; ++step) {
            const int y = step % size_;
            for (std::size_t c = 0; c < columns; ++c) {
                const int x = first_x + static_cast<int>(c);
                if (is_touched(x, y)) last[c] = step;
                if (step >= size_) nearest_rows_[map_.index_of(x, y)] = row_or_none(last[c]);
                any = any || last[c] >= 0;
            }
        }
        if (!any) return false;
        last.assign(columns, -1);
        for (int step = 0; step < 2 * size_; ++step) {
            const int y = size_ - 1 - step % size_;
            for (std::size_t c = 0; c < columns; ++c) {
                const int x = first_x + static_cast<int>(c);
                if (is_touched(x, y)) last[c] = step;
                if (step < size_ || last[c] < 0) continue;
                const int below = step - last[c];
                std::uint16_t& nearest = nearest_rows_[map_.index_of(x, y)];
                if (below < distance(y, nearest))
                    nearest = static_cast<std::uint16_t>((y + below) % size_);
            }
        }
        return true;
    }

    static constexpr std::uint16_t kNoRow = 0xffff;
    std::uint16_t row_or_none(int step) const {
        return step < 0 ? kNoRow : static_cast<std::uint16_t>(step % size_);
    }
    int distance(int y, int row) const {
        const int apart = std::abs(y - row);
        return std::min(apart, size_ - apart);
    }

    /// The lower envelope of the parabolas of one row's columns, from half a side left of it to
    /// half a side right of it.
    struct RowSearch {
        explicit RowSearch(int size)
            : columns(static_cast<std::size_t>(2 * size) + 2), from(columns.size()) {}
        std::vector<std::int64_t> columns;  ///< the columns of the envelope
        std::vector<std::int64_t> from;     ///< from where on each is the lowest
    };

    void fill_row(int y, RowSearch& search) {
        bool any_free = false;
        for (int x = 0; x < size_ && !any_free; ++x) any_free = !is_touched(x, y);
        if (!any_free) return;
        const auto height = [&](std::int64_t column) -> std::int64_t {
            const std::uint16_t row =
                nearest_rows_[map_.index_of(static_cast<int>(wrapped_texel(column, size_)), y)];
            if (row == kNoRow) return -1;
            const std::int64_t apart = distance(y, row);
            return apart * apart;
        };
        const std::int64_t begin = -(size_ / 2) - 1;
        const std::int64_t end = begin + 2 * std::int64_t{size_} + 2;
        std::size_t count = 0;
        for (std::int64_t column = begin; column < end; ++column) {
            const std::int64_t own = height(column);
            if (own < 0) continue;
            std::int64_t from = begin;
            while (count > 0) {
                const std::int64_t before = search.columns[count - 1];
                // Where this one becomes the lower, rounded up.
                const std::int64_t twice = 2 * (column - before);
                const std::int64_t sum = column * column - before * before + own - height(before);
                from = sum >= 0 ? sum / twice + 1 : -((-sum - 1) / twice);
                if (from > search.from[count - 1]) break;
                --count;
                from = begin;
            }
            search.columns[count] = column;
            search.from[count] = from;
            ++count;
        }
        std::size_t at = 0;
        for (int x = 0; x < size_; ++x) {
            while (at + 1 < count && search.from[at + 1] <= x) ++at;
            if (is_touched(x, y)) continue;
            const auto column = static_cast<int>(wrapped_texel(search.columns[at], size_));
            const std::size_t row = nearest_rows_[map_.index_of(column, y)];
            map_.texels_[map_.index_of(x, y)] =
                UvMap::kElsewhere |
                static_cast<std::uint32_t>(map_.index_of(column, static_cast<int>(row)));
        }
    }

    const UvSurface& surface_;
    UvMap& map_;
    int size_;
    std::vector<std::vector<std::uint32_t>> bands_;
    PixelVector<std::uint16_t> nearest_rows_;
};

UvMapPtr UvMap::make(const UvSurface& surface, int size) {
    auto map = std::shared_ptr<UvMap>(new UvMap(size));
    UvMapMaker maker(surface, *map);
    if (!maker.is_feasible()) {
        log_line(LogLevel::Warning,
                 "the triangles of a material lie on its texture too often: what layers read of "
                 "the model is left out");
        return nullptr;
    }
    maker.run();
    const bool empty = std::all_of(map->texels_.begin(), map->texels_.end(),
                                   [](std::uint32_t texel) { return texel == kNoTriangle; });
    return empty ? nullptr : map;
}

}  // namespace patina

// SPDX-License-Identifier: MIT
#include "io/png_filter.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "io/png_filter.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace patina::io::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<std::uint8_t>;
using V = hn::Vec<Tag>;

/// What each filter predicts from left `a`, above `b` and above left `c`.
struct Neighbours {
    V a, b, c;
};

using M = hn::Mask<Tag>;

HWY_INLINE M at_least(V x, V y) {
    return hn::Eq(hn::Max(x, y), x);
}

HWY_INLINE V absolute_difference(V x, V y) {
    return hn::Or(hn::SaturatedSub(x, y), hn::SaturatedSub(y, x));
}

struct PredictNone {
    static HWY_INLINE V predict(const Neighbours&) { return hn::Zero(Tag()); }
};
struct PredictSub {
    static HWY_INLINE V predict(const Neighbours& n) { return n.a; }
};
struct PredictUp {
    static HWY_INLINE V predict(const Neighbours& n) { return n.b; }
};
struct PredictAverage {
    static HWY_INLINE V predict(const Neighbours& n) {
        // AverageRound rounds up; PNG rounds down.
        const V odd = hn::And(hn::Xor(n.a, n.b), hn::Set(Tag(), std::uint8_t{1}));
        return hn::Sub(hn::AverageRound(n.a, n.b), odd);
    }
};
struct PredictPaeth {
    static HWY_INLINE V predict(const Neighbours& n) {
        const V pa = absolute_difference(n.b, n.c);
        const V pb = absolute_difference(n.a, n.c);
        // |(b - c) + (a - c)| in bytes: where both differences have one sign it is their sum, no
        // less than either, so that c is never chosen and 255 serves as well.
        const auto b_rises = hn::VecFromMask(Tag(), at_least(n.b, n.c));
        const auto a_rises = hn::VecFromMask(Tag(), at_least(n.a, n.c));
        const V one_sign = hn::Not(hn::Xor(b_rises, a_rises));
        const V pc = hn::Or(one_sign, absolute_difference(pa, pb));
        const V nearest_b_or_c = hn::IfThenElse(at_least(pc, pb), n.b, n.c);
        return hn::IfThenElse(hn::And(at_least(pb, pa), at_least(pc, pa)), n.a, nearest_b_or_c);
    }
};

HWY_INLINE Neighbours neighbours(const std::uint8_t* row, const std::uint8_t* previous,
                                 std::size_t i, std::size_t pixel_bytes) {
    const Tag tag;
    return {hn::LoadU(tag, row + i - pixel_bytes), hn::LoadU(tag, previous + i),
            hn::LoadU(tag, previous + i - pixel_bytes)};
}

/// Sums of |filtered byte as signed|, one for each filter.
struct Costs {
    std::uint64_t of_filter[5] = {};
};

HWY_INLINE hn::Vec<hn::Repartition<std::uint64_t, Tag>> magnitudes(V filtered) {
    return hn::SumsOf8(hn::Min(filtered, hn::Sub(hn::Zero(Tag()), filtered)));
}

Costs costs_of(const std::uint8_t* row, const std::uint8_t* previous, std::size_t row_bytes,
               std::size_t pixel_bytes) {
    const Tag tag;
    const hn::Repartition<std::uint64_t, Tag> sums;
    auto none = hn::Zero(sums), sub = none, up = none, average = none, paeth = none;
    const std::size_t lanes = hn::Lanes(tag);
    std::size_t i = 0;
    for (; i + lanes <= row_bytes; i += lanes) {
        const Neighbours n = neighbours(row, previous, i, pixel_bytes);
        const V x = hn::LoadU(tag, row + i);
        none = hn::Add(none, magnitudes(x));
        sub = hn::Add(sub, magnitudes(hn::Sub(x, n.a)));
        up = hn::Add(up, magnitudes(hn::Sub(x, n.b)));
        average = hn::Add(average, magnitudes(hn::Sub(x, PredictAverage::predict(n))));
        paeth = hn::Add(paeth, magnitudes(hn::Sub(x, PredictPaeth::predict(n))));
    }
    if (i < row_bytes) {
        // Bytes beyond the row count as nothing, so that the choice is the same with any width.
        const auto inside = hn::FirstN(tag, row_bytes - i);
        const auto kept = [&](V filtered) {
            return magnitudes(hn::IfThenElseZero(inside, filtered));
        };
        const Neighbours n = neighbours(row, previous, i, pixel_bytes);
        const V x = hn::LoadU(tag, row + i);
        none = hn::Add(none, kept(x));
        sub = hn::Add(sub, kept(hn::Sub(x, n.a)));
        up = hn::Add(up, kept(hn::Sub(x, n.b)));
        average = hn::Add(average, kept(hn::Sub(x, PredictAverage::predict(n))));
        paeth = hn::Add(paeth, kept(hn::Sub(x, PredictPaeth::predict(n))));
    }
    const auto total = [&](auto v) { return hn::GetLane(hn::SumOfLanes(sums, v)); };
    return {{total(none), total(sub), total(up), total(average), total(paeth)}};
}

template <typename Filter>
void write_filtered(const std::uint8_t* row, const std::uint8_t* previous, std::size_t row_bytes,
                    std::size_t pixel_bytes, std::uint8_t* out) {
    const Tag tag;
    const std::size_t lanes = hn::Lanes(tag);
    std::size_t i = 0;
    for (; i + lanes <= row_bytes; i += lanes) {
        const Neighbours n = neighbours(row, previous, i, pixel_bytes);
        hn::StoreU(hn::Sub(hn::LoadU(tag, row + i), Filter::predict(n)), tag, out + i);
    }
    if (i == row_bytes) return;
    const Neighbours n = neighbours(row, previous, i, pixel_bytes);
    HWY_ALIGN std::uint8_t last[kPngRowMargin];
    hn::Store(hn::Sub(hn::LoadU(tag, row + i), Filter::predict(n)), tag, last);
    for (std::size_t k = 0; i + k < row_bytes; ++k) out[i + k] = last[k];
}

void filter_row_in_lanes(const std::uint8_t* row, const std::uint8_t* previous,
                         std::size_t row_bytes, std::size_t pixel_bytes, std::uint8_t* out) {
    const Costs costs = costs_of(row, previous, row_bytes, pixel_bytes);
    std::uint8_t best = 0;
    for (std::uint8_t filter = 1; filter < 5; ++filter)
        if (costs.of_filter[filter] < costs.of_filter[best]) best = filter;
    *out++ = best;
    switch (best) {
        case 0:
            return write_filtered<PredictNone>(row, previous, row_bytes, pixel_bytes, out);
        case 1:
            return write_filtered<PredictSub>(row, previous, row_bytes, pixel_bytes, out);
        case 2:
            return write_filtered<PredictUp>(row, previous, row_bytes, pixel_bytes, out);
        case 3:
            return write_filtered<PredictAverage>(row, previous, row_bytes, pixel_bytes, out);
        default:
            return write_filtered<PredictPaeth>(row, previous, row_bytes, pixel_bytes, out);
    }
}

}  // namespace patina::io::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace patina::io {

HWY_EXPORT(filter_row_in_lanes);

void filter_png_row(const std::uint8_t* row, const std::uint8_t* previous, std::size_t row_bytes,
                    std::size_t pixel_bytes, std::uint8_t* out) {
    HWY_DYNAMIC_DISPATCH(filter_row_in_lanes)(row, previous, row_bytes, pixel_bytes, out);
}

}  // namespace patina::io
#endif

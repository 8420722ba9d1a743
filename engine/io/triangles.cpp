// SPDX-License-Identifier: MIT
#include "io/triangles.h"

#include <cassert>

namespace patina::io {
namespace {

void append(std::vector<std::uint32_t>& list, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a == b || b == c || c == a) return;
    list.insert(list.end(), {a, b, c});
}

}  // namespace

std::vector<std::uint32_t> triangle_list(int mode, std::vector<std::uint32_t> corners) {
    assert(mode >= TINYGLTF_MODE_TRIANGLES);
    std::vector<std::uint32_t> list;
    const bool is_list = mode == TINYGLTF_MODE_TRIANGLES;
    list.reserve(is_list ? corners.size() : 3 * corners.size());
    const std::size_t step = is_list ? 3 : 1;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
        const std::uint32_t next = corners[i + 1];
        const std::uint32_t after = corners[i + 2];
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
            append(list, next, after, corners[0]);
        else if (!is_list && i % 2 == 1)
            append(list, corners[i], after, next);
        else
            append(list, corners[i], next, after);
    }
    return list;
}

}  // namespace patina::io

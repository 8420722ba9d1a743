// SPDX-License-Identifier: MIT
#include "core/pixel_memory.h"

#include <sys/mman.h>

#include <cstdlib>

namespace patina {
namespace {

constexpr std::size_t kSmallAlignment = 64;
constexpr std::size_t kHugePage = std::size_t{2} << 20;

constexpr std::size_t rounded_up(std::size_t size_bytes, std::size_t alignment) {
    return (size_bytes + alignment - 1) / alignment * alignment;
}

}  // namespace

void* allocate_pixels(std::size_t size_bytes) {
    const bool huge = size_bytes >= 2 * kHugePage;
    const std::size_t alignment = huge ? kHugePage : kSmallAlignment;
    const std::size_t rounded = rounded_up(size_bytes, alignment);
    void* const memory = rounded < size_bytes ? nullptr : std::aligned_alloc(alignment, rounded);
    if (memory == nullptr) throw std::bad_alloc();
    // Only advice: where huge pages are off the memory works as well, a little slower.
    if (huge) (void)madvise(memory, rounded, MADV_HUGEPAGE);
    return memory;
}

void free_pixels(void* memory) noexcept {
    std::free(memory);
}

}  // namespace patina

// SPDX-License-Identifier: MIT
#pragma once

/// Memory for pixels: large, written whole by whoever asks for it, and touched in long runs.

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace patina {

/// Memory aligned to 64 bytes; from 4 MiB on it is aligned to 2 MiB and asks the system for huge
/// pages: at 4096 a side, faults of small pages cost more than compositing. Throws std::bad_alloc.
void* allocate_pixels(std::size_t size_bytes);
void free_pixels(void* memory) noexcept;

/// Leaves new elements uninitialised where std::allocator would set them to zero.
template <typename T>
struct PixelAllocator {
    static_assert(std::is_trivially_default_constructible_v<T>);
    using value_type = T;

    PixelAllocator() = default;
    template <typename U>
    PixelAllocator(const PixelAllocator<U>&) noexcept {}

    T* allocate(std::size_t count) {
        if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_alloc();
        return static_cast<T*>(allocate_pixels(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t) noexcept { free_pixels(memory); }

    template <typename U>
    void construct(U* element) noexcept {
        ::new (static_cast<void*>(element)) U;
    }
    template <typename U, typename... Args>
    void construct(U* element, Args&&... args) {
        ::new (static_cast<void*>(element)) U(std::forward<Args>(args)...);
    }
    bool operator==(const PixelAllocator&) const = default;
};

/// A vector whose resize() does not clear: write every element before reading it.
template <typename T>
using PixelVector = std::vector<T, PixelAllocator<T>>;

}  // namespace patina

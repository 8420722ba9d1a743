// SPDX-License-Identifier: MIT
#include "core/free_memory.h"

#include <fstream>
#include <optional>
#include <string>

namespace patina {
namespace {

/// What Linux could give without swapping.
std::optional<std::uint64_t> free_bytes() {
    std::ifstream file("/proc/meminfo");
    std::string name, unit;
    for (std::uint64_t kibibytes = 0; file >> name >> kibibytes; std::getline(file, unit))
        if (name == "MemAvailable:") return kibibytes << 10;
    return std::nullopt;
}

}  // namespace

Status check_free_memory(std::uint64_t bytes, std::string_view what) {
    const std::optional<std::uint64_t> free = free_bytes();
    if (!free || bytes <= *free) return {};
    return failure("{} take {} MiB, and {} MiB of memory are free; make fewer or smaller ones",
                   what, bytes >> 20, *free >> 20);
}

}  // namespace patina

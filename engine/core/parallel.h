// SPDX-License-Identifier: MIT
#pragma once

/// Parallel loops over oneTBB. Results never depend on the number of threads: a body writes only
/// what belongs to its own range.

#include <cstdint>
#include <functional>

namespace patina {

/// Calls `body(first, last)` for ranges that cover [begin, end), each at most `grain` long, on the
/// threads of the pool, and returns when all are done. `body` must not throw.
void parallel_for(std::int64_t begin, std::int64_t end, std::int64_t grain,
                  const std::function<void(std::int64_t first, std::int64_t last)>& body);

/// Holds the parallel loops of the whole program to at most `threads` (1 or more), the calling one
/// among them, while the object lives; of several the least holds.
class ThreadLimit {
  public:
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

  private:
    void* control_;
};

}  // namespace patina

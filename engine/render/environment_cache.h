// SPDX-License-Identifier: MIT
#pragma once

/// Filtered environments kept on disk from one run to the next, by the content of their map. What
/// is found there is what filtering would give, bit for bit. It is convenience: a file that cannot
/// be read, or that is damaged or of another version, is as if it were not there, and one that
/// cannot be written is left out without a word. Any thread, and any number of programs at once.

#include <filesystem>

#include "render/environment.h"

namespace patina::render {

struct EnvironmentCache {
    std::filesystem::path folder;  ///< empty: nothing is kept
    /// What all files may take together; the ones that were not read for longest go first.
    std::uint64_t budget_bytes = std::uint64_t{512} << 20;
};

/// $XDG_CACHE_HOME/patina/environments, or below ~/.cache; none where there is neither variable.
EnvironmentCache user_environment_cache();

/// What is kept of filter_environment(equirect, FilterQuality::Finished), or nothing. Its map is
/// made of `equirect` again.
std::optional<FilteredEnvironment> kept_environment(const EnvironmentCache& cache,
                                                    const Image& equirect);
/// Keeps what filter_environment made with FilterQuality::Finished.
void keep_environment(const EnvironmentCache& cache, const FilteredEnvironment& environment);

/// The finished environment: what is kept, or filtered now and then kept.
Result<FilteredEnvironment> finished_environment(const EnvironmentCache& cache,
                                                 const Image& equirect,
                                                 const Progress& progress = {});

}  // namespace patina::render

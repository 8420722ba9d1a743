// SPDX-License-Identifier: MIT
#pragma once

/// How maps are written as files of their own: the options of `bake --maps` and `export`.

#include <CLI/CLI.hpp>

#include "io/map_export.h"

namespace patina::cli {

/// `--map-format`, `--jpg-quality`, `--png-level`, `--bits`, `--packing`. What does not go together
/// is found by check_map_options.
void add_map_options(CLI::App& app, io::MapExportOptions& options);

/// `--size` of baked maps.
void add_map_size_option(CLI::App& app, std::optional<int>& size);

}  // namespace patina::cli

// SPDX-License-Identifier: MIT
#pragma once

/// Included by kernels before Highway: the instruction sets that are not worth a copy of their
/// code. SSSE3 without SSE4 was last sold before 2008; each copy costs compile time and size.
#define HWY_DISABLED_TARGETS HWY_SSSE3

// SPDX-License-Identifier: MIT
#pragma once

/// Included by kernels before Highway: the instruction sets that are not worth a copy of their
/// code. SSSE3 without SSE4 was last sold before 2008; each copy costs compile time and size. Under
/// sanitizers, which make it cost more, SSE4 has nothing that SSE2 would not show.
#ifdef __SANITIZE_ADDRESS__
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4)
#else
#define HWY_DISABLED_TARGETS HWY_SSSE3
#endif

// SPDX-License-Identifier: MIT
#pragma once

/// Glyphs of Font Awesome 4.7, as UTF-8.

namespace patina::editor::icon {

inline constexpr const char* kEye = "\uf06e";
inline constexpr const char* kEyeSlash = "\uf070";
inline constexpr const char* kLock = "\uf023";
inline constexpr const char* kUnlock = "\uf13e";
inline constexpr const char* kPlus = "\uf067";
inline constexpr const char* kFolder = "\uf07b";
inline constexpr const char* kFolderOpen = "\uf07c";
inline constexpr const char* kFile = "\uf016";
inline constexpr const char* kInvert = "\uf042";
inline constexpr const char* kClone = "\uf24d";
inline constexpr const char* kTrash = "\uf014";
inline constexpr const char* kSearch = "\uf002";
inline constexpr const char* kUndo = "\uf0e2";
inline constexpr const char* kRedo = "\uf01e";
inline constexpr const char* kSave = "\uf0c7";
inline constexpr const char* kExport = "\uf093";
inline constexpr const char* kSwap = "\uf0ec";
inline constexpr const char* kLink = "\uf0c1";
inline constexpr const char* kReset = "\uf021";
inline constexpr const char* kStar = "\uf005";
inline constexpr const char* kStarEmpty = "\uf006";
inline constexpr const char* kClose = "\uf00d";
inline constexpr const char* kCheck = "\uf00c";
inline constexpr const char* kWarning = "\uf071";
inline constexpr const char* kInfo = "\uf05a";
inline constexpr const char* kAngleDown = "\uf107";
inline constexpr const char* kAngleRight = "\uf105";
inline constexpr const char* kChevronUp = "\uf077";
inline constexpr const char* kChevronDown = "\uf078";
inline constexpr const char* kEllipsis = "\uf141";
inline constexpr const char* kSliders = "\uf1de";
inline constexpr const char* kFrame = "\uf0b2";
inline constexpr const char* kEyedropper = "\uf1fb";
inline constexpr const char* kGrid = "\uf00a";
inline constexpr const char* kSun = "\uf185";
inline constexpr const char* kCamera = "\uf030";
inline constexpr const char* kVideo = "\uf03d";
inline constexpr const char* kArrowUp = "\uf062";
inline constexpr const char* kImage = "\uf03e";
inline constexpr const char* kNoise = "\uf0c2";
inline constexpr const char* kDroplet = "\uf043";
inline constexpr const char* kPencil = "\uf040";
inline constexpr const char* kCopy = "\uf0c5";
inline constexpr const char* kPaste = "\uf0ea";
inline constexpr const char* kClip = "\uf149";
inline constexpr const char* kHeights = "\uf1fe";
inline constexpr const char* kQuestion = "\uf059";

}  // namespace patina::editor::icon

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "document/blend_mode.h"
#include "editor/widgets/combo.h"

namespace patina::editor {

/// Groups can pass through as well; entries of masks (of ChannelKind::Scalar) join by fewer.
enum class BlendOf { Channel, Group, Mask };

/// A combo of the blend modes that mean something for `kind`, under the headings of the table.
std::optional<BlendMode> blend_combo(Ui& ui, const Rect& rect, const ComboSpec& spec,
                                     ChannelKind kind, BlendMode current,
                                     BlendOf of = BlendOf::Channel);

}  // namespace patina::editor

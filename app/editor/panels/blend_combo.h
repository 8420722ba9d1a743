// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "document/blend_mode.h"
#include "document/layer.h"
#include "editor/widgets/combo.h"

namespace patina::editor {

/// Groups can pass through as well; entries of masks (of ChannelKind::Scalar) join by fewer.
enum class BlendOf { Channel, Group, Mask };
inline BlendOf blend_of(const Layer& layer) {
    return layer.is_group() ? BlendOf::Group : BlendOf::Channel;
}

/// A combo of the blend modes that mean something for `kind`, under the headings of the table.
std::optional<BlendMode> blend_combo(Ui& ui, const Rect& rect, const ComboSpec& spec,
                                     ChannelKind kind, BlendMode current,
                                     BlendOf of = BlendOf::Channel);

/// The same for one channel of a layer, with the first choice to state no mode. What then holds is
/// shown. Returns the new choice, which may be unset.
std::optional<std::optional<BlendMode>> channel_blend_combo(Ui& ui, const Rect& rect,
                                                            const ComboSpec& spec,
                                                            const Layer& layer, Channel channel);

}  // namespace patina::editor

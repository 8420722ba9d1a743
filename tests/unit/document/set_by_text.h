// SPDX-License-Identifier: MIT
#pragma once

/// Documents that differ from others in one setting.

#include <stdexcept>
#include <string_view>
#include <utility>

#include "document/setting.h"

namespace patina {

/// The document after a setting such as "Body/Rust/opacity=0.5". Throws what is wrong with it,
/// which fails the test.
inline Document set_by_text(const Document& before, std::string_view text) {
    const auto setting = setting_from_text(text);
    if (!setting) throw std::runtime_error(setting.error().message);
    auto after = with_setting(before, *setting);
    if (!after) throw std::runtime_error(after.error().message);
    return std::move(*after);
}

}  // namespace patina

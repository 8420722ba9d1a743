// SPDX-License-Identifier: MIT
#pragma once

/// Patina's records where they lie in glTF JSON: extras.patina of materials and scenes.

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "document/record.h"
#include "io/json_splice.h"

namespace patina::io {

/// The record's text; empty where there is none.
std::string record_text(const Json& item);
/// The record of a glTF material, if it has one that this version reads.
std::optional<MaterialRecord> record_of(const Json& material);

/// Puts a record in. Extras that are no object are left alone; a record of a newer version is kept
/// beside it. Either gives a warning that names `what`.
void set_record(Json& item, const std::string& text, std::string_view what,
                std::vector<std::string>& warnings);

/// Hashes of all encoded images that the records of these materials list as Patina's own.
std::set<Hash128> owned_images_of(const Json& materials);

}  // namespace patina::io

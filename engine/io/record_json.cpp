// SPDX-License-Identifier: MIT
#include "io/record_json.h"

#include "io/gltf_json.h"

namespace patina::io {

std::string record_text(const Json& item) {
    const auto extras = item.is_object() ? item.find("extras") : item.end();
    return extras == item.end() ? std::string() : text_at(*extras, "patina");
}

std::optional<MaterialRecord> record_of(const Json& material) {
    const std::string text = record_text(material);
    if (text.empty()) return std::nullopt;
    auto record = material_record_from_json(text);
    if (!record) return std::nullopt;
    return std::move(*record);
}

void set_record(Json& item, const std::string& text, std::string_view what,
                std::vector<std::string>& warnings) {
    if (item.contains("extras") && !item["extras"].is_object()) {
        warnings.push_back(
            fmt::format("{} has extras that are no JSON object; they are left alone, so that "
                        "what glTF cannot say (layers, environment) is not saved with it",
                        what));
        return;
    }
    const std::string old = record_text(item);
    if (const auto version = record_version(old);
        !old.empty() && version && *version > kRecordVersion) {
        item["extras"][fmt::format("patina-version-{}", *version)] = old;
        warnings.push_back(
            fmt::format("{} had layers of a newer Patina (version {}); they are kept beside "
                        "the new ones",
                        what, *version));
    }
    item["extras"]["patina"] = text;
}

std::set<Hash128> owned_images_of(const Json& materials) {
    std::set<Hash128> owned;
    for (const Json& material : materials)
        if (const auto record = record_of(material))
            owned.insert(record->owned_images.begin(), record->owned_images.end());
    return owned;
}

}  // namespace patina::io

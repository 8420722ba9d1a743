// SPDX-License-Identifier: MIT
#include "io/material_save.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "composite/composite.h"
#include "composite/dilate.h"
#include "composite/operations.h"
#include "document/material_warnings.h"
#include "io/material_json.h"
#include "io/record_json.h"
#include "io/safe_name.h"
#include "io/stand_in.h"

namespace patina::io {
namespace {

constexpr std::array kSlots = {Slot::BaseColor, Slot::MetallicRoughness, Slot::Normal,
                               Slot::Occlusion, Slot::Emissive};
constexpr const char* kSpecularGlossiness = "KHR_materials_pbrSpecularGlossiness";

std::size_t as_index(Slot slot) {
    return static_cast<std::size_t>(slot);
}
std::size_t as_index(BakedMap map) {
    return static_cast<std::size_t>(map);
}

/// glTF itself knows PNG and JPEG.
bool fits_gltf(const ImageAsset& image) {
    return image.mime_type == "image/png" || image.mime_type == "image/jpeg";
}

/// The factor that glTF multiplies an untouched image with.
glm::vec4 factor_of(const SlotImage& image, Slot slot) {
    const glm::vec3& multiply = image.source.multiply;
    switch (slot) {
        case Slot::BaseColor:
            return glm::vec4(multiply, image.opacity_factor);
        case Slot::MetallicRoughness:
            return {1.0f, multiply.x, image.metalness_factor, 1.0f};
        case Slot::Normal:
        case Slot::Occlusion:
        case Slot::Emissive:
            return glm::vec4(multiply, 1.0f);
    }
    return glm::vec4(1.0f);
}

class MaterialWriter {
  public:
    MaterialWriter(MaterialSave& save, Material now, const Material* before)
        : save_(save),
          now_(std::move(now)),
          before_(before),
          program_(Program::compile(save.document, now_)),
          islands_(dilated_by(save.document, now_, program_)) {}

    Result<EncodedMaps> write() {
        open();
        note_what_is_missing();
        plan();
        if (const Status ok = bake(); !ok) return passed_on(ok);
        for (const Slot slot : kSlots)
            if (changed_[as_index(slot)])
                if (const Status ok = state(slot); !ok) return passed_on(ok);
        state_settings(json_, now_, settings_before());
        list_extensions(save_.gltf, json_);
        record();
        Json& materials = save_.gltf.array("materials");
        materials[static_cast<std::size_t>(index_)] = json_;
        save_.gltf.leave_out_unused_extension(kSpecularGlossiness);
        share_with_stand_in();
        return std::move(maps_);
    }

  private:
    Json& materials() { return save_.gltf.array("materials"); }

    /// Finds the material in the file, where a new one has its place already.
    void open() {
        const auto added = save_.places.find(now_.id);
        if (added == save_.places.end()) {
            index_ = now_.source_material.value_or(0);
        } else {
            before_ = nullptr;
            index_ = added->second;
        }
        json_ = materials()[static_cast<std::size_t>(index_)];
        if (before_) old_record_ = record_of(json_);
        stand_in_ = find_stand_in(materials(), now_.id);
    }

    void note_what_is_missing() {
        for (std::string& line : warnings_of(save_.document, now_, program_.data().surface))
            save_.warnings.push_back(std::move(line));
    }

    /// What the settings in the JSON are those of, or null where it has none yet.
    const Material* settings_before() const {
        if (before_ || !now_.copied_from || !save_.document.opened) return before_;
        return material_of(*save_.document.opened, *now_.copied_from).get();
    }

    bool is_baked(Slot slot) const {
        return std::holds_alternative<SlotBaked>(slots_[as_index(slot)]);
    }

    void plan() {
        slots_ = program_.slots();
        for (const Slot slot : kSlots)
            if (const auto* image = std::get_if<SlotImage>(&slots_[as_index(slot)]))
                if (const ImageAsset* asset = find_asset(image->source.image);
                    !asset || !fits_gltf(*asset))
                    slots_[as_index(slot)] = SlotBaked{baked_map_of(slot)};
        find_changed_slots();
        for (const Slot slot : kSlots) {
            if (is_baked(slot)) shown_uv_sets_.insert(now_.uv_set);
            if (const auto* image = std::get_if<SlotImage>(&slots_[as_index(slot)]))
                if (averaged(slot)) shown_uv_sets_.insert(image->source.uv_set);
        }
        needs_stand_in_ =
            some_primitive_lacks(save_.gltf.array("meshes"), {index_, stand_in_}, shown_uv_sets_);
    }

    void find_changed_slots() {
        changed_.fill(true);
        if (!before_) return replace_specular_glossiness();
        const Document& opened = save_.document.opened ? *save_.document.opened : save_.document;
        const Program old = Program::compile(opened, *before_);
        const UvSurfacePtr old_islands = dilated_by(opened, *before_, old);
        const bool same_islands = islands_ == nullptr || old_islands == nullptr
                                      ? islands_ == old_islands
                                      : islands_->hash() == old_islands->hash();
        const bool same_layout = now_.resolution == before_->resolution &&
                                 now_.uv_set == before_->uv_set && same_islands;
        for (const Slot slot : kSlots)
            changed_[as_index(slot)] =
                program_.slot_hash(slot) != old.slot_hash(slot) ||
                program_.slots()[as_index(slot)] != old.slots()[as_index(slot)] ||
                (is_baked(slot) && !same_layout);
        bool& roughness = changed_[as_index(Slot::MetallicRoughness)];
        bool& occlusion = changed_[as_index(Slot::Occlusion)];
        // They share one map: showing the old one in one slot would keep both in the file.
        if (is_baked(Slot::MetallicRoughness) && is_baked(Slot::Occlusion))
            roughness = occlusion = roughness || occlusion;
        replace_specular_glossiness();
    }

    /// The stack shows this statement of the same slots converted, and viewers that know it would
    /// show it in the place of what is written here: an edited material leaves it for good.
    void replace_specular_glossiness() {
        const auto extensions = json_.find("extensions");
        if (extensions == json_.end() || !extensions->contains(kSpecularGlossiness)) return;
        changed_[as_index(Slot::BaseColor)] = true;
        changed_[as_index(Slot::MetallicRoughness)] = true;
        extensions->erase(kSpecularGlossiness);
        if (extensions->empty()) json_.erase("extensions");
        save_.warnings.push_back(
            fmt::format("material \"{}\": {} was converted to metallic-roughness, which holds its "
                        "edit",
                        quoted_for_message(now_.name, 60), kSpecularGlossiness));
    }

    Status bake() {
        std::set<BakedMap> wanted;
        for (const Slot slot : kSlots) {
            const bool varies = !std::holds_alternative<SlotConstant>(slots_[as_index(slot)]);
            if (is_baked(slot) && changed_[as_index(slot)]) wanted.insert(baked_map_of(slot));
            if (varies && needs_stand_in_ && averaged(slot)) wanted.insert(baked_map_of(slot));
        }
        auto maps =
            bake_and_encode(program_, islands_, save_.pixels, save_.size.value_or(now_.resolution),
                            {wanted.begin(), wanted.end()}, save_.png, save_.progress);
        if (!maps)
            return failure("material \"{}\": {}", quoted_for_message(now_.name, 60),
                           maps.error().message);
        maps_ = std::move(*maps);
        return {};
    }

    const ImageAsset* find_asset(const Hash128& hash) const {
        const auto found = save_.document.images.find(hash);
        return found == save_.document.images.end() ? nullptr : found->second.get();
    }

    /// The image in the file, put there if it is not; -1 where its bytes are missing.
    int index_of(const ImageAsset& asset) {
        if (asset.source_image && *asset.source_image < save_.images.image_count())
            return *asset.source_image;
        const auto encoded = asset.encoded.bytes();
        if (!encoded) return -1;
        return save_.images.add_image(asset.name, asset.mime_type, encoded);
    }

    Status state(Slot slot) {
        const SlotPlan& plan = slots_[as_index(slot)];
        if (const auto* constant = std::get_if<SlotConstant>(&plan)) {
            state_slot(json_, slot, {.texture = {}, .factor = constant->value});
            return {};
        }
        const int current = slot_texture(json_, slot);
        if (const auto* image = std::get_if<SlotImage>(&plan)) {
            const ImageAsset* asset = find_asset(image->source.image);
            const int index = asset ? index_of(*asset) : -1;
            if (index < 0)
                return failure("material \"{}\": an image that it shows is missing",
                               quoted_for_message(now_.name, 60));
            const ImageSource& source = image->source;
            const int sampler = save_.images.sampler(source.wrap_u, source.wrap_v, source.filter,
                                                     save_.images.sampler_of(current));
            state_slot(json_, slot,
                       {.texture = StatedTexture{.texture = save_.images.texture(index, sampler),
                                                 .uv_set = source.uv_set,
                                                 .transform = source.transform},
                        .factor = factor_of(*image, slot)});
            return {};
        }
        // The wrap modes of the slot stay; a slot that had no texture wraps like the base colour.
        const int like = current >= 0 ? current : slot_texture(json_, Slot::BaseColor);
        const BakedMap map = baked_map_of(slot);
        const int index =
            save_.images.add_image(fmt::format("{} {}", now_.name, kBakedMapIds[as_index(map)]),
                                   "image/png", maps_[as_index(map)]->png);
        state_slot(json_, slot,
                   {.texture = StatedTexture{.texture = save_.images.texture(
                                                 index, save_.images.sampler_of(like)),
                                             .uv_set = now_.uv_set,
                                             .transform = {}},
                    .factor = glm::vec4(1.0f)});
        return {};
    }

    /// Images that layers read, put into the file where they are not.
    std::vector<int> layer_images() {
        std::vector<int> indices;
        for (const Hash128& hash : images_of(now_.stack)) {
            const ImageAsset* asset = find_asset(hash);
            if (asset && !file_beside(*asset).empty()) continue;
            const int index = asset ? index_of(*asset) : -1;
            if (index >= 0)
                indices.push_back(index);
            else
                save_.warnings.push_back(fmt::format(
                    "material \"{}\": an image of its layers is missing and cannot be saved",
                    quoted_for_message(now_.name, 60)));
        }
        return indices;
    }

    void record() {
        MaterialRecord record = material_record(save_.document, now_);
        for (RecordImage& image : record.images)
            if (const ImageAsset* asset = find_asset(image.hash)) image.file = file_beside(*asset);
        for (const Slot slot : kSlots) {
            if (!is_baked(slot)) continue;
            const std::string id(kBakedMapIds[as_index(baked_map_of(slot))]);
            if (changed_[as_index(slot)])
                record.baked[id] = maps_[as_index(baked_map_of(slot))]->pixels;
            else if (old_record_ && old_record_->baked.contains(id))
                record.baked.try_emplace(id, old_record_->baked.at(id));
        }
        const std::vector<int> images = layer_images();
        for (const int image : images) save_.images.keep_image(image);
        record.owned_images = save_.images.owned_by(json_, images);
        set_record(json_, to_json(record),
                   fmt::format("material \"{}\"", quoted_for_message(now_.name, 60)),
                   save_.warnings);
    }

    /// Whether a stand-in shows a mean in the place of the slot's texture.
    bool averaged(Slot slot) const {
        return is_baked(slot) || changed_[as_index(slot)] ||
               save_.shown_without_uvs.contains(now_.id);
    }

    void share_with_stand_in() {
        Json& meshes = save_.gltf.array("meshes");
        if (!needs_stand_in_) {
            if (stand_in_ < 0) return;
            share_out(meshes, index_, stand_in_, {});
            if (stand_in_ + 1 == static_cast<int>(materials().size()))
                materials().erase(materials().size() - 1);
            return;
        }
        Json plain = json_;
        for (const Slot slot : kSlots) {
            const bool varies = !std::holds_alternative<SlotConstant>(slots_[as_index(slot)]);
            if (!varies || !averaged(slot)) continue;
            const Image& map = *maps_[as_index(baked_map_of(slot))]->image;
            state_slot(plain, slot, {.texture = {}, .factor = mean_factor(map, slot)});
        }
        plain["name"] = now_.name + " (no UVs)";
        std::vector<std::string> ignored;  // the same warning as the material's own
        MaterialRecord stand_in;
        stand_in.stands_for = now_.id;
        set_record(plain, to_json(stand_in), "", ignored);
        if (stand_in_ < 0) {
            stand_in_ = static_cast<int>(materials().size());
            materials().push_back(Json::object());
        }
        materials()[static_cast<std::size_t>(stand_in_)] = std::move(plain);
        share_out(meshes, index_, stand_in_, shown_uv_sets_);
        save_.warnings.push_back(
            fmt::format("material \"{}\": some of its meshes lack UV set {}; they get a plain copy "
                        "with its mean values",
                        quoted_for_message(now_.name, 60), *shown_uv_sets_.rbegin()));
    }

    MaterialSave& save_;
    Material now_;
    const Material* before_;
    Program program_;
    UvSurfacePtr islands_;  ///< what baked maps are dilated by, or null
    int index_ = 0;
    int stand_in_ = -1;
    Json json_;
    std::optional<MaterialRecord> old_record_;
    std::array<SlotPlan, kSlotCount> slots_;
    std::array<bool, kSlotCount> changed_ = {};
    std::set<int> shown_uv_sets_;
    bool needs_stand_in_ = false;
    EncodedMaps maps_;
};

bool is_resolution(int size) {
    return size >= kMinResolution && size <= kMaxResolution && (size & (size - 1)) == 0;
}

}  // namespace

Result<EncodedMaps> save_material(MaterialSave& save, const Material& material,
                                  const Material* before) {
    Material now = material;
    if (save.size && is_resolution(*save.size)) now.resolution = *save.size;
    return MaterialWriter(save, std::move(now), before).write();
}

bool same_content(const Document& document_a, const Material& a, const Document& document_b,
                  const Material& b) {
    if (a == b) return true;
    const auto settings = [](Material material) {
        material.stack.clear();
        return material;
    };
    return settings(a) == settings(b) &&
           to_json(material_record(document_a, a)) == to_json(material_record(document_b, b));
}

std::string file_beside(const ImageAsset& image) {
    if (image.source_image || !image.encoded || fits_gltf(image)) return {};
    const std::filesystem::path name(safe_file_name(image.name));
    return fmt::format("{}-{}{}", name.stem().string().substr(0, 40), to_hex(image.hash),
                       name.extension().string());
}

}  // namespace patina::io

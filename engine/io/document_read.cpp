// SPDX-License-Identifier: MIT
#include "io/document_read.h"

#include <algorithm>
#include <array>
#include <set>

#include "document/record.h"
#include "io/uri.h"

namespace patina::io {
namespace {

/// The slots of a glTF material that may show a baked map, by the map's id in records.
std::vector<const TextureUse*> slots_of_map(const MaterialValues& material, std::string_view map) {
    if (map == "base-color") return {&material.base_color};
    if (map == "occlusion-roughness-metalness")
        return {&material.metallic_roughness, &material.occlusion};
    if (map == "normal") return {&material.normal};
    if (map == "emissive") return {&material.emissive};
    return {};
}

/// The place of the material of primitives without one: the same however many materials a save
/// adds.
constexpr std::size_t kDefaultPlace = std::size_t{1} << 19;

/// Ids by the place in the file: a material without a record has the same ones whenever the file is
/// opened, also after a save that gave records to other materials.
Material with_ids_of_place(Material material, std::size_t index) {
    material.id = MaterialId{2 * index + 1};
    Layer layer = *material.stack.front();
    layer.id = LayerId{2 * index + 2};
    material.stack.front() = std::make_shared<const Layer>(std::move(layer));
    return material;
}

class DocumentReader {
  public:
    DocumentReader(const DocumentParts& parts, Scene scene)
        : parts_(parts), scene_(std::move(scene)) {
        for (const ImageAssetPtr& image : parts.images)
            if (image) known_images_.emplace(image->hash, image);
    }

    Document read() {
        read_records();
        for (std::size_t i = 0; i < parts_.model.materials.size(); ++i)
            if (!stands_for_[i]) add_material(i);
        replace_stand_ins();
        add_default_material();
        read_scene_settings();
        for (const MaterialPtr& material : document_.materials) keep_images(*material);
        document_.scene = std::make_shared<const Scene>(std::move(scene_));
        return with_unique_ids(document_);
    }

  private:
    void warn(std::size_t material, std::string_view what) {
        parts_.warnings.push_back(fmt::format("/materials/{}: {}", material, what));
    }

    /// Records that can be read; the others are warned of and stay in the file.
    void read_records() {
        const std::size_t count = parts_.model.materials.size();
        records_.resize(count);
        stands_for_.assign(count, std::nullopt);
        for (std::size_t i = 0; i < count; ++i)
            if (const auto text = record_text(parts_.model.materials[i].extras))
                read_record(i, *text);
        std::map<MaterialId, std::size_t> material_of_id;
        for (std::size_t i = 0; i < count; ++i)
            if (records_[i] && records_[i]->stands_for.value == 0)
                material_of_id.emplace(records_[i]->id, i);
        for (std::size_t i = 0; i < count; ++i) {
            if (!records_[i] || records_[i]->stands_for.value == 0) continue;
            const auto original = material_of_id.find(records_[i]->stands_for);
            if (original != material_of_id.end()) stands_for_[i] = original->second;
            records_[i].reset();
        }
    }

    void read_record(std::size_t index, const std::string& text) {
        const auto version = record_version(text);
        if (!version)
            return warn(index, "extras.patina is no record of Patina; the maps are shown");
        if (*version > kRecordVersion)
            return warn(index,
                        "was saved by a newer Patina; the baked maps are shown and its layers are "
                        "kept in the file");
        auto record = material_record_from_json(text);
        if (!record)
            return warn(index, fmt::format("its layers cannot be read ({}); the maps are shown",
                                           record.error().message));
        records_[index] = std::move(*record);
    }

    void warn_of_uv_sets(std::size_t index) {
        const MaterialValues values = material_values(parts_.model.materials[index]);
        for (const TextureUse* use : values.textures())
            if (use->texture >= 0 && use->named_uv_set > kMaxReadUvSet)
                return warn(index,
                            fmt::format("its maps name TEXCOORD_{}, which Patina does not read; "
                                        "TEXCOORD_0 is used",
                                        use->named_uv_set));
    }

    void add_material(std::size_t index) {
        warn_of_uv_sets(index);
        Material material = with_ids_of_place(
            imported_material(parts_.model, static_cast<int>(index), parts_.images), index);
        if (records_[index]) {
            const MaterialRecord& record = *records_[index];
            material.id = record.id;
            if (is_edited_elsewhere(index, record)) {
                warn(index,
                     "its maps were edited elsewhere; they are shown and its layers are kept in "
                     "the file");
            } else {
                material.stack = record.stack;
                material.resolution = record.resolution;
                material.uv_set = record.uv_set;
                material.height_scale = record.height_scale;
                material.padding = record.padding;
                for (const RecordImage& image : record.images) find_beside(index, image);
            }
        }
        document_.materials.push_back(std::make_shared<const Material>(std::move(material)));
    }

    bool is_edited_elsewhere(std::size_t index, const MaterialRecord& record) const {
        const MaterialValues material = material_values(parts_.model.materials[index]);
        for (const auto& [map, hash] : record.baked) {
            const auto slots = slots_of_map(material, map);
            const auto shows = [&, &baked = hash](const TextureUse* use) {
                return shows_image(*use, baked);
            };
            if (!slots.empty() && std::none_of(slots.begin(), slots.end(), shows)) return true;
        }
        // An image of a layer that has gone from the file was painted over or thrown away.
        return std::any_of(record.images.begin(), record.images.end(),
                           [&](const RecordImage& image) {
                               return image.file.empty() && !known_images_.contains(image.hash);
                           });
    }

    bool shows_image(const TextureUse& use, const Hash128& hash) const {
        const int image = image_index(parts_.model, use);
        return image >= 0 && parts_.images[static_cast<std::size_t>(image)]->hash == hash;
    }

    /// Reads an image that lies beside the model; a placeholder stands for one that is gone.
    void find_beside(std::size_t material, const RecordImage& image) {
        if (image.file.empty() || known_images_.contains(image.hash)) return;
        const auto asset = read_beside(image.file);
        if (asset && (*asset)->hash == image.hash) {
            // The file's name has the hash in it; people gave the image another one.
            ImageAsset named = **asset;
            named.name = image.name;
            known_images_.emplace(image.hash, std::make_shared<const ImageAsset>(std::move(named)));
            return;
        }
        warn(material, fmt::format("the image \"{}\" beside the model {}; a placeholder is shown",
                                   quoted_for_message(image.file, 100),
                                   asset ? "was changed" : "cannot be read"));
        known_images_.emplace(image.hash,
                              parts_.store.add_placeholder(image.hash, image.name, nullptr));
    }

    Result<ImageAssetPtr> read_beside(const std::string& file) {
        const auto relative = relative_path_of_uri(file);
        if (!relative) return passed_on(relative);
        if (parts_.asset.path.empty()) return failure("the model has no folder");
        const auto path = file_under(parts_.asset.path.parent_path(), *relative);
        if (!path) return passed_on(path);
        if (!*path) return failure("no such file");
        return parts_.store.add_file(**path);
    }

    void replace_stand_ins() {
        for (Mesh& mesh : scene_.meshes) {
            for (Primitive& primitive : mesh.primitives) {
                if (primitive.source_material < 0) continue;
                const auto original =
                    stands_for_[static_cast<std::size_t>(primitive.source_material)];
                if (original) primitive.source_material = static_cast<int>(*original);
            }
        }
    }

    void add_default_material() {
        for (const Mesh& mesh : scene_.meshes) {
            for (const Primitive& primitive : mesh.primitives) {
                if (primitive.source_material >= 0) continue;
                document_.materials.push_back(std::make_shared<const Material>(
                    with_ids_of_place(default_material(), kDefaultPlace)));
                return;
            }
        }
    }

    void read_scene_settings() {
        document_.lights = scene_.lights;
        const int shown = parts_.model.defaultScene;
        if (shown < 0) return;
        const auto text = record_text(parts_.model.scenes[static_cast<std::size_t>(shown)].extras);
        if (!text) return;
        const auto version = record_version(*text);
        const auto record = scene_record_from_json(*text);
        if (!record || !version || *version > kRecordVersion) {
            parts_.warnings.push_back(fmt::format(
                "/scenes/{}: its environment and lights cannot be read and are kept in the file",
                shown));
            return;
        }
        document_.environment = record->environment;
        if (record->lights) document_.lights = *record->lights;
    }

    void keep_image(const Hash128& hash) {
        const auto known = known_images_.find(hash);
        if (known != known_images_.end()) document_.images.insert(*known);
    }

    void keep_images(const Material& material) {
        for (const Hash128& hash : images_of(material.stack)) keep_image(hash);
        for (const auto* map : {&material.specular_map, &material.specular_color_map})
            if (*map) keep_image((*map)->image);
    }

    const DocumentParts& parts_;
    Scene scene_;
    Document document_;
    std::map<Hash128, ImageAssetPtr> known_images_;
    std::vector<std::optional<MaterialRecord>> records_;  ///< by material of the file
    std::vector<std::optional<std::size_t>> stands_for_;  ///< by material of the file
};

}  // namespace

Document read_document(const DocumentParts& parts, Scene scene) {
    return DocumentReader(parts, std::move(scene)).read();
}

}  // namespace patina::io

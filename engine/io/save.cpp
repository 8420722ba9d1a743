// SPDX-License-Identifier: MIT
#include "io/save.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "document/worn_surface.h"
#include "io/container_change.h"
#include "io/file_set.h"
#include "io/glb_write.h"
#include "io/material_save.h"
#include "io/part_materials.h"
#include "io/record_json.h"
#include "io/safe_name.h"
#include "io/uri.h"

namespace patina::io {
namespace {

std::string shown(const std::filesystem::path& path) {
    return quoted_for_message(path.string());
}

Result<Container> container_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".glb") return Container::Glb;
    if (extension == ".gltf") return Container::Gltf;
    return failure("{}: a file to save to ends in .glb or .gltf", shown(path));
}

/// A material to write, and how it was when the file was opened.
struct EditedMaterial {
    MaterialPtr now;
    MaterialPtr before;  ///< null: nothing of it is in the file
};

/// Whether layers of the material read another model than when the file was opened, or its maps
/// are continued past other parts: parts were given to it, or taken from it.
bool reads_other_parts(const Document& document, const Material& now, const Material& before) {
    if (document.assigned == document.opened->assigned) return false;
    if (!reads_surface(now) && now.padding != Padding::Dilate) return false;
    return worn_surface(document, now)->hash() != worn_surface(*document.opened, before)->hash();
}

/// `without_uvs`: written even if they themselves are as they were.
std::vector<EditedMaterial> edited_materials(const Document& document,
                                             const std::set<MaterialId>& without_uvs) {
    std::vector<EditedMaterial> edited;
    for (const MaterialPtr& now : document.materials) {
        const MaterialPtr before =
            document.opened ? find_material(*document.opened, now->id) : nullptr;
        const bool is_unchanged =
            before && (now == before || same_content(document, *now, *document.opened, *before));
        if (is_unchanged && !without_uvs.contains(now->id) &&
            !reads_other_parts(document, *now, *before))
            continue;
        edited.push_back({now, before});
    }
    return edited;
}

std::vector<MaterialPtr> materials_of(const std::vector<EditedMaterial>& edited) {
    std::vector<MaterialPtr> materials;
    for (const EditedMaterial& each : edited) materials.push_back(each.now);
    return materials;
}

bool scene_is_edited(const Document& document) {
    if (!document.opened) return document.environment != EnvironmentSettings{};
    return document.environment != document.opened->environment ||
           document.lights != document.opened->lights;
}

/// All of one save, from the document to the files on disk.
class Saver {
  public:
    Saver(const Document& document, ImageProvider& images, const std::filesystem::path& path,
          const SaveOptions& options, const Progress& progress)
        : document_(document),
          pixels_(images),
          path_(path),
          options_(options),
          progress_(progress) {}

    Result<SaveReport> save() {
        const auto container = container_of(path_);
        if (!container) return passed_on(container);
        if (!document_.source)
            return failure("{}: the document has no source to save into", shown(path_));
        const Status written = save_as(*container);
        if (!written) return passed_on(written);
        report_.path = path_;
        return std::move(report_);
    }

  private:
    Status save_as(Container container) {
        const std::set<MaterialId> without_uvs = shown_without_uvs(document_);
        const std::vector<EditedMaterial> edited = edited_materials(document_, without_uvs);
        const bool converts = container != document_.source->container;
        if (edited.empty() && document_.assigned.empty() && !scene_is_edited(document_) &&
            !converts)
            return write_unchanged();
        auto source =
            with_container(*document_.source, container, path_.stem().string(), report_.warnings);
        if (!source) return failure("{}: {}", shown(path_), source.error().message);
        auto gltf = GltfJson::open(source->json_text);
        if (!gltf) return failure("{}: {}", shown(path_), gltf.error().message);
        GltfImages images(*gltf, *source, owned_images_of(gltf->array("materials")));
        if (const Status ok = write_materials(edited, without_uvs, *gltf, images); !ok) return ok;
        if (scene_is_edited(document_)) write_scene(*gltf);
        keep_images_of_unedited_layers(images);
        if (const Status ok = images.finish(); !ok)
            return failure("{}: {}", shown(path_), ok.error().message);
        if (progress_.cancelled()) return failure("{}: saving was cancelled", shown(path_));
        return container == Container::Glb ? write_glb(*source, *gltf, images)
                                           : write_gltf(*source, *gltf, images);
    }

    /// The file as it was opened, with what it refers to where it goes to another folder.
    Status write_unchanged() {
        const SourceAsset& source = *document_.source;
        auto gltf = GltfJson::open(source.json_text);
        if (!gltf) return failure("{}: {}", shown(path_), gltf.error().message);
        if (const Status ok = add_external_files(source, *gltf); !ok) return ok;
        const auto text = gltf->text();
        if (!text) return failure("{}: {}", shown(path_), text.error().message);
        if (*text == source.json_text) return write({{std::span<const std::byte>(source.file)}});
        if (source.container == Container::Gltf) return write({{bytes_of(*text)}});
        const auto glb = GlbPieces::make({.json_text = *text,
                                          .binary = {source.binary_chunk},
                                          .trailing_chunks = source.trailing_chunks});
        if (!glb) return failure("{}: {}", shown(path_), glb.error().message);
        return write(glb->pieces());
    }

    Status write_materials(const std::vector<EditedMaterial>& edited,
                           const std::set<MaterialId>& without_uvs, GltfJson& gltf,
                           GltfImages& images) {
        MaterialSave save{.document = document_,
                          .pixels = pixels_,
                          .gltf = gltf,
                          .images = images,
                          .places = place_new_materials(materials_of(edited), gltf),
                          .shown_without_uvs = without_uvs,
                          .size = options_.size,
                          .png = {.level = options_.png_level},
                          .progress = progress_,
                          .warnings = {}};
        give_parts_their_materials(document_, save.places, gltf);
        for (std::size_t i = 0; i < edited.size(); ++i) {
            progress_.set_stage(
                fmt::format("Baking {}", quoted_for_message(edited[i].now->name, 60)));
            progress_.report(static_cast<float>(i) / static_cast<float>(edited.size()));
            const auto maps = save_material(save, *edited[i].now, edited[i].before.get());
            if (!maps) return failure("{}: {}", shown(path_), maps.error().message);
            if (options_.keep_maps) report_.maps.emplace(edited[i].now->id, *maps);
            ++report_.materials_written;
            report_.maps_baked += static_cast<int>(std::count_if(
                maps->begin(), maps->end(), [](const auto& map) { return map != nullptr; }));
        }
        report_.warnings.insert(report_.warnings.end(), save.warnings.begin(), save.warnings.end());
        progress_.set_stage("Writing");
        progress_.report(1.0f);
        return {};
    }

    void write_scene(GltfJson& gltf) {
        Json& scenes = gltf.array("scenes");
        const auto index = static_cast<std::size_t>(std::max(gltf.number("scene", 0), 0));
        if (index >= scenes.size()) {
            report_.warnings.push_back(
                "the file has no scene that could hold its environment and lights; "
                "they are not saved");
            return;
        }
        Json& scene = scenes[index];
        SceneRecord record = {.environment = document_.environment, .lights = {}};
        const auto old = scene_record_from_json(record_text(scene));
        const bool lights_of_file =
            document_.opened && document_.lights == document_.opened->lights;
        if (!lights_of_file)
            record.lights = document_.lights;
        else if (old)
            record.lights = old->lights;
        set_record(scene, to_json(record), "the scene", report_.warnings);
    }

    /// What the records of materials that were not edited count on stays in the file.
    void keep_images_of_unedited_layers(GltfImages& images) {
        for (const MaterialPtr& material : document_.materials)
            for (const Hash128& hash : images_of(material->stack)) {
                const auto asset = document_.images.find(hash);
                if (asset != document_.images.end() && asset->second->source_image)
                    images.keep_image(*asset->second->source_image);
            }
    }

    void add_files_beside() {
        std::set<Hash128> added;
        for (const MaterialPtr& material : document_.materials)
            for (const Hash128& hash : images_of(material->stack)) {
                const auto asset = document_.images.find(hash);
                if (asset == document_.images.end() || !added.insert(hash).second) continue;
                const std::string name = file_beside(*asset->second);
                if (!name.empty())
                    side_files_.push_back(
                        {path_.parent_path() / name, asset->second->encoded.bytes()});
            }
    }

    Status write_glb(const SourceAsset& source, GltfJson& gltf, GltfImages& images) {
        if (const Status ok = add_external_files(source, gltf); !ok) return ok;
        const auto text = gltf.text();
        if (!text) return failure("{}: {}", shown(path_), text.error().message);
        std::vector<std::span<const std::byte>> binary = {source.binary_chunk};
        if (const auto& tail = images.binary()) {
            binary.front() = binary.front().first(tail->kept_bytes);
            binary.insert(binary.end(), tail->pieces.begin(), tail->pieces.end());
        }
        const auto glb = GlbPieces::make(
            {.json_text = *text, .binary = binary, .trailing_chunks = source.trailing_chunks});
        if (!glb) return failure("{}: {}", shown(path_), glb.error().message);
        return write(glb->pieces());
    }

    Status write_gltf(const SourceAsset& source, GltfJson& gltf, GltfImages& images) {
        if (const Status ok = add_external_files(source, gltf); !ok) return ok;
        const auto text = gltf.text();
        if (!text) return failure("{}: {}", shown(path_), text.error().message);
        for (const auto& [name, bytes] : images.files())
            side_files_.push_back({path_.parent_path() / name, bytes});
        return write({bytes_of(*text)});
    }

    /// The files that the JSON refers to and that are not yet where the path makes it look for
    /// them. A different file that has the name already is left alone; the new one gets a name with
    /// its hash.
    Status add_external_files(const SourceAsset& source, GltfJson& gltf) {
        add_files_beside();
        const bool in_place = !document_.source->path.empty() &&
                              document_.source->container == source.container &&
                              same_folder(document_.source->path, path_);
        for (const char* array : {"buffers", "images"})
            for (Json& item : gltf.array(array)) {
                const auto file = source.external_files.find(text_at(item, "uri"));
                if (file == source.external_files.end() || !file->second) continue;
                const auto relative = relative_path_of_uri(file->first);
                if (!relative) return failure("{}: {}", shown(path_), relative.error().message);
                const auto target = path_.parent_path() / *relative;
                std::error_code error;
                // An earlier save may have deleted what it superseded and is wanted again.
                if (in_place && std::filesystem::exists(target, error)) continue;
                if (is_another_file(target, *file->second))
                    item["uri"] = add_under_hashed_name(*relative, file->second);
                else
                    side_files_.push_back({target, file->second});
            }
        return {};
    }

    std::string add_under_hashed_name(const std::filesystem::path& relative,
                                      std::shared_ptr<const Bytes> bytes) {
        const std::filesystem::path safe(safe_file_name(relative.filename().string()));
        std::string name = fmt::format("{}-{}{}", safe.stem().string().substr(0, 60),
                                       to_hex(hash_bytes(*bytes)), safe.extension().string());
        side_files_.push_back({path_.parent_path() / name, std::move(bytes)});
        return name;
    }

    static bool same_folder(const std::filesystem::path& a, const std::filesystem::path& b) {
        std::error_code error;
        const auto folder = [&](const std::filesystem::path& path) {
            return std::filesystem::weakly_canonical(
                std::filesystem::absolute(path, error).parent_path(), error);
        };
        return folder(a) == folder(b);
    }

    static bool is_another_file(const std::filesystem::path& path, const Bytes& bytes) {
        std::error_code error;
        if (!std::filesystem::exists(path, error)) return false;
        const auto present = read_file(path);
        return !present || *present != bytes;
    }

    Status write(const std::vector<std::span<const std::byte>>& pieces) {
        if (options_.keep_previous)
            if (const Status kept = keep_previous_version(path_); !kept) return kept;
        const std::vector<std::string> superseded = owned_files_of(path_);
        const Status written = write_files(side_files_, path_, pieces);
        if (!written) return written;
        remove_superseded(path_, superseded);
        for (const auto piece : pieces) report_.bytes += piece.size();
        return {};
    }

    const Document& document_;
    ImageProvider& pixels_;
    const std::filesystem::path& path_;
    const SaveOptions& options_;
    const Progress& progress_;
    SaveReport report_;
    std::vector<SideFile> side_files_;
};

}  // namespace

Result<SaveReport> save_document(const Document& document, ImageProvider& images,
                                 const std::filesystem::path& path, const SaveOptions& options,
                                 const Progress& progress) {
    try {
        return Saver(document, images, path, options, progress).save();
    } catch (const std::exception& fault) {
        return failure("{}: cannot save: {}", shown(path), quoted_for_message(fault.what()));
    }
}

}  // namespace patina::io

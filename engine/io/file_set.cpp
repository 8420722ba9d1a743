// SPDX-License-Identifier: MIT
#include "io/file_set.h"

#include <algorithm>

#include "core/hash.h"
#include "io/gltf_json.h"
#include "io/record_json.h"

namespace patina::io {
namespace {

/// Beyond this many .gltf files in a folder, none is searched and nothing is deleted.
constexpr std::size_t kMaxSearchedFiles = 200;

bool has_content(const std::filesystem::path& path, const Bytes& bytes) {
    std::error_code error;
    if (std::filesystem::file_size(path, error) != bytes.size() || error) return false;
    const auto present = read_file(path);
    return present && *present == bytes;
}

Status write_side_file(const SideFile& file) {
    std::error_code error;
    const auto folder = file.path.parent_path();
    if (!folder.empty()) std::filesystem::create_directories(folder, error);
    if (error)
        return failure("{}: cannot make the folder: {}", quoted_for_message(folder.string()),
                       error.message());
    return write_file_atomically(file.path, *file.bytes);
}

/// Previous versions that were kept ("a.gltf~") among them.
std::vector<std::filesystem::path> gltf_files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry :
         std::filesystem::directory_iterator(folder.empty() ? "." : folder, error))
        if (entry.path().extension() == ".gltf" || entry.path().extension() == ".gltf~")
            files.push_back(entry.path());
    return files;
}

}  // namespace

Status write_files(const std::vector<SideFile>& side_files, const std::filesystem::path& main,
                   std::span<const std::span<const std::byte>> pieces) {
    std::vector<std::filesystem::path> made;
    Status status;
    for (const SideFile& file : side_files) {
        std::error_code error;
        const bool existed = std::filesystem::exists(file.path, error);
        if (existed && has_content(file.path, *file.bytes)) continue;
        status = write_side_file(file);
        if (!status) break;
        if (!existed) made.push_back(file.path);
    }
    if (status) status = write_file_atomically(main, pieces);
    if (status) return {};
    for (const auto& path : made) {
        std::error_code error;
        std::filesystem::remove(path, error);
    }
    return status;
}

Status keep_previous_version(const std::filesystem::path& path) {
    std::error_code error;
    const auto target = std::filesystem::canonical(path, error);
    if (error || !std::filesystem::is_regular_file(target, error)) return {};
    std::filesystem::path kept = target, temporary = target;
    kept += "~";
    temporary += ".keep~";
    std::filesystem::remove(temporary, error);
    std::filesystem::create_hard_link(target, temporary, error);
    if (error) std::filesystem::copy_file(target, temporary, error);
    if (!error) std::filesystem::rename(temporary, kept, error);
    if (!error) return {};
    const std::string reason = error.message();
    std::filesystem::remove(temporary, error);
    return failure("{}: cannot keep the previous version: {}", quoted_for_message(kept.string()),
                   reason);
}

std::vector<std::string> owned_files_of(const std::filesystem::path& path) {
    std::vector<std::string> names;
    if (path.extension() != ".gltf") return names;
    const auto text = read_text_file(path);
    if (!text) return names;
    auto gltf = GltfJson::open(*text);
    if (!gltf) return names;
    const std::set<Hash128> owned = owned_images_of(gltf->array("materials"));
    for (const Json& image : gltf->array("images")) {
        const std::string uri = text_at(image, "uri");
        const bool plain = uri.find_first_of("/\\%:") == std::string::npos;
        const bool own = std::any_of(owned.begin(), owned.end(), [&](const Hash128& hash) {
            return uri.find(to_hex(hash)) != std::string::npos;
        });
        if (plain && own) names.push_back(uri);
    }
    return names;
}

void remove_superseded(const std::filesystem::path& gltf,
                       const std::vector<std::string>& candidates) {
    if (candidates.empty()) return;
    const auto files = gltf_files_in(gltf.parent_path());
    if (files.size() > kMaxSearchedFiles) return;
    std::vector<std::string> unnamed = candidates;
    for (const auto& file : files) {
        const auto text = read_text_file(file);
        if (!text) return;  // what cannot be read may name any of them
        std::erase_if(unnamed, [&](const std::string& name) {
            return text->find(name) != std::string::npos;
        });
    }
    for (const std::string& name : unnamed) {
        std::error_code error;
        std::filesystem::remove(gltf.parent_path() / name, error);
    }
}

}  // namespace patina::io

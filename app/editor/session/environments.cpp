// SPDX-License-Identifier: MIT
#include "editor/session/environments.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/files.h"
#include "io/image_decode.h"
#include "io/uri.h"
#include "render/environment.h"

namespace patina::editor {
namespace {

namespace fs = std::filesystem;

/// A relative path as a document names it: as a URI is written, so that a percent sign survives.
std::string name_of_path(const fs::path& relative) {
    std::string name;
    for (const char letter : relative.generic_string())
        name += letter == '%' ? std::string("%25") : std::string(1, letter);
    return name;
}

tl::unexpected<Error> not_used(const std::string& why) {
    return failure("The document's environment is not used: {}. Drop the file here to use it", why);
}

}  // namespace

Result<ImagePtr> read_environment(const EnvironmentSource& source) {
    if (!source.builtin.empty()) {
        Result<Image> map = render::builtin_environment(source.builtin, render::kBuiltinHeight,
                                                        source.sun_elevation_degrees);
        if (!map) return passed_on(map);
        return std::make_shared<const Image>(std::move(*map));
    }
    const Result<Bytes> file = read_file(source.file);
    if (!file) return passed_on(file);
    return io::decode_image(*file, source.file.string());
}

Environments::Environments() {
    for (const render::BuiltinEnvironment& builtin : render::kBuiltinEnvironments)
        shown_.push_back({std::string(builtin.id), std::string(builtin.label)});
}

std::string Environments::label_of(const std::string& name) {
    for (const render::BuiltinEnvironment& builtin : render::kBuiltinEnvironments)
        if (builtin.id == name) return std::string(builtin.label);
    return quoted_for_message(fs::path(name).stem().string(), 60);
}

void Environments::set_folder(fs::path folder) {
    if (folder == folder_) return;
    folder_ = std::move(folder);
    // Paths from another folder mean nothing here.
    std::erase_if(shown_, [](const EnvironmentShown& each) {
        return !render::is_builtin_environment(each.name) && fs::path(each.name).is_relative();
    });
}

std::string Environments::choose(const fs::path& file) {
    std::error_code error;
    fs::path whole = fs::canonical(file, error);
    if (error) whole = fs::absolute(file, error);
    chosen_.insert(whole);
    if (folder_.empty()) return whole.string();
    const fs::path relative = whole.lexically_relative(fs::canonical(folder_, error));
    const bool below = !relative.empty() && *relative.begin() != "..";
    return below ? name_of_path(relative) : whole.string();
}

Result<EnvironmentSource> Environments::find(const std::string& name) {
    EnvironmentSource source;
    if (render::is_builtin_environment(name)) {
        source.builtin = name;
    } else if (chosen_.contains(name)) {
        source.file = name;
    } else {
        const Result<fs::path> relative = io::relative_path_of_uri(name);
        if (!relative) return not_used(relative.error().message);
        if (folder_.empty()) return not_used("a model without a file has no files beside it");
        const auto file = io::file_under(folder_, *relative);
        if (!file) return not_used(file.error().message);
        if (!*file)
            return not_used(fmt::format("there is no {} beside the model",
                                        quoted_for_message(relative->string(), 100)));
        source.file = **file;
    }
    const bool known = std::any_of(shown_.begin(), shown_.end(),
                                   [&](const auto& each) { return each.name == name; });
    if (!known) shown_.push_back({name, label_of(name)});
    return source;
}

}  // namespace patina::editor

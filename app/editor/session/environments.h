// SPDX-License-Identifier: MIT
#pragma once

/// What can light the scene: the built-in environments, panoramas that were chosen here, and those
/// that a document names. A document may only name what lies in its own folder or below; anything
/// else it names is read after it was chosen here, and not before: a file decides nothing about
/// which others are opened.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/result.h"
#include "document/document.h"
#include "editor/state/shown.h"
#include "scene/image.h"

namespace patina::editor {

/// A built-in environment, or a file that may be read.
struct EnvironmentSource {
    std::string builtin = {};
    std::filesystem::path file = {};
    float sun_elevation_degrees = kSunElevationDegrees;  ///< of the built-in sky
};

/// The panorama: decoded, or made. Any thread.
Result<ImagePtr> read_environment(const EnvironmentSource& source);

class Environments {
  public:
    Environments();

    /// The folder of the document that is open; empty for one without a file.
    void set_folder(std::filesystem::path folder);
    /// A file that the user chose: from now on it may be read. Returns what the document calls it:
    /// a path from its folder where the file lies below that, else the whole path.
    std::string choose(const std::filesystem::path& file);
    /// What a document's EnvironmentSettings::name stands for, and that it is offered from now on.
    /// Fails, saying why and what to do, for a file that is missing or may not be read.
    Result<EnvironmentSource> find(const std::string& name);

    const std::vector<EnvironmentShown>& shown() const { return shown_; }
    static std::string label_of(const std::string& name);

  private:
    std::filesystem::path folder_;
    std::set<std::filesystem::path> chosen_;  ///< absolute
    std::vector<EnvironmentShown> shown_;
};

}  // namespace patina::editor

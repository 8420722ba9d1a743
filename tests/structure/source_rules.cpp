// SPDX-License-Identifier: MIT
#include "structure/source_rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <set>

namespace patina::structure {
namespace {

struct Layer {
    std::string_view folder;                ///< the layer is all files below it
    std::vector<std::string_view> may_use;  ///< beside itself
};

/// The walls of the program. The first entry whose folder a file lies in is its layer.
const std::array kLayers = {
    Layer{"shaders/shared", {}},
    Layer{"shaders/passes", {"shaders/shared"}},
    Layer{"engine/core", {"shaders/shared"}},
    Layer{"engine/scene", {"engine/core", "shaders/shared"}},
    Layer{"engine/document", {"engine/core", "engine/scene", "shaders/shared"}},
    Layer{"engine/composite", {"engine/core", "engine/scene", "engine/document", "shaders/shared"}},
    Layer{"engine/gl", {"engine/core"}},
    Layer{"engine/render",
          {"engine/core", "engine/scene", "engine/document", "engine/composite", "engine/gl",
           "shaders/shared"}},
    Layer{"engine/io",
          {"engine/core", "engine/scene", "engine/document", "engine/composite", "shaders/shared"}},
    Layer{"app/cli",
          {"engine/core", "engine/scene", "engine/document", "engine/composite", "engine/render",
           "engine/io"}},
    Layer{"app/editor",
          {"engine/core", "engine/scene", "engine/document", "engine/composite", "engine/render",
           "engine/io"}},
    Layer{"app", {"app/cli", "app/editor", "engine/core"}},
};

struct Library {
    std::string_view name;
    std::vector<std::string_view> headers;  ///< how the includes begin
    std::vector<std::string_view> folders;  ///< who may include them
};

const std::array kLibraries = {
    Library{"Dear ImGui", {"imgui"}, {"app/editor"}},
    Library{"GLFW", {"GLFW/"}, {"app/editor"}},
    Library{"OpenGL", {"epoxy/", "GL/", "EGL/"}, {"engine/gl", "engine/render"}},
    Library{"tinygltf", {"tiny_gltf"}, {"engine/io"}},
    Library{"OpenImageIO", {"OpenImageIO/"}, {"engine/io/openimageio"}},
    Library{"libtiff", {"tiffio"}, {"engine/io"}},
    Library{"CLI11", {"CLI/"}, {"app/cli"}},
    Library{"FreeType", {"ft2build", "freetype"}, {"app/cli"}},
    Library{"Highway", {"hwy/"}, {"engine/core/formulae", "engine/composite", "engine/io"}},
};

bool lies_in(std::string_view path, std::string_view folder) {
    return path.size() > folder.size() && path.starts_with(folder) && path[folder.size()] == '/';
}

bool is_program_source(std::string_view path) {
    return has_extension(path, {".h", ".cpp", ".glsl", ".vert", ".frag", ".geom"}) &&
           (lies_in(path, "engine") || lies_in(path, "app") || lies_in(path, "shaders"));
}

const Layer* layer_of(std::string_view path) {
    const auto found = std::find_if(kLayers.begin(), kLayers.end(), [&](const Layer& layer) {
        return lies_in(path, layer.folder);
    });
    return found == kLayers.end() ? nullptr : &*found;
}

bool may_use(const Layer& from, const Layer& to) {
    return from.folder == to.folder ||
           std::find(from.may_use.begin(), from.may_use.end(), to.folder) != from.may_use.end();
}

std::string place(const std::string& path, int line) {
    return path + ":" + std::to_string(line) + ": ";
}

/// Calls `visit(path, include)` for every include of the program's own sources.
void for_each_include(
    const SourceTree& tree,
    const std::function<void(const std::string& path, const Include& include)>& visit) {
    for (const auto& [path, text] : tree) {
        if (!is_program_source(path)) continue;
        for (const Include& include : includes_of(text)) visit(path, include);
    }
}

using Graph = std::map<std::string, std::set<std::string>>;

/// Depth-first search for one way round; finds a cycle if there is any.
class CycleSearch {
  public:
    explicit CycleSearch(const Graph& graph) : graph_(graph) {}

    /// The nodes of a cycle, its first again at the end; empty without one.
    std::vector<std::string> run() {
        for (const auto& [node, targets] : graph_)
            if (visit(node)) return trail_;
        return {};
    }

  private:
    bool visit(const std::string& node) {
        const auto open = std::find(trail_.begin(), trail_.end(), node);
        if (open != trail_.end()) {
            trail_.erase(trail_.begin(), open);
            trail_.push_back(node);
            return true;
        }
        if (!done_.insert(node).second) return false;
        trail_.push_back(node);
        if (const auto targets = graph_.find(node); targets != graph_.end())
            for (const std::string& target : targets->second)
                if (visit(target)) return true;
        trail_.pop_back();
        return false;
    }

    const Graph& graph_;
    std::set<std::string> done_;
    std::vector<std::string> trail_;
};

void report_cycle(Faults& faults, std::string_view what, const Graph& graph) {
    const std::vector<std::string> cycle = CycleSearch(graph).run();
    if (cycle.empty()) return;
    std::string line = "cycle of " + std::string(what) + ": " + cycle.front();
    for (std::size_t i = 1; i < cycle.size(); ++i) line += " -> " + cycle[i];
    faults.push_back(line);
}

int line_at(std::string_view text, std::size_t position) {
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + position, '\n'));
}

struct Banned {
    std::string text;
    std::string_view why;
};

/// The words are put together here so that this file does not breach its own rule.
std::vector<Banned> banned_words() {
    constexpr std::string_view kElsewhere = "lies outside of the repository: say the rule in place";
    return {
        {std::string("TO") + "DO", "finish it or leave it out"},
        {std::string("FIX") + "ME", "finish it or leave it out"},
        {std::string("/ho") + "me/", "a path of one machine"},
        {std::string("/wo") + "rk/", "a path of one machine"},
        {std::string("/ro") + "ot/", "a path of one machine"},
        {std::string("npm") + "js.", "the host of a package registry is the user's to choose"},
        {std::string("deb.") + "debian", "the host of a package registry is the user's to choose"},
        {std::string("DES") + "IGN", kElsewhere},
        {std::string("ROBUST") + "NESS", kElsewhere},
        {std::string("PERFORM") + "ANCE.md", kElsewhere},
        {std::string("STY") + "LE.md", kElsewhere},
        {std::string("ROAD") + "MAP.md", kElsewhere},
        {std::string("FEAT") + "URES.md", kElsewhere},
    };
}

/// Whether the file's name has one of the words that say nothing, as a whole word.
bool says_nothing(std::string_view path) {
    const std::string_view name = path.substr(path.rfind('/') + 1);
    std::string word;
    for (const char letter : std::string(name) + '.') {
        if (std::isalpha(static_cast<unsigned char>(letter)) != 0) {
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
            continue;
        }
        for (const std::string_view vague : {"util", "utils", "helper", "helpers", "manager"})
            if (word == vague) return true;
        word.clear();
    }
    return false;
}

}  // namespace

Faults include_direction_faults(const SourceTree& tree) {
    Faults faults;
    for_each_include(tree, [&](const std::string& path, const Include& include) {
        if (!include.quoted) return;
        const std::string target = resolved_include(tree, include.text);
        const Layer* from = layer_of(path);
        const Layer* to = layer_of(target);
        if (target.empty())
            faults.push_back(place(path, include.line) + "\"" + include.text +
                             "\" is not a path from engine/, app/ or shaders/");
        else if (from == nullptr || to == nullptr)
            faults.push_back(place(path, include.line) + "\"" + include.text +
                             "\": one of the two lies in no layer");
        else if (!may_use(*from, *to))
            faults.push_back(place(path, include.line) + std::string(from->folder) +
                             " may not include " + target);
    });
    return faults;
}

Faults library_faults(const SourceTree& tree) {
    Faults faults;
    for_each_include(tree, [&](const std::string& path, const Include& include) {
        for (const Library& library : kLibraries) {
            const auto begins = [&](std::string_view prefix) {
                return include.text.starts_with(prefix);
            };
            const auto holds = [&](std::string_view folder) { return lies_in(path, folder); };
            if (std::any_of(library.headers.begin(), library.headers.end(), begins) &&
                std::none_of(library.folders.begin(), library.folders.end(), holds))
                faults.push_back(place(path, include.line) + std::string(library.name) +
                                 " is not for this folder");
        }
    });
    return faults;
}

Faults include_cycle_faults(const SourceTree& tree) {
    Graph files;
    Graph folders;
    for_each_include(tree, [&](const std::string& path, const Include& include) {
        const std::string target = resolved_include(tree, include.text);
        if (!include.quoted || target.empty()) return;
        files[path].insert(target);
        if (folder_of(path) != folder_of(target))
            folders[folder_of(path)].insert(folder_of(target));
    });
    Faults faults;
    report_cycle(faults, "files", files);
    report_cycle(faults, "folders", folders);
    return faults;
}

Faults licence_faults(const SourceTree& tree) {
    Faults faults;
    for (const auto& [path, text] : tree) {
        if (!has_extension(path, {".h", ".cpp", ".glsl", ".vert", ".frag", ".geom", ".sh", ".cjs",
                                  ".mjs", ".py", ".cmake", "CMakeLists.txt"}) &&
            path != "run" && path != "test" && path != ".ci/run")
            continue;
        // Below a #! or #version line, which must be the first.
        const std::size_t first = text.find('\n');
        const std::size_t second = first == std::string::npos ? first : text.find('\n', first + 1);
        if (text.substr(0, second).find("SPDX-License-Identifier: MIT") == std::string::npos)
            faults.push_back(path + ": has no SPDX-License-Identifier line at its top");
    }
    return faults;
}

Faults wording_faults(const SourceTree& tree) {
    Faults faults;
    const std::vector<Banned> words = banned_words();
    for (const auto& [path, text] : tree) {
        if (says_nothing(path)) faults.push_back(path + ": its name does not say what it is about");
        for (const Banned& word : words)
            if (const std::size_t at = text.find(word.text); at != std::string::npos)
                faults.push_back(place(path, line_at(text, at)) + word.text + ": " +
                                 std::string(word.why));
    }
    return faults;
}

}  // namespace patina::structure

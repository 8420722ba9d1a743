// SPDX-License-Identifier: MIT
#include "structure/source_tree.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

namespace patina::structure {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFolders = {".ci", "app", "engine", "presets", "shaders", "tests"};

std::string read_text(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

bool is_binary(std::string_view path) {
    return has_extension(path, {".png", ".jpg", ".hdr", ".exr", ".glb", ".bin", ".tif"});
}

void add_file(SourceTree& tree, const fs::path& root, const fs::path& path) {
    std::string relative = path.lexically_relative(root).generic_string();
    if (!is_binary(relative)) tree.emplace(std::move(relative), read_text(path));
}

}  // namespace

SourceTree read_source_tree(const fs::path& root) {
    SourceTree tree;
    for (const auto& entry : fs::directory_iterator(root))
        // In a worktree .git is a file, and not ours.
        if (entry.is_regular_file() && entry.path().filename() != ".git")
            add_file(tree, root, entry.path());
    for (const char* folder : kFolders) {
        if (!fs::is_directory(root / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
            if (entry.is_regular_file()) add_file(tree, root, entry.path());
    }
    return tree;
}

std::vector<Include> includes_of(std::string_view source) {
    std::vector<Include> includes;
    int line_number = 0;
    while (!source.empty()) {
        const std::string_view line = source.substr(0, source.find('\n'));
        source.remove_prefix(std::min(source.size(), line.size() + 1));
        ++line_number;
        const std::size_t hash = line.find_first_not_of(" \t");
        if (hash == std::string_view::npos || line[hash] != '#') continue;
        const std::size_t word = line.find_first_not_of(" \t", hash + 1);
        if (word == std::string_view::npos || !line.substr(word).starts_with("include")) continue;
        const std::size_t open = line.find_first_of("\"<", word);
        if (open == std::string_view::npos) continue;
        const bool quoted = line[open] == '"';
        const std::size_t close = line.find(quoted ? '"' : '>', open + 1);
        if (close == std::string_view::npos) continue;
        includes.push_back({.text = std::string(line.substr(open + 1, close - open - 1)),
                            .quoted = quoted,
                            .line = line_number});
    }
    return includes;
}

std::string resolved_include(const SourceTree& tree, std::string_view text) {
    for (const char* base : {"engine/", "app/", "shaders/"}) {
        const std::string path = base + std::string(text);
        if (tree.contains(path)) return path;
    }
    return {};
}

std::string folder_of(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    return std::string(slash == std::string_view::npos ? "" : path.substr(0, slash));
}

bool has_extension(std::string_view path, std::initializer_list<std::string_view> extensions) {
    return std::any_of(extensions.begin(), extensions.end(),
                       [&](std::string_view extension) { return path.ends_with(extension); });
}

}  // namespace patina::structure

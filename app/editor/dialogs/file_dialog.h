// SPDX-License-Identifier: MIT
#pragma once

/// Choosing a file: a list of a folder, a filter by ending, a path that can be typed.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "editor/widgets/ui.h"

namespace patina::editor {

class FileDialog {
  public:
    struct Request {
        std::string title;                    ///< "Open a model"
        std::string button;                   ///< "Open"
        std::vector<std::string> extensions;  ///< with the dot; empty: all
        std::string name;                     ///< to begin with, of a file to write
        bool writing = false;                 ///< asks before an existing file is replaced
        bool folder = false;                  ///< a folder is chosen
        std::function<void(const std::filesystem::path&)> chosen;
    };
    /// Opens it, in the folder that was looked at last.
    void open(Request request);
    /// From now on.
    void look_in(const std::filesystem::path& folder) { folder_ = folder; }
    bool is_open() const { return request_.has_value(); }
    void draw(Ui& ui);

  private:
    struct Entry {
        std::string name;
        bool is_folder = false;
        std::uintmax_t bytes = 0;
    };
    void read_folder();
    void go_to(const std::filesystem::path& folder);
    void draw_path(Ui& ui, Rect row);
    void draw_list(Ui& ui, const Rect& rect);
    void draw_buttons(Ui& ui, Rect row);
    void accept();

    std::optional<Request> request_;
    std::filesystem::path folder_;
    std::vector<Entry> entries_;
    std::string typed_path_;
    std::string name_;
    std::string problem_;
    bool confirm_replace_ = false;
    bool focus_name_ = false;
};

}  // namespace patina::editor

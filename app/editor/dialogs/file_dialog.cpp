// SPDX-License-Identifier: MIT
#include "editor/dialogs/file_dialog.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "editor/dialogs/modal.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/number_text.h"
#include "editor/widgets/text_field.h"

namespace patina::editor {
namespace {

namespace fs = std::filesystem;

std::string lowered(std::string words) {
    for (char& letter : words)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return words;
}

bool has_ending(const fs::path& path, const std::vector<std::string>& endings) {
    const std::string ending = lowered(path.extension().string());
    return endings.empty() || std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// "~" is the home folder, a relative path is below `base`.
fs::path resolved(const std::string& typed_path, const fs::path& base) {
    const char* home = std::getenv("HOME");
    if (home != nullptr && (typed_path == "~" || typed_path.starts_with("~/")))
        return fs::path(home) / (typed_path.size() > 2 ? typed_path.substr(2) : "");
    const fs::path path(typed_path);
    return path.is_absolute() ? path : base / path;
}

std::string size_words(std::uintmax_t bytes) {
    if (bytes < 1'000'000) return fmt::format("{} kB", (bytes + 999) / 1000);
    return megabytes(bytes, 1);
}

}  // namespace

void FileDialog::open(Request request) {
    std::error_code error;
    if (folder_.empty()) folder_ = fs::current_path(error);
    request_ = std::move(request);
    name_ = request_->name;
    confirm_replace_ = false;
    problem_.clear();
    focus_name_ = true;
    go_to(folder_);
}

void FileDialog::go_to(const fs::path& folder) {
    std::error_code error;
    const fs::path real = fs::weakly_canonical(folder, error);
    folder_ = error ? folder : real;
    typed_path_ = folder_.string();
    read_folder();
}

void FileDialog::read_folder() {
    entries_.clear();
    problem_.clear();
    std::error_code error;
    for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
        std::error_code ignored;
        Entry entry{it->path().filename().string(), it->is_directory(ignored), 0};
        if (entry.name.starts_with(".")) continue;
        if (!entry.is_folder && (request_->folder || !has_ending(it->path(), request_->extensions)))
            continue;
        if (!entry.is_folder) entry.bytes = it->file_size(ignored);
        entries_.push_back(std::move(entry));
    }
    if (error) problem_ = fmt::format("Cannot list {}: {}", folder_.string(), error.message());
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
        if (a.is_folder != b.is_folder) return a.is_folder;
        return lowered(a.name) < lowered(b.name);
    });
}

void FileDialog::draw_path(Ui& ui, Rect row) {
    if (icon_button(ui, row.cut_left(ui.px(26)),
                    {.icon = icon::kArrowUp, .label = "Folder above"})) {
        go_to(folder_.parent_path());
        return;
    }
    row.cut_left(ui.px(6));
    if (!line_field(ui, row, "Path", typed_path_)) return;
    const fs::path path = resolved(typed_path_, folder_);
    std::error_code error;
    if (fs::is_directory(path, error)) {
        go_to(path);
    } else {
        folder_ = path.parent_path();
        name_ = path.filename().string();
        accept();
    }
}

void FileDialog::draw_list(Ui& ui, const Rect& rect) {
    fill(ui, rect, theme::kPanel, 4);
    ScrollArea area(ui, "files", rect);
    Rect row = area.content();
    row.y1 = row.y0 + ui.px(26);
    std::optional<fs::path> enter;
    bool accepted = false;
    for (const Entry& entry : entries_) {
        const bool selected = !entry.is_folder && entry.name == name_;
        const Press pressed = press(ui, row,
                                    {.label = entry.name,
                                     .kind = entry.is_folder ? "folder" : "file",
                                     .value = selected ? "selected" : ""});
        row_tint(ui, row, selected, pressed.hovered);
        Rect inner = row.inset(ui.px(10), 0);
        icon_glyph(ui, inner.cut_left(ui.px(18)), entry.is_folder ? icon::kFolder : icon::kFile,
                   entry.is_folder ? theme::kText2 : theme::kText3, 13);
        inner.cut_left(ui.px(6));
        if (!entry.is_folder)
            text(ui, inner.cut_right(ui.px(70)), ui.fonts.caption11, theme::kText3,
                 size_words(entry.bytes), Align::Right);
        text(ui, inner, ui.fonts.body13, theme::kText, entry.name);
        if (pressed.clicked && entry.is_folder) enter = folder_ / entry.name;
        if (pressed.clicked && !entry.is_folder) {
            name_ = entry.name;
            confirm_replace_ = false;
        }
        if (pressed.double_clicked && !entry.is_folder) accepted = true;
        row = row.moved(0, row.height());
    }
    if (entries_.empty() && problem_.empty())
        text(ui, row.inset(ui.px(12), 0), ui.fonts.body13, theme::kText3,
             request_->folder ? "No folders in here" : "No such files in here");
    area.set_height(static_cast<float>(entries_.size()) * row.height());
    if (enter) go_to(*enter);
    if (accepted) accept();
}

void FileDialog::accept() {
    if (request_->folder) {
        const auto chosen = request_->chosen;
        const fs::path folder = folder_;
        request_.reset();
        chosen(folder);
        return;
    }
    if (name_.empty()) {
        problem_ = "Choose a file or type its name";
        return;
    }
    fs::path path = resolved(name_, folder_);
    if (request_->writing && !has_ending(path, request_->extensions))
        path += request_->extensions.front();
    std::error_code error;
    const bool exists = fs::exists(path, error);
    if (!request_->writing && !exists) {
        problem_ = fmt::format("There is no {} in this folder", path.filename().string());
        return;
    }
    if (request_->writing && exists && !confirm_replace_) {
        confirm_replace_ = true;
        problem_ = fmt::format("{} exists. Replace it?", path.filename().string());
        return;
    }
    const auto chosen = request_->chosen;
    request_.reset();
    chosen(path);
}

void FileDialog::draw_buttons(Ui& ui, Rect row) {
    const TextButton go{.label = confirm_replace_ ? std::string_view("Replace")
                                                  : std::string_view(request_->button),
                        .main = true};
    const bool accepted = dialog_button(ui, row, go);
    const bool cancelled = dialog_button(ui, row, {.label = "Cancel"});
    row.cut_right(ui.px(6));
    if (!problem_.empty()) {
        icon_glyph(ui, row.cut_left(ui.px(16)), icon::kWarning, theme::kWarning, 13);
        row.cut_left(ui.px(6));
        text(ui, row, ui.fonts.value12, theme::kWarning, problem_);
    }
    if (cancelled)
        request_.reset();
    else if (accepted)
        accept();
}

void FileDialog::draw(Ui& ui) {
    if (!request_) return;
    const Modal modal(ui, {"File dialog", 640, 480}, [this] { return is_open(); });
    Rect rest = modal.content().inset(ui.px(16));
    text(ui, rest.cut_top(ui.px(20)), ui.fonts.name15, theme::kText, request_->title);
    rest.cut_top(ui.px(10));
    Rect buttons = rest.cut_bottom(ui.px(26));
    rest.cut_bottom(ui.px(12));
    const bool named = !request_->folder;
    Rect name_row;
    if (named) {
        name_row = rest.cut_bottom(ui.px(26));
        rest.cut_bottom(ui.px(8));
    }
    draw_path(ui, rest.cut_top(ui.px(26)));
    rest.cut_top(ui.px(8));
    if (!request_) return;
    draw_list(ui, rest);
    if (!request_) return;
    if (named) {
        text(ui, name_row.cut_left(ui.px(46)), ui.fonts.body13, theme::kText2, "Name");
        const bool focus = std::exchange(focus_name_, false);
        if (line_field(ui, name_row, "Name", name_, focus)) accept();
    }
    if (!request_) return;
    draw_buttons(ui, buttons);
    if (request_ && modal.dismissed() && ui.typing.id == 0) request_.reset();
}

}  // namespace patina::editor

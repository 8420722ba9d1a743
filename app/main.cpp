// SPDX-License-Identifier: MIT
#include "cli/command_line.h"
#include "editor/editor.h"

int main(int argc, char** argv) {
    const patina::cli::Invocation invocation = patina::cli::parse(argc, argv);
    if (const auto* exit = std::get_if<patina::cli::ExitStatus>(&invocation)) return exit->value;
    if (const auto* editor = std::get_if<patina::cli::EditorRequest>(&invocation))
        return patina::editor::run({.file = editor->file,
                                    .ui_map = editor->ui_map,
                                    .scale = editor->scale,
                                    .window_width = editor->window_width,
                                    .window_height = editor->window_height,
                                    .refining_draws = editor->refining_draws});
    return patina::cli::run(std::get<std::function<patina::Status()>>(invocation));
}

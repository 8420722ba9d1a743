// SPDX-License-Identifier: MIT
#include "cli/command_line.h"

int main(int argc, char** argv) {
    const patina::cli::Invocation invocation = patina::cli::parse(argc, argv);
    if (const auto* exit = std::get_if<patina::cli::ExitStatus>(&invocation)) return exit->value;
    return patina::cli::run(std::get<std::function<patina::Status()>>(invocation));
}

// SPDX-License-Identifier: MIT
// patina completion: what a shell needs to complete commands, options and their values. It is made
// from the same declarations that parse the command line, so it knows all of them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/commands.h"

namespace patina::cli {
namespace {

constexpr const char* kCompletionFooter =
    "'cmake --install' puts it where bash looks for it. By hand:\n"
    "  source <(patina completion)";

constexpr std::string_view kHead = R"(# bash completion for patina, made by 'patina completion'.
# The words that follow an option.
_patina_after() {
    local i
    for ((i = 1; i < COMP_CWORD; ++i)); do
        [[ ${COMP_WORDS[i]} == "$1" ]] && printf '%s\n' "${COMP_WORDS[i + 1]%%@*}"
    done
}
# Offers the materials of a file that begin so, behind a prefix; a name with spaces is one word.
_patina_materials() {
    local name
    while IFS= read -r name; do
        [[ $name == "$2"* ]] || continue
        printf -v name '%q' "$name"
        COMPREPLY+=("$3$name")
    done < <([[ -n $1 ]] && patina info "${1/#\~/$HOME}" --materials 2>/dev/null)
}
_patina() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command= words= i
    local file= layers='--preset|--material-preset|--textures|--layer'
    COMPREPLY=()
    # Bash takes the "@" of NAME@MATERIAL for a word, unless COMP_WORDBREAKS is without it.
    [[ $word == @ ]] && before=@ word=
    for ((i = 1; i < COMP_CWORD; ++i)); do
        [[ -z $file && ${COMP_WORDS[i]} =~ \.(glb|gltf)$ ]] && file=${COMP_WORDS[i]}
        case "$command ${COMP_WORDS[i]}" in
)";
constexpr std::string_view kValues = R"(        esac
    done
    if [[ $before =~ ^($layers)$ && $word == *@* ]]; then
        _patina_materials "$file" "${word#*@}" "${word%%@*}@"
        return
    fi
    case "$command $before" in
)";
constexpr std::string_view kOptions = R"(        *' --preset' | *' --material-preset')
            words=$(patina preset list 2>/dev/null | cut -d' ' -f1)
            COMPREPLY=($(compgen -W "$words" -- "$word"))
            compopt -o default 2>/dev/null
            return ;;
        *' --knob')
            # Of the presets that were given, else of all.
            words=$(patina preset knobs $(_patina_after --preset) \
                    $(_patina_after --material-preset) 2>/dev/null |
                cut -d' ' -f1 | sed 'p;s|.*/||' | sort -u)
            COMPREPLY=($(compgen -W "$words" -S = -- "$word"))
            compopt -o nospace 2>/dev/null
            return ;;
        *' --material' | *' @')
            _patina_materials "$file" "$word"
            return ;;
    esac
    case "$command" in
)";
constexpr std::string_view kTail = R"(    esac
    [[ $word == -* || $command == '' || $command == ' preset' ]] &&
        COMPREPLY=($(compgen -W "$words" -- "$word"))
    # Whatever is no word of the command line's own is a file.
    ((${#COMPREPLY[@]})) || compopt -o default 2>/dev/null
}
complete -F _patina patina
)";

/// The words that a "a|b|c" option takes; empty for others.
std::string values_of(const CLI::Option& option) {
    std::string type = option.get_type_name();
    type = type.substr(0, type.find(':'));
    if (type.find('|') == std::string::npos) return {};
    std::replace(type.begin(), type.end(), '|', ' ');
    return type;
}

/// Calls `visit(command, its words such as " preset list")` for `app` and all below it.
template <typename Visit>
void for_each_command(const CLI::App& app, const std::string& path, const Visit& visit) {
    visit(app, path);
    for (const CLI::App* below : app.get_subcommands([](const CLI::App*) { return true; }))
        for_each_command(*below, path + " " + below->get_name(), visit);
}

std::vector<std::string> flags_of(const CLI::Option& option) {
    std::vector<std::string> flags;
    for (const std::string& name : option.get_lnames()) flags.push_back("--" + name);
    for (const std::string& name : option.get_snames()) flags.push_back("-" + name);
    return flags;
}

std::string completion_script(const CLI::App& root) {
    std::string script(kHead);
    for_each_command(root, "", [&](const CLI::App&, const std::string& path) {
        if (!path.empty()) script += fmt::format("            '{}') command='{}' ;;\n", path, path);
    });
    script += kValues;
    for_each_command(root, "", [&](const CLI::App& command, const std::string& path) {
        for (const CLI::Option* option : command.get_options()) {
            const std::string values = values_of(*option);
            if (values.empty()) continue;
            for (const std::string& flag : flags_of(*option))
                script += fmt::format(
                    "        '{} {}') COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n",
                    path, flag, values);
        }
    });
    script += kOptions;
    for_each_command(root, "", [&](const CLI::App& command, const std::string& path) {
        std::vector<std::string> words;
        for (const CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; }))
            words.push_back(below->get_name());
        for (const CLI::Option* option : command.get_options())
            for (const std::string& flag : flags_of(*option)) words.push_back(flag);
        script += fmt::format("        '{}') words='{}' ;;\n", path, fmt::join(words, " "));
    });
    script += kTail;
    return script;
}

}  // namespace

void add_completion(CLI::App& app, Command& chosen) {
    auto* command = app.add_subcommand("completion", "Print the completion script for bash");
    command->footer(kCompletionFooter);
    command->callback([&app, &chosen] {
        chosen = [script = completion_script(app)]() -> Status {
            fmt::print("{}", script);
            return {};
        };
    });
}

}  // namespace patina::cli

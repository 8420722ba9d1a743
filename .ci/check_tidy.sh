#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs clang-tidy over the sources of engine/ and app/:  check_tidy.sh BUILD_FOLDER [--alone]
# BUILD_FOLDER is a release build that is up to date; Ninja's log there knows each file's headers.
#
# Nearly all of its time goes by in headers, so the files of a folder are looked at together, as one
# text that includes them; those that do not compile together are halved until they do. --alone looks
# at each by itself: it also sees an alias that is unused in its file and used in another.
#
# A file that passed is not looked at again until it, one of Patina's headers that it includes, the
# checks or the build's description change. What passed is remembered by a hash of all those in
# ~/.cache/patina/tidy, so that a fresh clone profits too.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

build_folder=$1
files_together=12
[[ ${2:-} == --alone ]] && files_together=1
passed_folder=${XDG_CACHE_HOME:-$HOME/.cache}/patina/tidy/$files_together
work_folder=$(mktemp -d)
trap 'rm -rf "$work_folder"' EXIT
mkdir -p "$passed_folder"
export passed_folder work_folder

# "SOURCE DEPENDENCY" for each file of this tree that an object of engine/ or app/ is made from.
# Ninja lists paths as seen from the build folder. Sources that were compiled as one text share what
# each of them includes.
list_dependencies() {
    ninja -C "$build_folder" -t deps | awk -v tree="$PWD/" '
        function flush(  source, path) {
            for (source in paths) if (source ~ /\.cpp$/) for (path in paths) print source, path
            delete paths
        }
        /^[^ ]/ { flush(); wanted = /^(engine|app)\// }
        /^ / && wanted {
            path = $1
            if (index(path, tree) == 1) path = substr(path, length(tree) + 1)
            while (sub(/^\.\.\//, "", path)) {}
            if (path ~ /^(engine|app|shaders)\// && path !~ /^(engine|app)\/CMakeFiles\//) paths[path]
        }
        END { flush() }' | sort -u
}

# "SOURCE HASH" for each source: the hash of everything that its verdict hangs on.
list_keys() {
    local common dependencies=$work_folder/dependencies
    common=$( (clang-tidy-14 --version; cat .clang-tidy CMakeLists.txt CMakePresets.json \
        engine/CMakeLists.txt app/CMakeLists.txt "$0") | sha256sum)
    list_dependencies >"$dependencies"
    awk '{ print $2 }' "$dependencies" | sort -u | xargs sha256sum |
        awk -v common="$common" '
            FILENAME == "-" { hash[$2] = $1; next }
            { text[$1] = text[$1] " " $2 "=" hash[$2] }
            END { for (source in text) print source, common, text[source] }' - "$dependencies" |
        while read -r source text; do
            printf '%s %s\n' "$source" "$(sha256sum <<<"$source $text" | cut -c1-40)"
        done | sort
}

# "SOURCE FLAG..." for each source, as Clang is to compile it. CMake writes a member a line.
list_flags() {
    awk -v tree="$PWD/" '
        function unescaped(text) {
            gsub(/\\\\/, "\001", text); gsub(/\\"/, "\"", text); gsub(/\001/, "\\", text)
            return text
        }
        /"command": / { sub(/^.*clang\+\+-14 /, ""); sub(/ -o .*$/, ""); flags = unescaped($0) }
        /"file": / { gsub(/^.*": "|",?$/, ""); print substr($0, length(tree) + 1), flags }' \
        build/clang/compile_commands.json | sort -u -k1,1
}

# tidy FLAGS FILE [OPTION...]: kernels are looked at for one instruction set.
tidy() {
    eval "clang-tidy-14 --quiet $(printf '%q ' "${@:2}") -- $1 -DHWY_COMPILE_ONLY_STATIC" 2>/dev/null
}

# check FLAGS "SOURCE KEY"...: looks at files that are compiled with the same flags. Every verdict is
# printed in one piece.
check() {
    local flags=$1 text output half status=0; shift
    local -a sources=("${@% *}") keys=("${@#* }") call
    if (($# == 1)); then
        call=("$PWD/${sources[0]}")
    else
        text=$work_folder/${keys[0]}.cpp
        printf "#include \"$PWD/%s\"\n" "${sources[@]}" >"$text"
        call=("$text" --config-file="$PWD/.clang-tidy" --header-filter='/(engine|app)/'
            --checks=-bugprone-suspicious-include)
    fi
    if output=$(tidy "$flags" "${call[@]}"); then
        (cd "$passed_folder" && touch "${keys[@]}")
        printf 'passed %s\n' "${sources[@]}"
    elif (($# > 1)) && [[ $output == *clang-diagnostic-* ]]; then
        half=$(($# / 2))
        check "$flags" "${@:1:half}" || status=1
        check "$flags" "${@:half + 1}" || status=1
        return "$status"
    else
        printf 'FAILED %s\n%s\n' "${sources[*]}" "$output"
        return 1
    fi
}

# check_batch FILE: its lines are "SOURCE KEY FLAG...", all with the same flags.
check_batch() {
    local -a files
    mapfile -t files < <(cut -d' ' -f1-2 "$1")
    check "$(head -1 "$1" | cut -d' ' -f3-)" "${files[@]}"
}
export -f tidy check check_batch

list_keys >"$work_folder/keys"
while read -r source key; do
    # Touching marks it as used; what is unused for a month goes.
    if [[ -f $passed_folder/$key ]]; then touch "$passed_folder/$key"; else echo "$source $key"; fi
done <"$work_folder/keys" >"$work_folder/changed"
find "${passed_folder%/*}" -type f -mtime +30 -delete

echo "clang-tidy: $(wc -l <"$work_folder/changed") of $(wc -l <"$work_folder/keys") files have changed"
# Highway compiles a file with kernels again for every instruction set, which it can do once in a text.
grep -rl hwy/foreach_target.h engine app >"$work_folder/kernels"
list_flags >"$work_folder/flags"
join "$work_folder/changed" "$work_folder/flags" >"$work_folder/calls"
join -v 1 "$work_folder/changed" "$work_folder/flags" >"$work_folder/unknown"
if [[ -s $work_folder/unknown ]]; then
    echo "build/clang does not say how these are compiled; configure it anew (cmake --preset clang):"
    cut -d' ' -f1 "$work_folder/unknown"
    exit 1
fi
awk -v most="$files_together" -v kernels="$work_folder/kernels" -v folder="$work_folder" '
    BEGIN { while ((getline path <kernels) > 0) alone[path] = 1 }
    { path = $1; sub(/\/[^\/]*$/, "", path)
      flags = $0; sub(/^[^ ]+ [^ ]+ /, "", flags)
      group = ($1 in alone ? $1 : path) " " flags
      if (count[group]++ % most == 0) file[group] = folder "/batch" ++made
      print >(file[group]) }' "$work_folder/calls"
find "$work_folder" -name 'batch*' -print0 |
    xargs -r -0 -P "$(nproc)" -n 1 bash -c 'check_batch "$1"' check_batch

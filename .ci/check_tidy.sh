#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs clang-tidy over the sources of engine/ and app/:  check_tidy.sh BUILD_FOLDER
# BUILD_FOLDER is a release build that is up to date; Ninja's log there knows each file's headers.
#
# A file that passed is not looked at again until it, one of Patina's headers that it includes, the
# checks or the build's description change. What passed is remembered by a hash of all those in
# ~/.cache/patina/tidy, so that a fresh clone profits too.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

build_folder=$1
passed_folder=${XDG_CACHE_HOME:-$HOME/.cache}/patina/tidy
work_folder=$(mktemp -d)
trap 'rm -rf "$work_folder"' EXIT
mkdir -p "$passed_folder"

# "SOURCE DEPENDENCY" for each file of this tree that an object of engine/ or app/ is made from.
# Ninja lists the source itself first, and paths as seen from the build folder.
list_dependencies() {
    ninja -C "$build_folder" -t deps | awk -v tree="$PWD/" '
        /^[^ ]/ { wanted = /^(engine|app)\//; source = "" }
        /^ / && wanted {
            path = $1
            if (index(path, tree) == 1) path = substr(path, length(tree) + 1)
            while (sub(/^\.\.\//, "", path)) {}
            if (path !~ /^(engine|app|shaders)\//) next
            if (source == "") source = path
            print source, path }'
}

# "HASH SOURCE" for each source: the hash of everything that its verdict hangs on.
list_keys() {
    local common dependencies=$work_folder/dependencies
    common=$( (clang-tidy-14 --version; cat .clang-tidy CMakeLists.txt CMakePresets.json \
        engine/CMakeLists.txt app/CMakeLists.txt) | sha256sum)
    list_dependencies >"$dependencies"
    awk '{ print $2 }' "$dependencies" | sort -u | xargs sha256sum |
        awk -v common="$common" '
            FILENAME == "-" { hash[$2] = $1; next }
            { text[$1] = text[$1] " " $2 "=" hash[$2] }
            END { for (source in text) print source, common, text[source] }' - "$dependencies" |
        while read -r source text; do
            printf '%s %s\n' "$(sha256sum <<<"$text" | cut -c1-40)" "$source"
        done
}

# Checks one file and remembers that it passed. Its output is printed in one piece.
check_one() {
    local key=$1 source=$2 output
    if output=$(clang-tidy-14 -p build/clang --quiet "$source" 2>/dev/null); then
        touch "$3/$key"
        echo "passed $source"
    else
        printf 'FAILED %s\n%s\n' "$source" "$output"
        return 1
    fi
}
export -f check_one

list_keys | sort -k2 >"$work_folder/keys"
while read -r key source; do
    # Touching marks it as used; what is unused for a month goes.
    if [[ -f $passed_folder/$key ]]; then touch "$passed_folder/$key"; else echo "$key $source"; fi
done <"$work_folder/keys" >"$work_folder/changed"
find "$passed_folder" -type f -mtime +30 -delete

echo "clang-tidy: $(wc -l <"$work_folder/changed") of $(wc -l <"$work_folder/keys") files have changed"
xargs -r -a "$work_folder/changed" -P "$(nproc)" -n 2 \
    bash -c 'check_one "$2" "$3" "$1"' check_one "$passed_folder"

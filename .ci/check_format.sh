#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fails when clang-format would change a source file; says which and how to mend it.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

if ! find app engine tests \( -name '*.cpp' -o -name '*.h' \) -print0 |
    xargs -0 -P "$(nproc)" -n 16 clang-format-14 --dry-run --Werror; then
    echo 'To mend it: clang-format-14 -i FILE...'
    exit 1
fi

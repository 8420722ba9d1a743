# SPDX-License-Identifier: MIT
# Sourced by ./run and ./test: what a bare Debian 12 needs before it can build Patina.

say() { printf '\n== %s\n' "$*"; }

# How many compilers to run at once: one a processor, and no more than one for each GiB of memory.
parallel_jobs() {
    local processors gib
    processors=$(nproc)
    gib=$(awk '/^MemAvailable:/ { print int($2 / 1048576) }' /proc/meminfo)
    if ((gib < 1)); then echo 1; else echo $((processors < gib ? processors : gib)); fi
}

# packages_of SECTION...: the names in those sections of packages.txt.
packages_of() {
    local section
    for section in "$@"; do
        awk -v wanted="[$section]" '/^\[/ { inside = $0 == wanted; next } inside && /^[a-z0-9]/' \
            .ci/packages.txt
    done
}

# missing_packages NAME...: those that are not installed.
missing_packages() {
    local installed
    # dpkg-query exits 1 when it does not know some of the names.
    installed=$(dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null |
        awk '$1 == "installed" { print $2 }') || true
    comm -23 <(printf '%s\n' "$@" | sort -u) <(sort -u <<<"$installed")
}

# install_packages NAME...: as root, through sudo, or not at all; then it says what to type.
install_packages() {
    local -a as_root=()
    if ((EUID != 0)); then
        if ! command -v sudo >/dev/null; then
            printf 'These packages are missing and there is no sudo to install them. As root, type:\n\n'
            printf '    apt-get update && apt-get install --yes --no-install-recommends %s\n\n' "$*"
            return 1
        fi
        printf 'sudo is needed to install them with apt-get; it may ask for your password.\n'
        as_root=(sudo)
    fi
    "${as_root[@]}" apt-get update
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install --yes --no-install-recommends "$@"
}

# require_packages SECTION...: installs what is missing of those sections of packages.txt.
require_packages() {
    local -a wanted missing
    mapfile -t wanted < <(packages_of "$@")
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "This is not Debian: the counterparts of these packages are taken to be installed"
        printf '%s\n' "${wanted[*]}"
        return
    fi
    mapfile -t missing < <(missing_packages "${wanted[@]}")
    if ((${#missing[@]} == 0)); then return; fi
    say "Installing ${#missing[@]} of ${#wanted[@]} packages that Patina is built with (.ci/packages.txt)"
    printf '%s\n' "${missing[*]}"
    install_packages "${missing[@]}"
}

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The whole `patina bake` of stack-10, files to files, beside other programs of the same work:
#   peers.sh [BUILD_FOLDER [SIZE [ROUNDS]]]          (build/release, 2048, 3)
# Uncompressed TIFF in, two PNG maps out, one thread each, CPU time, least of the rounds, in turns.
# Whichever of these is installed takes part (Debian: ruby-vips, python3-numpy, python3-opencv,
# python3-pil, imagemagick, openimageio-tools). Their maps are compared with Patina's.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."
build=$(readlink -f "${1:-build/release}") size=${2:-2048} rounds=${3:-3}
scripts=$PWD/tests/benchmarks/peers
python=$(PATH=/usr/bin:$PATH command -v python3 || true)
magick=$(PATH=/usr/bin:$PATH command -v convert || true)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$build/tests/benchmarks/patina_bench" --write-stack10 "$work" "$size"
cd "$work"

export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 VIPS_CONCURRENCY=1 MAGICK_THREAD_LIMIT=1

run_patina() {
    "$build/app/patina" bake quad.glb --preset ./stack10.json --size "$size" --maps "$1" \
        --threads 1 --quiet
    mv "$1"/*_base-color.png "$1/base.png"
    mv "$1"/*_occlusion-roughness-metalness.png "$1/packed.png"
}
run_numpy() { "$python" "$scripts/stack10_numpy.py" . "$1"; }
run_opencv() { "$python" "$scripts/stack10_numpy.py" --opencv . "$1"; }
run_vips() { ruby "$scripts/stack10_vips.rb" . "$1"; }

run_imagemagick() {
    local -A modes=([multiply]=Multiply [screen]=Screen [overlay]=Overlay [soft-light]=SoftLight
        [normal]=Over)
    local -a color=(base.tif -alpha off) rough=(-size "${size}x$size" "xc:gray(50.19608%)")
    local -a metal=(-size "${size}x$size" xc:black)
    local i=0 mode opacity metalness
    while read -r mode opacity metalness; do
        local -a cover=('(' "color$i.tif" -alpha extract "mask$i.tif" -compose Multiply -composite
            -evaluate Multiply "$opacity" -write "mpr:cover$i" ')')
        local -a own=("color$i.tif" -alpha off)
        # Porter and Duff's plus is no mode: it does not hold what is added before it is laid.
        if [[ $mode == add ]]; then
            own=(-clone 0 '(' "color$i.tif" -alpha off ')' -compose Plus -composite)
            mode=normal
        fi
        color+=('(' "${own[@]}" "${cover[@]}" -compose CopyOpacity -composite ')'
            -compose "${modes[$mode]}" -composite)
        rough+=('(' "roughness$i.tif" "mpr:cover$i" -compose CopyOpacity -composite ')'
            -compose Over -composite)
        metal+=('(' -size "${size}x$size" "xc:gray($(awk "BEGIN { print 100 * $metalness }")%)"
            "mpr:cover$i" -compose CopyOpacity -composite ')' -compose Over -composite)
        i=$((i + 1))
    done <stack10.txt
    "$magick" '(' "${color[@]}" -alpha off -write "PNG24:$1/base.png" +delete ')' \
        '(' -size "${size}x$size" xc:white ')' '(' "${rough[@]}" -alpha off ')' \
        '(' "${metal[@]}" -alpha off ')' -set colorspace sRGB -combine "PNG24:$1/packed.png"
}

# Operators on oiiotool's stack; what is chosen by a threshold elsewhere is clamped ramps here.
run_oiiotool() {
    local -a work=(--threads 1 --no-autopremult base.tif --label color
        --create "${size}x$size" 1 --addc 0.501960784 --label rough
        --create "${size}x$size" 1 --label metal)
    local i=0 mode opacity metalness
    while read -r mode opacity metalness; do
        work+=("color$i.tif" --ch R,G,B --label own
            "color$i.tif" --ch A "mask$i.tif" --mul --mulc "$opacity" --label cover)
        case $mode in
            normal) work+=(own) ;;
            multiply) work+=(color own --mul) ;;
            screen) work+=(color own --add color own --mul --sub) ;;
            overlay) work+=(color --mulc 2 --minc 1 own --mul
                color --mulc 2 --subc 1 --maxc 0 --label light
                --add light own --mul --sub) ;;
            add) work+=(color own --add --minc 1) ;;
            soft-light) work+=(color --mulc 16 --subc 12 color --mul --addc 4 color --mul
                color --powc 0.5 --min color --sub own --mulc 2 --subc 1 --maxc 0 --mul
                color color color --mul --sub own --mulc 2 --subc 1 --minc 0 --mul --add
                color --add) ;;
        esac
        work+=(color --sub cover --ch 0,0,0 --mul color --add --label color
            "roughness$i.tif" rough --sub cover --mul rough --add --label rough
            metal --mulc -1 --addc "$metalness" cover --mul metal --add --label metal)
        i=$((i + 1))
    done <stack10.txt
    oiiotool "${work[@]}" color -d uint8 -o "$1/base.png" \
        --create "${size}x$size" 1 --addc 1 rough --chappend metal --chappend \
        --chnames R,G,B -d uint8 -o "$1/packed.png"
}

can_run() {
    case $1 in
        patina) true ;;
        numpy | opencv) "$python" -c 'import numpy, cv2, PIL' 2>/dev/null ;;
        vips) ruby -e 'require "vips"' 2>/dev/null ;;
        imagemagick) [[ -n $magick ]] ;;
        oiiotool) command -v oiiotool >/dev/null ;;
    esac
}

# The CPU seconds of user and system of "run_NAME OUTPUT".
cpu_seconds() {
    local TIMEFORMAT='%U %S' times
    times=$({ time "run_$1" "$2" >/dev/null 2>"$2/messages"; } 2>&1) ||
        { cat "$2/messages" >&2; echo "$1 failed" >&2; return 1; }
    awk '{ print $1 + $2 }' <<<"$times"
}

peers=()
for peer in patina numpy opencv vips imagemagick oiiotool; do
    if can_run "$peer"; then peers+=("$peer"); else echo "$peer is not installed: left out"; fi
done

declare -A least
for ((round = 0; round < rounds; round++)); do
    for peer in "${peers[@]}"; do
        rm -rf "out-$peer" && mkdir "out-$peer"
        seconds=$(cpu_seconds "$peer" "out-$peer")
        least[$peer]=$(awk "BEGIN { a = ${least[$peer]:-1e9}; print $seconds < a ? $seconds : a }")
    done
done

# In steps of 1/255.
largest_difference() {
    { compare -metric PAE "out-patina/$2.png" "out-$1/$2.png" null: 2>&1 || true; } |
        sed 's/.*(\(.*\)).*/\1/' | awk '{ print 255 * $1 }'
}

echo "stack-10 at $size, files to files, one thread, least CPU time of $rounds rounds"
for peer in "${peers[@]}"; do
    target=10
    case $peer in imagemagick | oiiotool) target=30 ;; patina) target=1 ;; esac
    printf '%-12s %8.2f s  %6.1f times Patina (target %d)' "$peer" "${least[$peer]}" \
        "$(awk "BEGIN { print ${least[$peer]} / ${least[patina]} }")" "$target"
    [[ $peer == patina ]] || ! command -v compare >/dev/null ||
        printf '   differs by at most %.0f and %.0f of 255' "$(largest_difference "$peer" base)" \
            "$(largest_difference "$peer" packed)"
    echo
done

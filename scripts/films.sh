#!/usr/bin/env bash
# A film and a contact sheet of each system that can be generated, at ten of the study's 100 targets, to be looked at:
#   scripts/films.sh FOLDER [SYSTEM ...]
# FOLDER/SYSTEM.mp4 has one gesture after another, FOLDER/SYSTEM.png each gesture's hold. Needs ffmpeg, and a program
# (DEIXIS; else build/release/deixis).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
out=${1:?names no folder; see above in scripts/films.sh}
shift
systems=("$@")
[ ${#systems[@]} -gt 0 ] ||
    systems=(gt-nn flow gp amp-pfnn-8 amp-pfnn-3 amp-pfnn-1 amp-base amp-no-runtime moglow)
deixis=${DEIXIS:-build/release/deixis}
mkdir -p "$out"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$deixis" targets pointing2023 >"$work/targets.csv" 2>"$work/said"
for system in "${systems[@]}"; do
    rm -f "$work"/films "$work"/*.png
    # Every tenth target.
    awk -F, 'NR > 1 && NR % 10 == 2 {print $1, $2, $3, $4}' "$work/targets.csv" | while read -r id x y z; do
        shot=(view --system "$system" --target "$x" "$y" "$z" --size 720x400 --force)
        "$deixis" "${shot[@]}" --mp4 "$work/$id.mp4" </dev/null >/dev/null
        "$deixis" "${shot[@]}" --screenshot "$work/$id.png" </dev/null >/dev/null
        echo "file '$work/$id.mp4'" >>"$work/films"
    done
    ffmpeg -y -loglevel error -f concat -safe 0 -i "$work/films" -c copy "$out/$system.mp4"
    ffmpeg -y -loglevel error -pattern_type glob -i "$work/*.png" -vf tile=5x2 -frames:v 1 "$out/$system.png"
    echo "$out/$system.mp4 and .png"
done

#!/usr/bin/env bash
# Makes the pictures of the documents with the program itself: docs/images/*, but for headset.png, which needs a headset's
# runtime. The pages are pictured by Chromium; the experimenter's window and the replay need somebody at a desktop: a
# scripted person on a virtual display.
#   scripts/pictures.sh [PROGRAM]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=${1:-build/release/deixis}
[ -x "$program" ] || { echo "pictures.sh: build the release preset first (scripts/pilot.sh)" >&2; exit 1; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p docs/images

# STUDY PARTICIPANT STATE=PICTURE ...
session() {
    local study=$1 participant=$2 options=()
    shift 2
    for wanted in "$@"; do options+=(--screenshot "${wanted%%=*}=docs/images/${wanted#*=}.png"); done
    "$program" run "$study" --station simulated --participant "$participant" --db "$scratch/$study.sqlite" "${options[@]}" --force
}
session pointing2023 P01 rating=naturalness aiming-across=across pointing-side-by-side=side-by-side
session sgtoolkit2021 P7 check=parallel # the check is at the third movement of its page: two are rated by then
session genea-pairwise P01 pointing=pairwise
session free-placement P01 chosen-across=placement
"$program" targets pointing2023 --picture docs/images/targets.svg --force >/dev/null

# What is missing here keeps its picture.
has() {
    command -v "$1" >/dev/null || { echo "pictures.sh: no $1, $2 stays as it was" >&2; return 1; }
}
if has Xvfb operator.png && has xdotool operator.png && has import operator.png; then
    python3 -B tests/desktop/rig/for_documents.py --program "$program" --folder docs/images
fi
# PAGE HEIGHT PICTURE
page_picture() {
    chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size="1280,$2" --virtual-time-budget=20000 \
        --user-data-dir="$scratch/browser" --screenshot="$PWD/docs/images/$3" "file://$1" 2>/dev/null
}
if has chromium "systems.png, report.png, evaluation.png"; then
    "$program" targets pointing2023 2>/dev/null | sed -n '1p;13p' >"$scratch/one.csv" # up to the left
    echo '<style>body { margin: 8px; font: 18px sans-serif } div { display: flex; align-items: center } p { width: 150px }</style>' \
        >"$scratch/systems.html"
    for system in gt-nn moglow amp-no-runtime amp-base amp-pfnn-1 amp-pfnn-3 amp-pfnn-8 gp flow; do
        "$program" generate "$system" --targets "$scratch/one.csv" -o "$scratch/one-$system" >/dev/null
        "$program" view "$scratch/one-$system/${system}_T012.bvh" --from front --size 155x155 \
            --time 0.4 0.8 1.1 1.6 2.2 2.7 3.2 --screenshot "$scratch/$system.png"
        echo "<div><p>$system</p><img src=$system.png></div>" >>"$scratch/systems.html"
    done
    page_picture "$scratch/systems.html" 1430 systems.png
    "$program" simulate pointing2023 --participants 39 -o "$scratch/study.sqlite"
    "$program" report "$scratch/study.sqlite" -o "$scratch/report.html"
    page_picture "$scratch/report.html" 1600 report.png
    "$program" targets --grid >"$scratch/grid.csv"
    for system in gt-nn moglow amp-base amp-pfnn-8; do
        "$program" generate "$system" --targets "$scratch/grid.csv" -o "$scratch/$system" >/dev/null
    done
    "$program" evaluate "$scratch"/{gt-nn,moglow,amp-base,amp-pfnn-8} -o "$scratch/evaluation.html"
    page_picture "$scratch/evaluation.html" 1600 evaluation.png
fi
if [ -d tests/web/node_modules ] && has node studio.png; then
    ONLY=looks,tour DEIXIS_SLOW_MACHINE=1 node tests/web/check_studio.mjs "$(dirname "$program")/share/deixis" "$scratch/studio" "$program"
    cp "$scratch/studio/pose-1280x720-light.png" docs/images/studio.png
    cp "$scratch"/studio/tour-?.png docs/images
fi

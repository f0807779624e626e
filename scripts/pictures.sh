#!/usr/bin/env bash
# Makes the README pictures with the program itself: docs/images/*. The report is pictured by Chromium.
#   scripts/pictures.sh [PROGRAM]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=${1:-build/release/deixis}
[ -x "$program" ] || { echo "pictures.sh: build the release preset first (scripts/pilot.sh)" >&2; exit 1; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p docs/images

"$program" run pointing2023 --station simulated --participant P01 --db "$scratch/one.sqlite" --size 1280x720 \
    --screenshot rating=docs/images/naturalness.png \
    --screenshot aiming-across=docs/images/across.png \
    --screenshot pointing-side-by-side=docs/images/side-by-side.png
"$program" simulate pointing2023 --participants 39 --db "$scratch/study.sqlite"
"$program" report "$scratch/study.sqlite" -o "$scratch/report.html"
"$program" targets pointing2023 --picture docs/images/targets.svg >/dev/null
command -v chromium >/dev/null || { echo "pictures.sh: no chromium, the report's picture stays as it was" >&2; exit 0; }
chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1280,1440 \
    --user-data-dir="$scratch/browser" --screenshot="$PWD/docs/images/report.png" "file://$scratch/report.html" 2>/dev/null

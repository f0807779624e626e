#!/usr/bin/env bash
# From clone to report: installs what is missing, builds, and runs one participant through the pointing study.
# Arguments go to `deixis run`, such as --participant P07 or --station simulated.
set -euo pipefail
here=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install.sh
[ -f build/release/build.ninja ] || cmake --preset release -Wno-dev >/dev/null
cmake --build --preset release --target deixis | { grep -v 'no work to do' || true; }

name=pointing2023
station=()
if [[ " $* " != *" --station"* ]]; then
    if [ -n "${DISPLAY:-}" ]; then
        station=(--station desktop)
    else
        echo "No display: the simulated participant does the session; pictures of what it sees: pilot/*.png"
        mkdir -p pilot
        station=(--station simulated)
        # Whoever goes on with a session may be past these.
        [ $# -gt 0 ] || station+=(--force --screenshot "rating=$PWD/pilot/rating.png"
            --screenshot "aiming-across=$PWD/pilot/game.png")
        name=pointing2023-simulated # never mixed with what people answered
    fi
fi
database=()
if [[ " $* " != *" --db"* ]]; then
    [[ " $* " != *" simulated"* ]] || name=pointing2023-simulated
    mkdir -p pilot
    database=(--db "$PWD/pilot/$name.sqlite")
fi
program=$PWD/build/release/deixis
cd "$here" # paths among the arguments are the caller's
exec "$program" run pointing2023 "${station[@]}" "${database[@]}" "$@"

#!/usr/bin/env bash
# Times `deixis evaluate` on 7 systems of 1,000 clips of 180 frames, made by a built-in system (about 2.5 GB).
#   scripts/bench_evaluate.sh [PROGRAM] [FOLDER]     PROGRAM: build/release/deixis; FOLDER is kept for the next time
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=$(realpath "${1:-build/release/deixis}")
folder=${2:-build/bench-evaluate}
mkdir -p "$folder"
cd "$folder"
"$program" targets --grid 1000 >grid.csv
for i in 1 2 3 4 5 6 7; do
    [ -f "system-$i/manifest.csv" ] && continue
    "$program" generate stiff --targets grid.csv --hold 3.94 --seed "$i" -o "system-$i" >/dev/null
    sed -i "s/,stiff,/,system-$i,/" "system-$i/manifest.csv"
done
grep -m 1 '^Frames:' system-1/stiff_G0001.bvh
du -sh .
TIMEFORMAT='%R s wall, %U s user, %S s system'
for threads in 1 2; do
    echo "threads: $threads"
    time "$program" evaluate system-* --threads "$threads" -o evaluation.html >/dev/null
done

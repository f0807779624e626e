#!/usr/bin/env bash
# Two builds of the program, such as one by gcc and one by clang, must give the same plan, the same clips, the same
# simulated answers and the same report, byte for byte.
#   scripts/compare_builds.sh build/dev/deixis build/offline/deixis
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for which in 1 2; do
    program=$(realpath "${!which}")
    mkdir "$scratch/$which"
    cd "$scratch/$which"
    "$program" plan pointing2023 --participant P07 --json >plan.json
    "$program" simulate pointing2023 --participants 5 --db study.sqlite >/dev/null
    "$program" report study.sqlite -o report.html --json analysis.json >/dev/null
    sqlite3 -readonly study.sqlite \
        "select participant, trial_index, rating, chosen_place, response_time_s, clip_hash from responses order by 1, 2" \
        >answers.txt
    [ "$(wc -l <answers.txt)" -eq 300 ]
    rm study.sqlite
    cd "$OLDPWD"
done
diff -rq "$scratch/1" "$scratch/2" || { echo "compare: the two builds differ in the above"; exit 1; }
echo "compare: plans, $(find "$scratch/1/stimuli" -name '*.bvh' | wc -l) clips, 300 simulated answers and reports are byte-equal"

#!/usr/bin/env bash
# Two builds of the program, such as one by gcc and one by clang, must give the same plans, the same clips, the same
# locked study, simulated answers and the same reports, byte for byte, in every study that ships. That a report names its program's
# compiler, build type and libraries is left out.
#   scripts/compare_builds.sh build/dev/deixis build/offline/deixis
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
studies=$(basename -s .toml assets/data/studies/*.toml)
for which in 1 2; do
    program=$(realpath "${!which}")
    mkdir "$scratch/$which"
    cd "$scratch/$which"
    for study in $studies; do
        "$program" plan "$study" --participant P07 --json >"$study-plan.json"
        "$program" simulate "$study" --participants 3 --db study.sqlite --stimuli stimuli >/dev/null
        "$program" report study.sqlite -o "$study.html" --json "$study.json" --csv "$study-csv" --latex "$study-latex" >/dev/null
        sqlite3 -readonly study.sqlite \
            "select participant, trial_index, status, chosen_place, response_time_s, question, stimulus, value, text
             from responses_flat order by 1, 2, question, stimulus" >"$study-answers.txt"
        sed -i -E 's#<dt>(Compiler|Build type|Libraries)</dt><dd>[^<]*</dd>##g' "$study.html"
        sed -i -E '/^ +"(compiler|build_type|libraries)": /d' "$study.json"
        [ "$(wc -l <"$study-answers.txt")" -ge 40 ]
        cp study.locked/*/locked.sha256 "$study-locked.sha256"
        rm -rf study.*
    done
    cd "$OLDPWD"
done
diff -rq "$scratch/1" "$scratch/2" || { echo "compare: the two builds differ in the above"; exit 1; }
echo "compare: plans, $(find "$scratch/1/stimuli" -name '*.bvh' | wc -l) clips," \
    "$(cat "$scratch"/1/*-answers.txt | wc -l) simulated answers and reports of $(wc -w <<<"$studies") studies are byte-equal"

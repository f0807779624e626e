#!/usr/bin/env bash
# Deichler et al. (2023) from demonstrations to results, and one page with the paper's results beside ours
# (docs/reproduction.md). What is there already in DIR is not made again: after an interruption the same command goes on.
#   scripts/reproduce.sh            trains all systems first, which takes hours on two cores
#   scripts/reproduce.sh --quick    with the weights that come with the program: minutes
#   -o DIR            where everything goes [reproduction]
#   --program FILE    the program [built here: scripts/install.sh and the preset release, or learning to train]
#   --updates N       trains for so many updates only, to see whether all works
#   --grid N          so many test points, a cube number [1000]
#   --participants N  so many simulated participants of each kind [39]
set -euo pipefail
here=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
    echo "reproduce.sh: $1" >&2
    sed -n '2,/^set/{/^# /s/^# //p}' scripts/reproduce.sh >&2
    exit 2
}
out=reproduction program="" updates=() points=1000 participants=39 train=true
while [ $# -gt 0 ]; do
    case $1 in
    --quick) train=false && shift && continue ;;
    -o | --program | --updates | --grid | --participants) [ $# -gt 1 ] || usage "$1 needs a value" ;;
    *) usage "unknown: $1" ;;
    esac
    case $1 in
    -o) out=$2 ;;
    --program) program=$(cd "$here" && realpath "$2") ;;
    --updates) updates=(--updates "$2") ;;
    --grid) points=$2 ;;
    --participants) participants=$2 ;;
    esac
    shift 2
done
if [ -z "$program" ]; then
    preset=release
    if $train; then preset=learning && scripts/install.sh learning; else scripts/install.sh; fi
    [ -f build/$preset/build.ninja ] || cmake --preset $preset -Wno-dev >/dev/null
    cmake --build --preset $preset --target deixis | { grep -v 'no work to do' || true; }
    program=$PWD/build/$preset/deixis
fi
data=$(dirname "$program")/share/deixis
[ -d "$data" ] || data=$(dirname "$program")/../share/deixis
data=$(realpath "$data")
cd "$here" && mkdir -p "$out" && cd "$out"

say() { echo "== $* ($((SECONDS / 60)) min)"; }
# made WHAT COMMAND...: once; a folder or file that is there is whole, since the program writes all or nothing.
made() {
    local what=$1
    shift
    [ -e "$what" ] || "$@"
}
made_text() { # made_text FILE COMMAND...: what the command prints
    local what=$1
    shift
    [ -e "$what" ] || { "$@" >"$what.new" 2>"$what.log" && mv "$what.new" "$what"; } || { cat "$what.log" >&2 && exit 1; }
}

systems=(gt-nn moglow amp-no-runtime amp-base amp-pfnn-1 amp-pfnn-3 amp-pfnn-8 gp flow)
of_study=(gt-nn moglow amp-base amp-pfnn-8)

say "demonstrations"
made_text demonstrations.csv "$program" targets --demonstrations
made demonstrations "$program" generate gt-nn --targets demonstrations.csv -o demonstrations
made_text hands.csv "$program" clips measure demonstrations/manifest.csv --csv
made demonstrations.html "$program" evaluate demonstrations -o demonstrations.html
made_text study.csv "$program" targets pointing2023 --picture targets.svg --force

mkdir -p weights
learn() { # learn FILE ARGUMENTS...: goes on where it was broken off
    local file=weights/$1.weights
    shift
    [ -e "$file" ] && [ ! -e "$file.training" ] || "$program" learn "$@" "${updates[@]}" -o "$file" --force
}
if $train; then
    say "training; Ctrl-C is safe, the same command goes on"
    made_text half.csv awk 'NR == 1 || NR % 2' demonstrations.csv
    made half "$program" generate gt-nn --targets half.csv -o half
    learn moglow moglow
    learn amp-no-runtime amp-no-runtime
    learn amp-base amp-base
    for clusters in 1 3 8; do learn amp-pfnn-$clusters amp-pfnn --clusters $clusters; done
    made weights/flow.weights "$program" learn flow -o weights/flow.weights "${updates[@]}"
    learn amp-pfnn-1-unmirrored amp-pfnn --clusters 1 --no-mirror
    learn amp-pfnn-1-half amp-pfnn --clusters 1 --demonstrations half/manifest.csv
    learn moglow-unmirrored moglow --no-mirror
    learn moglow-half moglow --demonstrations half/manifest.csv
    # Rewarded for something else, and how much the task counts.
    for clusters in 1 8; do
        for reward in eye-fingertip observer; do
            learn amp-pfnn-$clusters-$reward amp-pfnn --clusters $clusters --reward $reward
        done
    done
    for weight in 0 0.25 0.75 0.9; do
        learn amp-pfnn-1-task-$weight amp-pfnn --clusters 1 --set task_weight=$weight \
            --set "style_weight=$(awk "BEGIN { print 1 - $weight }")"
    done
    # Not the paper's.
    learn amp-pfnn-1-plus amp-pfnn --clusters 1 --set separate_critics=1 --set discriminator_window=10 \
        --set lipschitz_penalty=0.002 --set power_penalty=0.0005
else
    for file in "$data"/weights/*.weights; do made "weights/$(basename "$file")" cp "$file" weights/; done
fi

# clips GRID SYSTEM: the rows of systems trained otherwise are named so.
clips() {
    local folder=$1/$2 weights=() system
    system=$(sed -E 's/^(amp-pfnn-[0-9]+|moglow)-.*/\1/' <<<"$2")
    [ ! -e "$folder" ] || return 0
    [ ! -e "weights/$2.weights" ] || weights=(--weights "weights/$2.weights")
    "$program" generate "$system" --targets "$1.csv" "${weights[@]}" -o "$folder.new" --force >/dev/null
    [ "$system" = "$2" ] || sed -i "s/,$system,/,$2,/" "$folder.new/manifest.csv"
    mv "$folder.new" "$folder"
}
for file in weights/*-*-*-*.weights weights/moglow-*.weights; do # systems trained otherwise
    [ ! -e "$file" ] || systems+=("$(basename "$file" .weights)")
done
say "objective evaluation"
made_text box.csv "$program" targets --grid "$points"
made_text spherical.csv "$program" targets --grid "$points" --spherical
for grid in box spherical; do
    for system in "${systems[@]}"; do clips $grid "$system"; done
    made $grid.json "$program" evaluate "${systems[@]/#/$grid/}" -o $grid.html --json $grid.json
done
for system in "${of_study[@]}"; do clips study "$system"; done
made study.json "$program" evaluate "${of_study[@]/#/study/}" --study pointing2023 -o study.html --json study.json

say "the study with simulated participants"
# The study with these clips.
study=pointing2023
if [ ! -e $study.toml ]; then
    cp "$data/studies/$study.toml" $study.new
    for system in "${of_study[@]}"; do
        sed -i "s|^generator = \"$system\"|manifest = \"study/$system/manifest.csv\"|" $study.new
    done
    mv $study.new $study.toml
fi
kinds=(two-cue arm-finger eye-fingertip)
for kind in "${kinds[@]}"; do
    sed "s/^ray = \"two-cue\"/ray = \"$kind\"/" "$data/simulated_participant.toml" >$kind.toml
    made $kind.sqlite "$program" simulate $study.toml --participants "$participants" --parameters $kind.toml \
        -o $kind.sqlite
    made $kind.json "$program" report $kind.sqlite --evaluation study.json -o $kind.html --json $kind.json
done

say "the page"
arguments=()
for grid in box spherical; do arguments+=(--grid "$grid grid=$grid.json" --page $grid.html); done
for kind in "${kinds[@]}"; do arguments+=(--study "$kind=$kind.json" --page $kind.html); done
for system in "${systems[@]}"; do
    [ ! -e "weights/$system.weights" ] || arguments+=(--weights "weights/$system.weights")
done
"$program" reproduction "${arguments[@]}" --ceiling study.json --demonstrations hands.csv --picture targets.svg \
    --page study.html --page demonstrations.html -o reproduction.html --force
say "done: $out/reproduction.html"

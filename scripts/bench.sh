#!/usr/bin/env bash
# Builds the benchmarks as the release preset does, in build/bench, and prints the medians of five repetitions.
# Arguments go to the program: scripts/bench.sh --benchmark_filter=store
#   scripts/bench.sh learning    those of the trainers instead, which need LibTorch, in build/bench-learning
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=build/bench program=deixis_bench options=()
scripts/install.sh tests
if [ "${1:-}" = learning ]; then
    shift
    scripts/install.sh learning
    folder=build/bench-learning program=deixis_learning_bench options=(-DDEIXIS_LEARNING=ON)
    export OMP_NUM_THREADS=1 # what is told is a core's
fi
cmake --preset release -B $folder -DDEIXIS_BENCH=ON -DDEIXIS_TESTS=OFF "${options[@]}" -Wno-dev >/dev/null
cmake --build $folder --target $program -- --quiet
exec $folder/$program --benchmark_repetitions=5 --benchmark_report_aggregates_only=true "$@"

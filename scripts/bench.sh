#!/usr/bin/env bash
# Builds the benchmarks as the release preset does, in build/bench, and prints the medians of five repetitions.
# Arguments go to the program: scripts/bench.sh --benchmark_filter=store
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/install.sh tests
cmake --preset release -B build/bench -DDEIXIS_BENCH=ON -DDEIXIS_TESTS=OFF -Wno-dev >/dev/null
cmake --build build/bench --target deixis_bench -- --quiet
exec build/bench/deixis_bench --benchmark_repetitions=5 --benchmark_report_aggregates_only=true "$@"

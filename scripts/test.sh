#!/usr/bin/env bash
# Installs what the tests need, builds, runs every check and test, and ends with the counts.
#   scripts/test.sh          everything: style, lint, three builds (gcc, clang without graphics, sanitizers), and the
#                            program once more on Debian 13, where the headset's tests run (needs root)
#   scripts/test.sh dev      one preset's tests only
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install.sh tests
[ -d tests/assets/gltf_validator/node_modules ] || npm ci --silent --prefix tests/assets/gltf_validator

mkdir -p build/test-logs
counts=()
run_preset() {
    echo "== $1: configure and build"
    cmake --preset "$1" -Wno-dev >/dev/null
    local log=build/test-logs/$1.log status=0
    if ! cmake --build --preset "$1" >"$log" 2>&1; then
        tail -n 60 "$log"
        counts+=("$1: the build failed")
        return 1
    fi
    tail -n 1 "$log"
    echo "== $1: tests"
    ctest --preset "$1" -j2 --timeout 1200 2>&1 | tee "$log" || status=$?
    counts+=("$1: $(grep -E 'tests passed' "$log" || echo 'no result')")
    return "$status"
}

presets=("$@")
[ ${#presets[@]} -gt 0 ] || {
    scripts/check_style.sh
    presets=(dev offline asan)
}
status=0
for preset in "${presets[@]}"; do run_preset "$preset" || status=1; done
if [ $# -eq 0 ]; then
    scripts/compare_builds.sh build/dev/deixis build/offline/deixis || status=1
    scripts/lint.sh || status=1
    scripts/test_headset.sh --scenarios-only 2>&1 | tee build/test-logs/headset.log || status=1
    counts+=("$(grep -E '^headset: [0-9]+ passed' build/test-logs/headset.log || echo 'headset: no result')")
fi

echo
printf '%s\n' "${counts[@]}"
[ "$status" -eq 0 ] && echo "All passed." || echo "Something failed: see above."
exit "$status"

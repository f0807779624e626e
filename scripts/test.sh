#!/usr/bin/env bash
# Installs what the tests need, builds, runs the tests, and ends with the counts.
#   scripts/test.sh          style, and every test once, by Clang with address and undefined-behaviour sanitizers
#   scripts/test.sh all      the same (long calculations by the program without sanitizers), and: the program by GCC, with
#                            the trainers, which are tried; compared with Clang's byte for byte, without graphics,
#                            installed, at the desktop in real time, its pages in a browser; lint; what a browser will
#                            run, by Emscripten; and the program once more on Debian 13, in a headset's runtime (needs
#                            root)
#   scripts/test.sh dev      one preset's tests only
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

for preset in "$@"; do
    [ "$preset" = all ] || cmake --list-presets | grep -q "\"$preset\"" || {
        sed -n '2,/^set/s/^# //p' "$0" >&2
        exit 2
    }
done
if [ "${1:-}" = all ]; then scripts/install.sh all; else scripts/install.sh tests; fi
[ -d tests/assets/gltf_validator/node_modules ] || npm ci --silent --prefix tests/assets/gltf_validator
[ -d tests/browser/node_modules ] || npm ci --silent --prefix tests/browser
[ -d tests/web/node_modules ] || npm ci --silent --prefix tests/web
[ -d web/node_modules/typescript ] || npm ci --silent --prefix web

logs=build/test-logs
mkdir -p $logs
counts=()
skipped=()
status=0
say() { echo "== $* ($((SECONDS / 60)) min)"; }
failed() {
    status=1
    counts+=("$*: failed")
}
# build PRESET [options of cmake ...] [-- options of cmake --build ...]
build() {
    local preset=$1 log=$logs/$1-build.log options=()
    shift
    say "$preset: configure and build"
    while [ $# -gt 0 ] && [ "$1" != -- ]; do options+=("$1") && shift; done
    [ $# -eq 0 ] || shift
    cmake --preset "$preset" -Wno-dev "${options[@]}" >/dev/null || return 1
    if ! cmake --build --preset "$preset" "$@" >"$log" 2>&1; then
        tail -n 60 "$log"
        return 1
    fi
    tail -n 1 "$log"
}
# run_tests PRESET [options of ctest ...]
run_tests() {
    local result=0
    say "$1: tests"
    ctest --preset "$1" -j2 --timeout 1200 "${@:2}" 2>&1 | tee "$logs/$1.log" || result=$?
    count_tests "$1"
    return "$result"
}
count_tests() {
    counts+=("$1: $(grep -E 'tests passed' "$logs/$1.log" || echo 'no result')")
    # What a test case could not do here, "SKIPPED: case: reason", and why.
    mapfile -t -O ${#skipped[@]} skipped < <(sed -n "s/^SKIPPED: /$1: /p" "build/$1/Testing/Temporary/LastTest.log" | sort -u)
}
run_preset() { build "$1" && run_tests "$1"; }
# Whole commands that calculate for long, whose code the libraries' own tests run with sanitizers: "all" has a program
# without them, which takes a fourth of the time.
long_suites='^app/(evaluate|fit|locked_study|power|report_observers|report_r|report_studies|simulate|stats_oracles|study_commands)$'
check_installed() {
    cmake --install build/release --prefix $logs/installed >/dev/null || return 1
    # The trainers start, and find no such part.
    { $logs/installed/bin/deixis learn join none -o $logs/none 2>&1 || true; } | grep "none: cannot be opened" || return 1
    ! grep -aoE "$PWD/(app|assets|build|core|learning|motion|physics|renderer|results|studies)[ -~]*" $logs/installed/bin/*
}
check_browser_code() {
    emcmake cmake -S tests/wasm -B build/wasm -G Ninja >$logs/wasm.log 2>&1 && cmake --build build/wasm >>$logs/wasm.log 2>&1 || {
        grep -E "error|warning" $logs/wasm.log || tail -n 20 $logs/wasm.log
        return 1
    }
    node --no-experimental-fetch build/wasm/wasm_tests.js | tail -n 3 # or this Emscripten fetches its own file
}
# What somebody scripted does in real time waits for most of its time: it runs beside the rest, and goes first. How
# quick the studio's page is must not be judged there.
run_in_real_time() {
    local result=0
    DEIXIS_SLOW_MACHINE=1 ctest --preset release -R '^(desktop|browser|web|learning)/' --timeout 1200 >$logs/release.log 2>&1 || result=1
    scripts/test_headset.sh --scenarios-only >$logs/headset.log 2>&1 || result=1
    return $result
}
run_all() {
    build asan || failed "asan: the build"
    build release -DDEIXIS_WERROR=ON -DDEIXIS_LEARNING=ON -- --target deixis learning_tests || failed "release: the build"
    build offline -DDEIXIS_WERROR=ON -- --target deixis || failed "offline: the build"
    say "desktop, browser and headset begin, beside the rest"
    run_in_real_time &
    local in_real_time=$!
    trap 'kill $(jobs -p) 2>/dev/null || true' EXIT # where all of this is broken off
    renice -n 19 -p $$ >/dev/null
    run_tests asan -E "$long_suites" || failed "asan"
    DEIXIS_TESTED_PROGRAM=$PWD/build/offline/deixis run_tests asan -R "$long_suites" || failed "asan: long suites"
    say "compare"
    scripts/compare_builds.sh build/release/deixis build/asan/deixis || failed "compare"
    say "install"
    check_installed || failed "install: the program names folders of its sources, above; that"
    build/offline/deixis check pointing2023 || failed "offline: check"
    say "lint"
    scripts/lint.sh || failed "lint"
    say "what a browser will run"
    check_browser_code || failed "what a browser will run"
    say "waiting for desktop, browser and headset"
    wait $in_real_time || failed "desktop, browser and headset"
    cat $logs/release.log $logs/headset.log
    count_tests release
    counts+=("$(grep -E '^headset: [0-9]+ passed' $logs/headset.log || echo 'headset: no result')")
}

case ${1:-} in
"" | all)
    scripts/check_style.sh
    if [ $# -gt 0 ]; then run_all; else run_preset asan || failed "asan"; fi
    ;;
*)
    for preset in "$@"; do run_preset "$preset" || failed "$preset"; done
    ;;
esac

echo
printf '%s\n' "${counts[@]}"
[ ${#skipped[@]} -eq 0 ] && echo "Nothing was skipped." || printf '%s\n' "${#skipped[@]} skipped:" "${skipped[@]}"
say "end"
[ "$status" -eq 0 ] && echo "All passed." || echo "Something failed: see above."
exit "$status"

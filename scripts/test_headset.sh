#!/usr/bin/env bash
# Tests the headset with a real OpenXR runtime and no headset, inside a small Debian 13 system of its own: builds
# there, runs the unit tests (Debian 13 is the second platform), then somebody scripted takes part in whole sessions.
#   scripts/test_headset.sh                             all; before a release, since it takes a fourth build of all tests
#   scripts/test_headset.sh --soak 600                  with a soak of ten minutes instead of one
#   scripts/test_headset.sh --scenarios-only study soak without the unit tests, and only those scenarios
# Logs and databases: build/headset-runs. Pictures of every stage: build/headset-pictures.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
        echo "test_headset.sh: needs root for a system of its own, and there is no sudo" >&2
        exit 1
    }
    as_root=(sudo --preserve-env=DEIXIS_HEADSET_ROOT,CCACHE_DIR,HOME)
fi
inside() { "${as_root[@]}" scripts/headset_root.sh run "$@"; }

unit_tests=yes
if [ "${1:-}" = --scenarios-only ]; then
    unit_tests=no
    shift
fi

cmake -P results/page/figures/fetch.cmake # inside there is neither npm nor a network
echo "== headset: configure and build on Debian 13"
# GCC 14 takes a reference into a static map for one into a temporary.
inside cmake -S /deixis -B /deixis/build/trixie -G Ninja -Wno-dev -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1 -g1" -DDEIXIS_WERROR=ON "-DCMAKE_CXX_FLAGS=-Wno-dangling-reference" \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=24 -DDEIXIS_STUDIO=OFF \
    -DCMAKE_CXX_COMPILER_LAUNCHER=ccache >/dev/null
targets=(all)
[ "$unit_tests" = yes ] || targets=(deixis conditions_layer)
log=build/test-logs/headset-build.log
mkdir -p build/test-logs
inside cmake --build /deixis/build/trixie --target "${targets[@]}" >"$log" || {
    tail -n 60 "$log"
    exit 1
}
tail -n 1 "$log"

status=0
if [ "$unit_tests" = yes ]; then
    echo "== headset: unit tests on Debian 13"
    inside ctest --test-dir /deixis/build/trixie --label-exclude program --output-on-failure --no-tests=error -j2 ||
        status=1
fi

echo "== headset: sessions with a real OpenXR runtime"
inside python3 -B /deixis/tests/headset/rig/run.py "$@" || status=1
exit "$status"

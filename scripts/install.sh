#!/usr/bin/env bash
# Installs the Debian packages that are missing, and says which; does nothing where all are there.
#   scripts/install.sh          what building and running needs
#   scripts/install.sh tests    and what the tests need, with a compiler cache and a quick linker
#   scripts/install.sh all      and what `scripts/test.sh all` needs: Blender, Emscripten, clang-tidy, another Debian
#   scripts/install.sh learning what building and running needs, and what trains the learned systems (DEIXIS_LEARNING=ON)
#   scripts/install.sh list     prints what building and running needs, and installs nothing
set -euo pipefail

packages=(
    build-essential cmake ninja-build pkg-config
    libglm-dev libfmt-dev libfast-float-dev libexpected-dev libssl-dev zlib1g-dev libpng-dev
    libtinygltf-dev libtomlplusplus-dev nlohmann-json3-dev libcli11-dev libkainjow-mustache-dev
    libsqlitecpp-dev libsqlite3-dev libpqxx-dev libpq-dev libboost-dev libboost-math-dev libeigen3-dev
    libepoxy-dev libegl-dev libgl-dev libgl1-mesa-dri libegl-mesa0 libglx-mesa0 libglfw3-dev libimgui-dev libx11-dev
    flite1-dev libpocketsphinx-dev libsphinxbase-dev pocketsphinx-en-us libcpp-httplib-dev libbrotli-dev libespeak-ng-dev espeak-ng-data
    libopenxr-dev libmujoco-dev libopenal-dev fonts-open-sans fonts-nanum doctest-dev libxml2-dev
)
case ${1:-} in
tests | all)
    packages+=(clang clang-format-14 ccache mold xvfb xdotool python3 python3-jsonschema sqlite3 libxml2-utils
        r-base-core r-cran-lme4 r-cran-ordinal postgresql chromium poppler-utils groff-base)
    ;;&
learning | all)
    # The plain OpenBLAS is slower in LibTorch: its threads wait for each other.
    packages+=(libtorch-dev libgloo-dev libopenblas0-openmp)
    ;;&
all)
    packages+=(blender python3-numpy emscripten clang-tidy-14 debootstrap libbenchmark-dev)
    ;;
esac
if [ "${1:-}" = list ]; then
    printf '%s\n' "${packages[@]}"
    exit 0
fi
# npm fetches what draws the report's figures (results/page/figures). Not listed: the headset's Debian 13 builds from the same
# folder, and finds it there.
command -v npm >/dev/null || packages+=(nodejs npm)

missing=()
for package in "${packages[@]}"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

echo "Installing: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
        echo "install.sh: these packages are missing and there is no sudo; as root run: apt-get install ${missing[*]}" >&2
        exit 1
    }
    as_root=(sudo)
fi
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null

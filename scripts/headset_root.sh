#!/usr/bin/env bash
# A small Debian 13 system under build/trixie-root, with an OpenXR runtime (Monado) that needs neither headset nor
# graphics card, and with what building Deixis needs. Made once (about two minutes), then reused.
#   scripts/headset_root.sh                    makes it where it is not there or not complete
#   scripts/headset_root.sh run COMMAND ...    and runs the command inside
# Inside, the repository is /deixis, and ../shared, where there is one, /shared (read only). The command has file
# systems, processes and a network of its own (only the loopback): nothing of it outlives this script.
# DEIXIS_HEADSET_ROOT names another folder for the system.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
root=${DEIXIS_HEADSET_ROOT:-$here/build/trixie-root}
stamp=$root/complete
suite=trixie

[ "$(id -u)" -eq 0 ] || {
    echo "headset_root.sh: making and entering another system needs root; run it as root or with sudo" >&2
    exit 1
}

packages() {
    printf '%s\n' libopenxr1-monado monado-service openxr-layer-corevalidation libopenxr-loader1 \
        libgl1-mesa-dri mesa-vulkan-drivers xvfb xdotool x11-utils imagemagick iproute2 procps python3 sqlite3 \
        libxml2-utils ccache
    "$here/scripts/install.sh" list
}

# The Debian mirror that this machine's apt uses, else Debian's own.
mirror() {
    { apt-get indextargets --format '$(LABEL) $(REPO_URI)' 'Created-By: Packages' 2>/dev/null || true; } |
        awk '$1 == "Debian" && !found { print $2; found = 1 } END { if (!found) print "http://deb.debian.org/debian" }'
}

# Becomes its arguments, with / at the root, in namespaces that end with it. $1: "network" keeps the machine's.
inside() {
    local network=--net
    [ "$1" != network ] || network=
    shift
    ROOT=$root HERE=$here CACHE=${CCACHE_DIR:-${HOME:-/root}/.cache/ccache} \
        exec unshare --mount --pid --fork --kill-child ${network:+"$network"} bash -c '
        set -euo pipefail
        mount -t proc proc "$ROOT/proc"
        mount --rbind /dev "$ROOT/dev"
        mount -t tmpfs tmpfs "$ROOT/dev/shm"
        mount -t tmpfs tmpfs "$ROOT/tmp"
        mkdir -p "$ROOT/deixis" "$ROOT/shared" "$ROOT/ccache"
        mount --bind "$HERE" "$ROOT/deixis"
        [ ! -d "$HERE/../shared" ] || mount --bind -o ro "$HERE/../shared" "$ROOT/shared"
        [ ! -d "$CACHE" ] || mount --bind "$CACHE" "$ROOT/ccache"
        [ -z "${HEADSET_LOOPBACK:-}" ] || chroot "$ROOT" ip link set lo up
        exec chroot "$ROOT" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 \
            CCACHE_DIR=/ccache DEBIAN_FRONTEND=noninteractive "$@"' bash "$@"
}

make_root() {
    command -v debootstrap >/dev/null || {
        echo "headset_root.sh: debootstrap is missing; scripts/install.sh tests installs it" >&2
        exit 1
    }
    local from log=$root.log
    from=$(mirror)
    echo "Making a Debian 13 system in $root from $from; this takes some minutes (log: $log)"
    rm -rf --one-file-system "$root"
    mkdir -p "$root"
    # In a mount namespace of its own, because debootstrap leaves a /proc mounted when it is interrupted.
    unshare --mount debootstrap --variant=minbase "$suite" "$root" "$from" >"$log" 2>&1 || {
        tail -n 5 "$log" >&2
        echo "headset_root.sh: debootstrap failed" >&2
        exit 1
    }
    mkdir -p "$root/etc/dpkg/dpkg.cfg.d"
    echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/quick" # it can be made again
    # shellcheck disable=SC2046 # one word a package
    (inside network sh -c 'apt-get update -qq && apt-get install -y -qq --no-install-recommends "$@" && apt-get clean' \
        sh $(packages)) >>"$log" 2>&1 || {
        tail -n 5 "$log" >&2
        echo "headset_root.sh: the packages could not be installed" >&2
        exit 1
    }
    packages >"$stamp"
}

# One at a time: two runs must not make it together.
mkdir -p "$(dirname "$root")"
exec 9>"$root.lock"
flock 9
[ -f "$stamp" ] && packages | cmp -s - "$stamp" || make_root
exec 9>&-

if [ "${1:-}" = run ]; then
    shift
    HEADSET_LOOPBACK=1 inside own "$@"
fi

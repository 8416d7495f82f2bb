#!/bin/sh
# tools/bare_root.sh [COMMAND...]: what a newcomer meets. Makes a minimal Debian 12 root (debootstrap, as root), clones the
# committed state of this checkout into it and runs COMMAND there (default: ./run --help, then ./test), without HOME, locale
# and terminal. The machine's own package sources and certificates are carried in when it runs. KEEP=yes leaves the root.
# Ends as COMMAND does; with 77, and the reason in the last line, where no such root can be made.
set -eu
lack() { echo "tools/bare_root.sh: $*" >&2 && exit 77; }
[ "$(id -u)" -eq 0 ] || lack 'needs root, for chroot'
# In a mount namespace of its own, so that whatever is mounted below goes away with it.
if [ "${SUFFUSE_OWN_MOUNTS:-}" != yes ]; then
    unshare --mount --pid --fork true 2>/dev/null || lack 'the system gives no namespaces of mounts and processes'
    SUFFUSE_OWN_MOUNTS=yes exec unshare --mount -- "$0" "$@"
fi

source=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd)
command=${*:-./run --help && ./test}
# shellcheck source=tools/at_end.sh
. "$source/tools/at_end.sh"
bare=

# shellcheck disable=SC2317 # the trap calls it
clean() {
    [ -n "$bare" ] || return 0
    rm -f "$bare.log"
    awk -v below="$bare/" 'index($5, below) == 1 { print $5 }' /proc/self/mountinfo | sort -r | xargs -r umount -l || :
    [ "${KEEP:-no}" = no ] || { echo "kept: $bare" && return; }
    rm -rf --one-file-system "$bare" || { sleep 2 && rm -rf --one-file-system "$bare"; } # what was killed is gone by then
}

# contained COMMAND...: attended, with all the processes that it starts, which end with it.
contained() { attended unshare --pid --fork --kill-child "$@"; }

trap 'end_attended; clean' EXIT
bare=$(mktemp -d "${TMPDIR:-/tmp}/suffuse-bare.XXXXXX")
chmod 755 "$bare" # as / is

apt_get_targets() { apt-get indextargets --format "$1" 'Created-By: Packages'; }
# shellcheck disable=SC2016
mirror=$(apt_get_targets '$(CODENAME) $(REPO_URI)' | sed -n 's/^bookworm //p' | head -n 1)
[ -n "$mirror" ] || lack 'apt has no source for bookworm'
fetch_debootstrap() { apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends debootstrap; }
command -v debootstrap >/dev/null || fetch_debootstrap >"$bare.log" 2>&1 ||
    { tail "$bare.log" >&2 && lack 'debootstrap is missing and cannot be fetched'; }

begin=$(date +%s)
contained debootstrap --variant=minbase bookworm "$bare" "$mirror" >"$bare.log" 2>&1 ||
    { tail "$bare.log" >&2 && lack 'debootstrap made no root'; }
echo "bare root: $(($(date +%s) - begin)) s, $(chroot "$bare" dpkg-query -W | wc -l) packages, $(du -shx "$bare" | cut -f 1)"

# What the machine's own network needs; none of it is part of the project.
# shellcheck disable=SC2016
apt_get_targets 'deb $(REPO_URI) $(CODENAME) $(COMPONENT)' | grep -E ' bookworm[a-z-]* main$' | sort -u >"$bare/etc/apt/sources.list"
apt-config dump | grep -E '^Acquire::(http|https|Check)' >"$bare/etc/apt/apt.conf.d/99machine" || true
cp -L /etc/resolv.conf /etc/hosts "$bare/etc/"
if [ -d /usr/local/share/ca-certificates ]; then cp -R /usr/local/share/ca-certificates "$bare/usr/local/share/"; fi
mkdir -p "$bare/etc/ssl/certs"
cp -L /etc/ssl/certs/ca-certificates.crt "$bare/etc/ssl/machine.crt"

mount --rbind /dev "$bare/dev"
mkdir -p "$bare/dev/shm"

git clone -q "$source" "$bare/srv/suffuse"
# shellcheck disable=SC2016
set -- PATH=/usr/sbin:/usr/bin:/sbin:/bin NODE_EXTRA_CA_CERTS=/etc/ssl/machine.crt npm_config_cafile=/etc/ssl/machine.crt
if command -v npm >/dev/null; then set -- "$@" "npm_config_registry=$(npm config get registry)"; fi
begin=$(date +%s)
status=0
contained --mount-proc="$bare/proc" env -i "$@" chroot "$bare" /bin/sh -c "cd /srv/suffuse && $command" || status=$?
echo "bare root: '$command' ended with $status after $(($(date +%s) - begin)) s"
exit "$status"

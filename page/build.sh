#!/bin/sh
# page/build.sh OUT_DIR: fetch the page's npm packages as the lock file says, and bundle the page's script:
# OUT_DIR/page.js, its hash page.js.sha256 and the notices of what is in it, notices.txt; and figures.mjs, which draws
# figures without a browser. Nothing is written elsewhere.
# With --dev, also the packages of the browser tests. Exit code 1, with a reason, where this cannot be done; 77 where what is
# needed for it cannot be had here: Node, npm, its registry.
set -eu
dev=no
if [ "${1:-}" = --dev ]; then
    dev=yes
    shift
fi
[ $# -eq 1 ] || { sed -n '2,6s/^# //p' "$0" >&2; exit 2; }
here=$(dirname "$(readlink -f "$0")")
mkdir -p "$1/npm"
out=$(readlink -f "$1")
complain() { printf 'report page: %s\n' "$*" >&2; }
fail() { complain "$@" && exit 1; }
lack() { complain "$@" && exit 77; }

for tool in node npm; do
    command -v $tool >/dev/null 2>&1 || lack "$tool is missing; install Node (18 or newer) and npm"
done
version=$(node -p 'parseInt(process.versions.node)')
[ "$version" -ge 18 ] || lack "Node $version is too old; 18 or newer is needed"

# Fetch only when the lock file changed, or packages of the tests are missing: the second call is quick.
if [ "$dev" = yes ] && [ ! -d "$out/npm/node_modules/playwright-core" ]; then rm -f "$out/npm/installed"; fi
if ! cmp -s "$here/package-lock.json" "$out/npm/installed"; then
    cp "$here/package.json" "$here/package-lock.json" "$out/npm/"
    omit=--omit=dev
    [ "$dev" = no ] || omit=--include=dev
    (cd "$out/npm" && npm ci $omit --ignore-scripts --no-audit --no-fund --loglevel=error \
        --fetch-retries=2 --fetch-retry-mintimeout=1000 --fetch-retry-maxtimeout=5000) >&2 ||
        lack "npm could not fetch the packages; can it reach its registry?"
    cp "$here/package-lock.json" "$out/npm/installed"
fi
node "$here/bundle.mjs" "$out" || fail "the bundle could not be made"

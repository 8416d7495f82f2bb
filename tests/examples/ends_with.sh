#!/bin/sh
# ends_with.sh CODE PROGRAM CASE: whether a run of a case as it comes ends with this exit code.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$2" run "$3" -o "$folder/run" --no-cache >"$folder/told" 2>&1
code=$?
[ "$code" -eq "$1" ] || { tail -n 20 "$folder/told"; echo "$3 ended with $code, and $1 was expected"; exit 1; }

#!/bin/sh
# tests/altered_sentences.sh PROGRAM ALTERED [OPTION...]: whether control flow reads a sentence. ALTERED is the program with every
# sentence altered where it is made (tests/altered/altered_sentences.cpp). Both run, resume, refuse, assess and compare the same;
# exit codes, keys, enumerations, numbers and readings must be equal to the bit, as tools/same_results.sh compares them without
# texts. Its options follow, as --only JOB and --keep DIR. A minute or two.
set -eu
program=$(readlink -f "$1")
altered=$(readlink -f "$2")
shift 2
root=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd)
jobs="replay failing damaged refusals own-soil assess sheets sweep words fontainebleau-2016 second-erosion-fines-limit silty-sand-fc20-removal"

# shellcheck source=tools/at_end.sh
. "$root/tools/at_end.sh"
folder=
trap 'end_attended; rm -rf "$folder"' EXIT
folder=$(mktemp -d)

# That sentences are altered, indeed: those of an error, of a problem of a case, and of what is formatted.
for words in "resume $folder/nowhere" "check $root/examples/replay/case.toml --set contact.damping=-1" "compare $folder $folder"; do
    # shellcheck disable=SC2086
    "$program" $words >"$folder/told" 2>&1 || :
    # shellcheck disable=SC2086
    "$altered" $words >"$folder/altered" 2>&1 || :
    ! cmp -s "$folder/told" "$folder/altered" || { cat "$folder/told" && echo "altered_sentences: not altered: $words" && exit 1; }
done

mkdir -p "$folder/program/apps" "$folder/altered-program/apps"
ln -s "$program" "$folder/program/apps/suffuse"
ln -s "$altered" "$folder/altered-program/apps/suffuse"
case " $* " in
*" --only "*) ;;
*) for job in $jobs; do set -- "$@" --only "$job"; done ;;
esac
attended /usr/bin/python3 -B "$root/tools/same_results" "$folder/program" "$folder/altered-program" "$@"

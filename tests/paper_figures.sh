#!/bin/sh
# tests/paper_figures.sh: tools/paper_figures.sh with a stand-in for the program: the price comes before any run, each run draws its
# figures of the paper, words go on to both, flaws do not end it, a failure does.
set -eu
here=$(dirname "$(readlink -f "$0")")
script=$here/../tools/paper_figures.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "$*" >&2 && exit 1; }

cat >"$folder/program" <<'END'
#!/bin/sh
echo "$@" >>"$CALLS"
case $1 in
run) exit "${RUN_ENDS:-4}" ;;
figures)
    for word; do last=$word; done
    for number in $(echo "$4" | tr , ' '); do printf '<svg/>' >"$last/fig$(printf %02d "$number").svg"; done
    ;;
esac
END
chmod +x "$folder/program"

CALLS=$folder/calls "$script" "$folder/program" /root-of-it --preset quick -o "$folder/out" >"$folder/said" 2>"$folder/talk"
[ "$(cat "$folder/said")" = "$folder/out/index.html" ] || fail "it said $(cat "$folder/said")"
cut -d ' ' -f 1 "$folder/calls" | tr '\n' ' ' >"$folder/order"
[ "$(cat "$folder/order")" = "plan plan run run figures figures " ] || fail "called in the order $(cat "$folder/order")"
grep -q "^run /root-of-it/examples/silty-sand-2016/case.toml -o $folder/out/mixtures --preset quick$" "$folder/calls" ||
    fail "the mixtures were not run as requested"
for number in 01 02 03 04 05 06 07 08 09 10 11 12 13 14; do
    [ -e "$folder/out/fig$number.svg" ] || fail "no figure $number"
    grep -q "src=\"fig$number.svg\"" "$folder/out/index.html" || fail "figure $number is not on the page"
done
[ "$(grep -c mixtures/report.html "$folder/out/index.html")" -eq 6 ] || fail "six figures are of the mixtures"

status=0
CALLS=$folder/calls RUN_ENDS=130 "$script" "$folder/program" /root-of-it -o "$folder/stopped" >/dev/null 2>&1 || status=$?
[ "$status" -eq 130 ] || fail "a run that was stopped ended with $status"
[ ! -e "$folder/stopped/index.html" ] || fail "a run that was stopped left a page"
status=0
"$script" "$folder/program" /root-of-it --colour 2>"$folder/talk" || status=$?
[ "$status" -eq 2 ] || fail "an unknown word ended with $status"

#!/bin/sh
# bench/roofline.sh [SYMBOL [OPTION...]]: what the processor's ports allow the contact kernel, from llvm-mca: cycles a contact,
# the busiest port, the bound, for the AVX2 and the AVX-512 clone, in both modes. SYMBOL is an expression for the function's name;
# options go to roofline.py: --object FILE, --clock GHZ, --cpu MODEL, --show, ...
set -eu
root=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd)
offline=no
# shellcheck source=tools/bootstrap.sh
. "$root/tools/bootstrap.sh"

lock
# shellcheck disable=SC2086
need_packages $build_packages llvm-14 binutils python3 || fail "some packages are missing"
configure OFF
build_target suffuse_contact
unlock

# roofline SYMBOL OPTION...
roofline() {
    symbol=$1
    shift
    /usr/bin/python3 "$root/bench/roofline.py" --object "$build/libsuffuse_contact.a" --symbol "$symbol" "$@"
}

if [ $# -gt 0 ]; then
    roofline "$@"
else
    echo "mode reference, double precision"
    roofline 'press_plain.*Work<double>'
    echo "mode fast, single precision but for positions and overlaps"
    roofline 'press_plain.*Work<float>'
fi

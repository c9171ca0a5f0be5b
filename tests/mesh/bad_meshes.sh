#!/bin/sh
# The program of chapter 08 refuses bad meshes in one line with status 2 and writes nothing, warns of odd ones, and
# renders good ones.
#   bad_meshes.sh PROGRAM
set -eu
program=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
picture="$work/picture.png"

render() {
    status=0
    "$program" --width 24 --height 18 --mesh "$1" --out "$picture" >"$work/out" 2>"$work/err" || status=$?
}
refuses() {
    render "$1"
    if [ "$status" != 2 ] || [ "$(wc -l <"$work/err")" != 1 ] || ! grep -qF -- "$1" "$work/err"; then
        echo "$1: status $status, stderr: $(head -n 3 "$work/err")"
        exit 1
    fi
    [ ! -e "$picture" ] || { echo "$1: a picture was written"; exit 1; }
}
renders() { # FILE LINES-OF-WARNING
    render "$1"
    if [ "$status" != 0 ] || [ "$(wc -l <"$work/err")" != "$2" ] || [ ! -s "$picture" ]; then
        echo "$1: status $status, stderr: $(head -n 3 "$work/err")"
        exit 1
    fi
    rm -f "$picture"
}

knot=tests/golden/08_mesh.ply
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n' >"$work/points.obj"
printf 'nothing of the kind\n' >"$work/nonsense.obj"
: >"$work/empty.ply"
head -c 20000 "$knot" >"$work/cut.ply"
head -c 300 "$knot" >"$work/header.ply"
{ cat "$work/points.obj"; printf 'f 1 2 5\n'; } >"$work/range.obj"
{ cat "$work/points.obj"; printf 'v nan 0 0\nf 1 2 3\n'; } >"$work/nan.obj"
{ cat "$work/points.obj"; printf 'f 1 2 3\nf 3 2 4\nf 1 2 2\nf 2 3 1\n'; } >"$work/odd.obj"
mkdir "$work/folder.obj"

refuses "$work/absent.obj"
refuses "$work/folder.obj"
refuses "$work/points.obj"
refuses "$work/nonsense.obj"
refuses "$work/empty.ply"
refuses "$work/cut.ply"
refuses "$work/header.ply"
refuses "$work/range.obj"
refuses "$work/nan.obj"
refuses /dev/null

renders "$work/odd.obj" 2
for scale in 0.000001 1 1000000; do
    awk -v s="$scale" '$1 == "v" { print "v", $2 * s, $3 * s, $4 * s; next } { print }' "$work/odd.obj" >"$work/scaled.obj"
    renders "$work/scaled.obj" 2
done
renders "$knot" 0
echo "bad meshes refused, odd ones warned of, good ones rendered"

#!/bin/sh
# The comparison's program: refuses bad meshes and names with one line and status 2, and leaves a whole report.
#   program.sh PROGRAM
set -eu
program=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

printf 'nonsense\n' >"$work/nonsense.obj"
: >"$work/empty.obj"
printf 'v 1 2 3\n' >"$work/point.obj"
printf 'v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n' >"$work/one_place.obj"
printf 'v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n' >"$work/nan.obj"
printf 'v 0 0 0\nv 1 0 1e99\nv 0 1 0\nf 1 2 3\n' >"$work/huge.obj"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' >"$work/index.obj"

report=$work/report
refuses() {
    said=$1
    shift
    status=0
    "$program" --quick --report "$report" "$@" >"$work/out" 2>"$work/err" || status=$?
    # A warning about a triangle without area may come before.
    [ "$status" = 2 ] && [ "$(grep -vc warning "$work/err")" = 1 ] && grep -q -- "$said" "$work/err" ||
        { echo "$*: status $status, said: $(cat "$work/err")"; exit 1; }
    [ ! -e "$work/report.json" ] || { echo "$*: left a report"; exit 1; }
}
for name in nonsense empty point one_place nan huge index missing; do
    refuses "$name.obj" --mesh "$work/$name.obj"
done
refuses '--scene nowhere' --scene nowhere
refuses '--structure pile' --structure pile
report=/proc/folder/report
refuses '/proc/folder' --scene tetra
report=$work/report

# A mesh that is not the course's own, and two structures only.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n' >"$work/tetrahedron.obj"
"$program" --quick --mesh "$work/tetrahedron.obj" --structure grid --structure bvh --report "$work/report" >"$work/out"
for file in report.json report.md; do
    [ -s "$work/$file" ] || { echo "$file is missing"; exit 1; }
done
grep -q 'tetrahedron, 4 triangles' "$work/out" || { cat "$work/out"; exit 1; }
[ "$(grep -c '"mismatches": 0' "$work/report.json")" -ge 8 ] || { echo "rows are missing, or wrong"; exit 1; }
grep -q '"structure": "bvh"' "$work/report.json" && ! grep -q '"structure": "octree"' "$work/report.json" ||
    { echo "--structure did not narrow the list"; exit 1; }

# A file's name is nobody's command, and need not be UTF-8.
odd=$(printf 'odd`touch ran`\377.obj')
cp "$work/tetrahedron.obj" "$work/$odd"
(cd "$work" && rm out && "$program" --quick --mesh "$odd" --structure bvh --report odd >said)
[ -s "$work/odd.json" ] && [ ! -e "$work/ran" ] || { echo "a mesh called $odd leaves no report, or is run"; exit 1; }

#!/bin/sh
# What chapter 17 cannot do it says in one line, leaves with status 2, and writes nothing.
#   refusals.sh PROGRAM FOLDER
program=$1 out=$2/refused.png
failed=0
refuses() { # PATTERN ARGUMENT...
    pattern=$1
    shift
    rm -f "$out"
    said=$(env -u DISPLAY -u WAYLAND_DISPLAY "$program" --width 32 --height 18 --out "$out" "$@" 2>&1)
    status=$?
    if [ $status -ne 2 ] || [ -e "$out" ] || [ "$(printf '%s\n' "$said" | wc -l)" -ne 1 ] ||
        ! printf '%s' "$said" | grep -q "$pattern"; then
        echo "$*: status $status: $said"
        failed=1
    fi
}
refuses '^17_gpu: window: ' --context window
refuses '^17_gpu: --scene: ' --scene teapot
refuses '^17_gpu: --stack: ' --stack 65
refuses '^17_gpu: no_such.ply: ' --scene bunny --mesh no_such.ply

# 70,000 triangles around one edge: no box keeps a ray from any of them, and on llvmpipe the loops of a pixel end before.
mesh=$2/fan.ply
awk 'BEGIN {
    n = 70000
    print "ply\nformat ascii 1.0\nelement vertex " 2 + n "\nproperty float x\nproperty float y\nproperty float z"
    print "element face " n "\nproperty list uchar int vertex_indices\nend_header\n0 -1 0\n0 1 0"
    for (i = 0; i < n; ++i) print cos(i), sin(3 * i) / 2, sin(i)
    for (i = 0; i < n; ++i) print 3, 0, 1, 2 + i
}' >"$mesh"
if "$program" --context osmesa --width 16 --height 9 --samples 1 --out "$out" 2>/dev/null | grep -q llvmpipe; then
    refuses '^17_gpu: --scene: the loops of [0-9]* pixels were cut short' \
        --context osmesa --scene first-hits --mesh "$mesh" --walk skip --samples 1
else
    echo "left out, because OSMesa with llvmpipe is not here: loops that are cut short"
fi
refuses '^17_gpu: --width: ' --width 20000
exit $failed

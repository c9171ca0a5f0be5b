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
exit $failed

#!/bin/sh
# Ctrl-C keeps what is done: status 130, one line that says so, a picture that can be read, nothing half-written.
#   interrupt.sh FOLDER-OF-PROGRAMS
set -eu
program=$1/01_ray_casting
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# A shell without job control starts background programs with SIGINT ignored; env gives it back.
env --default-signal=INT "$program" --width 5000 --height 5000 --threads 1 --out "$work/picture.png" >/dev/null 2>"$work/err" &
running=$!
while [ "$(awk '/^Threads:/ { print $2 }' "/proc/$running/status" 2>/dev/null || echo 1)" -lt 1 ]; do :; done
sleep 1
kill -INT "$running"
status=0
wait "$running" || status=$?
[ "$status" = 130 ] || { echo "status $status, said: $(cat "$work/err")"; exit 1; }
grep -q 'kept the finished' "$work/err" || { echo "said: $(cat "$work/err")"; exit 1; }
[ "$(ls -A "$work" | sort | tr '\n' ' ')" = "err picture.png " ] || { echo "left: $(ls -A "$work")"; exit 1; }
head -c 8 "$work/picture.png" | od -An -c | grep -q 'P   N   G' || { echo "not a PNG"; exit 1; }
cat "$work/err"

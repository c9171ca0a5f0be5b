#!/bin/sh
# Every chapter's program refuses bad input: one line on stderr, status 2, nothing written.
#   bad_input.sh FOLDER-OF-PROGRAMS
set -eu
programs=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
echo text >"$work/file"
mkdir "$work/folder.png"
tried=0

refuses() {
    status=0
    "$@" >"$work/out" 2>"$work/err" || status=$?
    tried=$((tried + 1))
    if [ "$status" != 2 ] || [ "$(wc -l <"$work/err")" != 1 ]; then
        echo "$*: status $status, $(wc -l <"$work/err") lines: $(head -n 3 "$work/err")"
        exit 1
    fi
}

# Every program reads the options that all have through one parser (common/command_line.cpp), so each is tried with one
# bad value of every kind, and the first with every spelling.
every=
for program in "$programs"/[0-9][0-9]_*; do
    [ -x "$program" ] || continue
    picture="$work/picture.png"
    "$program" --help >"$work/out"
    for option in --out --width --height --threads --seed --window; do
        grep -q -- "$option" "$work/out" || { echo "$program --help does not name $option"; exit 1; }
    done
    refuses "$program" --nonsense
    refuses "$program" stray
    refuses "$program" --width 0 --out "$picture"
    refuses "$program" --width 1000000000 --out "$picture"
    refuses "$program" --height nan --out "$picture"
    refuses "$program" --threads many --out "$picture"
    refuses "$program" --width 8 --height 8 --out "$work/picture.txt"
    refuses "$program" --width 8 --height 8 --out /proc/picture.png
    if [ -z "$every" ]; then
        every=tried
        refuses "$program" --width
        refuses "$program" --width -5 --out "$picture"
        refuses "$program" --width 99999999999999999999 --out "$picture"
        refuses "$program" --height 0 --out "$picture"
        refuses "$program" --height 3.5 --out "$picture"
        refuses "$program" --threads -1 --out "$picture"
        refuses "$program" --seed -1 --out "$picture"
        refuses "$program" --width 8 --height 8 --out "$work/picture"
        refuses "$program" --width 8 --height 8 --out ""
        refuses "$program" --width 8 --height 8 --out "$work/folder.png"
        refuses "$program" --width 8 --height 8 --out "$work/file/picture.png"
    fi
    left=$(find "$work" -mindepth 1 ! -name out ! -name err ! -name file ! -name folder.png)
    [ -z "$left" ] || { echo "$program left $left"; exit 1; }
done
# And what is good is taken: a name alone, in the folder where one stands.
first=$(cd "$programs" && pwd)/01_ray_casting
(cd "$work" && "$first" --width 8 --height 8 --out alone.png >/dev/null && [ -s alone.png ]) ||
    { echo "$first refuses --out alone.png"; exit 1; }
[ "$tried" -gt 0 ] || { echo "no program to try in $programs"; exit 1; }
echo "$tried bad command lines refused"

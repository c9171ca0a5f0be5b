#!/bin/sh
# What a learner and a teacher meet: list, NAME, hint, solution, reset, grade, and what happens to code that misbehaves.
#   exercise_launcher.sh BUILD-FOLDER
set -u
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export COURSE_BUILD="$scratch/build" COURSE_WORK="$scratch/work" COURSE_SECONDS=1
mkdir -p "$COURSE_BUILD"
wrong=0
complain() { echo "$*"; wrong=$((wrong + 1)); }
exercise() { sh exercises/exercise.sh "$@"; }
# expect STATUS WORDS COMMAND...: the command ends so, and says that.
expect() {
    status=$1 words=$2
    shift 2
    said=$(exercise "$@" 2>&1 </dev/null)
    got=$?
    [ "$got" = "$status" ] || complain "exercise $*: status $got, not $status: $said"
    case $said in *"$words"*) ;; *) complain "exercise $*: does not say '$words': $said" ;; esac
}
refuses() {
    lines=$(exercise "$@" 2>&1 >/dev/null </dev/null)
    got=$?
    [ "$got" = 2 ] && [ "$(printf '%s\n' "$lines" | wc -l)" = 1 ] && [ -n "$lines" ] ||
        complain "exercise $*: status $got, said: $lines"
}
# The real build, but results of its own; Ninja's notes of what is up to date come as copies, or all would be made anew.
for entry in "$1"/*; do ln -s "$entry" "$COURSE_BUILD/"; done
cp "$1/.ninja_log" "$1/.ninja_deps" "$COURSE_BUILD/"
rm "$COURSE_BUILD/exercises"
mkdir "$COURSE_BUILD/exercises"
ln -s "$1"/exercises/* "$COURSE_BUILD/exercises/"

file=$COURSE_WORK/01_sphere_roots/sphere_roots.hpp
solution=exercises/01_sphere_roots/solution/sphere_roots.hpp
expect 0 'not done  01_sphere_roots' list
[ ! -e "$file" ] || complain "list lays out files"
refuses nonsense
refuses 0 # the beginning of many
refuses --nonsense
refuses 1 2
refuses list x
refuses hint
refuses hint nonsense
refuses hint 1 x
refuses solution 1 # nobody there to answer
refuses reset
refuses watch nonsense
refuses grade
refuses grade "$scratch/nothing"
refuses grade "$COURSE_WORK" --only nonsense
refuses grade "$scratch" --only 1 --out /proc/grades.csv
expect 0 'Hint 1 of 3' hint 1
expect 0 'Hint 2 of 3' hint sphere_roots
expect 0 'That is the last one' hint 01
expect 0 'sphere_hit' solution 1 --yes

mkdir -p "$COURSE_WORK/01_sphere_roots"
cp exercises/01_sphere_roots/starter/sphere_roots.hpp "$file"
echo '// mine' >>"$file"
cp "$file" "$scratch/mine"
expect 3 'Not done yet: 0 of' 01_sphere
cmp -s "$file" "$scratch/mine" || complain "the learner's file was overwritten"
expect 0 'sphere_roots.hpp.1' reset 1
cmp -s "$file.1" "$scratch/mine" || complain "reset does not keep the learner's file"
cmp -s "$file" exercises/01_sphere_roots/starter/sphere_roots.hpp || complain "reset does not lay out the starter"
cp "$solution" "$file"
expect 0 'Passed: all' 1
expect 0 'passed    01_sphere_roots' list
cp exercises/01_sphere_roots/mistakes/forgotten_root.hpp "$file"
expect 1 'First to mend: from inside' 1
expect 0 'wrong     01_sphere_roots' list

# A class in which everything goes wrong that can.
hand_in() { mkdir -p "$scratch/class/$1/01_sphere_roots" && cat >"$scratch/class/$1/01_sphere_roots/sphere_roots.hpp"; }
with() { # the solution, with these words at the beginning of its function
    sed -e "s/^#pragma once/&\n#include <cstdio>\n#include <cstdlib>/" -e "s|^    const double radius|    $1\n&|" "$solution"
}
mkdir -p "$scratch/class/bob, \"the builder\""
with 'return t +;' | hand_in carl
with '*reinterpret_cast<volatile int *>(16) = 1;' | hand_in dora
with 'for (volatile int i = 0;; i = 1 - i) {}' | hand_in emil
with 'for (;;) std::puts("without end, without end");' | hand_in faye
with 'std::exit(0);' | hand_in gus
hand_in zoe <"$solution"
expect 0 '7 students' grade "$scratch/class" --only 1 --out "$scratch/grades.csv"
wanted='not_handed_in does_not_compile crashed too_slow prints_too_much crashed passed'
got=$(sed 1d "$scratch/grades.csv" | sed 's/.*,01_sphere_roots,\([a-z ]*\),.*/\1/' | tr ' \n' '_ ')
[ "$got" = "$wanted " ] || { complain "the class got $got"; cat "$scratch/grades.csv"; }
[ "$(wc -l <"$scratch/grades.csv")" = 8 ] || complain "the table has $(wc -l <"$scratch/grades.csv") lines"

[ "$wrong" -eq 0 ] && echo "the launcher of the exercises does what it says"

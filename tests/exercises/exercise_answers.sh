#!/bin/sh
# Every starter is not done, every solution passes, every mistake is caught, every README is whole.
#   exercise_answers.sh PROGRAM...   one program for each exercise
set -eu
wrong=0 caught=0 mistakes=0 exercises=0
complain() { echo "$*"; wrong=$((wrong + 1)); }

for program in "$@"; do
    exercises=$((exercises + 1))
    lines=$("$program") || { wrong=$((wrong + 1)); printf '%s\n' "$lines"; }
    set -- $(printf '%s\n' "$lines" | sed -n 's/.*: \([0-9]*\) of \([0-9]*\) mistakes caught$/\1 \2/p')
    [ $# -eq 2 ] || { complain "$program counts no mistakes"; continue; }
    caught=$((caught + $1)) mistakes=$((mistakes + $2))
done

for folder in exercises/[0-9]*/; do
    folder=${folder%/} readme=${folder%/}/README.md
    for needed in README.md test.cpp starter solution mistakes; do
        [ -e "$folder/$needed" ] || complain "$folder has no $needed"
    done
    [ "$(ls "$folder/starter")" = "$(ls "$folder/solution")" ] || complain "$folder: starter and solution differ in name"
    # The listing of the signature, line by line, stands in the starter and in the solution.
    for role in starter solution; do
        file=$(ls "$folder/$role"/*)
        awk '/^```(cpp|glsl)$/ { if (last ~ /<!-- from starter\//) { inside = 1; found = 1; next } }
             /^```$/ { inside = 0 } inside { print } { last = $0 } END { exit !found }' "$readme" >"${TMPDIR:-/tmp}/signature.$$" ||
            complain "$readme shows no signature from the starter"
        awk 'NR == FNR { wanted[++n] = $0; next } { if ($0 == wanted[at + 1]) at++; else at = ($0 == wanted[1]); if (at == n) found = 1 }
             END { exit !(n && found) }' "${TMPDIR:-/tmp}/signature.$$" "$file" || complain "$readme: its signature is not that of $file"
        rm -f "${TMPDIR:-/tmp}/signature.$$"
    done
    for hint in 1 2 3; do
        words=$(sh exercises/exercise.sh --hint-text "$readme" "$hint" | wc -w)
        [ "$words" -ge 8 ] || complain "$readme: hint $hint has $words words"
    done
done
echo "$exercises exercises, $caught of $mistakes mistakes caught"
[ "$exercises" -gt 0 ] && [ "$wrong" -eq 0 ] && [ "$caught" -eq "$mistakes" ]

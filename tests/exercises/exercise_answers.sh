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
    # Every line of the signatures that the README shows stands in the starter and in the solution.
    signatures=$(awk '/^```(cpp|glsl)$/ && last ~ /<!-- from starter\// { inside = 1; next } /^```$/ { inside = 0 }
                      inside { print } { last = $0 }' "$readme")
    [ -n "$signatures" ] || complain "$readme shows no signature from the starter"
    for role in starter solution; do
        file=$(ls "$folder/$role"/*)
        printf '%s\n' "$signatures" | while IFS= read -r line; do
            grep -Fxq -- "$line" "$file" || { echo "$readme shows '$line', which is not in $file"; exit 1; }
        done || wrong=$((wrong + 1))
    done
    for hint in 1 2 3; do
        words=$(sh exercises/exercise.sh --hint-text "$readme" "$hint" | wc -w)
        [ "$words" -ge 8 ] || complain "$readme: hint $hint has $words words"
    done
done
echo "$exercises exercises, $caught of $mistakes mistakes caught"
[ "$exercises" -gt 0 ] && [ "$wrong" -eq 0 ] && [ "$caught" -eq "$mistakes" ]

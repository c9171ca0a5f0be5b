#!/bin/sh
# The launcher explains itself and refuses what it does not know, in one line and with status 2.
set -eu
refuses() {
    status=0
    lines=$(./course "$@" 2>&1 >/dev/null) || status=$?
    if [ "$status" != 2 ] || [ "$(printf '%s\n' "$lines" | wc -l)" != 1 ] || [ -z "$lines" ]; then
        echo "./course $*: status $status, said: $lines"
        exit 1
    fi
}
./course help | grep -q './course run N'
./course | grep -q './course test'
refuses nonsense
refuses run 99
refuses run nonsense
refuses run --nonsense
refuses view
refuses view 99
refuses test nonsense
refuses slides nonsense
./course doctor | grep -q 'Packages'
# The help names every command, and fits a terminal of 80 columns.
for command in run test view compare accuracy claims exercise slides doctor; do
    ./course help | grep -q "^  ./course $command " || { echo "./course help does not name $command"; exit 1; }
done
./course help | awk 'length > 80 { print "./course help is too wide: " $0; bad = 1 } END { exit bad }'
# Each exercise has a line that fits, too, with its state: tests/exercises looks at the list itself.
for readme in exercises/[0-9]*/README.md; do
    name=$(basename "$(dirname "$readme")")
    line=$(printf '  %-9s %-19s %s (does not build)' 'not done' "$name" "$(sed -n '1s/^# *[0-9]* · *//p' "$readme")")
    [ "${#line}" -le 80 ] || { echo "./course exercise list is too wide: $line"; exit 1; }
done
# Every package is named once, with its need and its purpose.
awk '!/^#/ && ($2 != "needed" && $2 != "useful" || NF < 3 || seen[$1]++) { print "common/packages.txt: " $0; bad = 1 } END { exit bad }' common/packages.txt
echo "the launcher refuses what it does not know"

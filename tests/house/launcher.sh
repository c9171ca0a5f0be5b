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
# Every package is named once, with its need and its purpose.
awk '!/^#/ && ($2 != "needed" && $2 != "useful" || NF < 3 || seen[$1]++) { print "common/packages.txt: " $0; bad = 1 } END { exit bad }' common/packages.txt
echo "the launcher refuses what it does not know"

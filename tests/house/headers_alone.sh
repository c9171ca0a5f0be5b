#!/bin/sh
# Every header compiles on its own, in the order in which nobody thought of including it.
# (Those of the exercises are compiled one by one in their own test.)
#   headers_alone.sh COMPILER BUILD-FOLDER
set -eu
compiler=$1 work=$2/headers_alone
rm -rf "$work"
mkdir -p "$work"
# The folders of the packages that headers may use, as the build found them.
folders=$(grep -ohE -- '-isystem [^ ]+' "$2/compile_commands.json" | sort -u | tr '\n' ' ')
find chapters common tests exercises/grading -name '*.hpp' | sort |
    xargs -P "$(nproc)" -I {} sh -c '
        log='"$work"'/$(echo "{}" | tr / _).log
        echo "#include \"{}\"" | '"$compiler"' -std=c++20 -I. -Iexercises '"$folders"' -Wall -Wextra -Wconversion -Wshadow -Werror \
            -Wno-unused-function -fsyntax-only -x c++ - 2>"$log" || echo "{}" >>'"$work"'/failed'
if [ -e "$work/failed" ]; then
    sort "$work/failed" | while read -r header; do
        echo "$header does not compile alone:"
        grep -m 3 error "$work/$(echo "$header" | tr / _).log"
    done
    exit 1
fi
echo "$(find "$work" -name '*.log' | wc -l) headers compile alone"

#!/bin/sh
# The default tests must answer alike whatever compiles them: builds `accuracy` with each compiler, with and without
# -march=native, and compares what was counted in every default row: wrong answers, NaN, acne, leaks, and whether the
# threshold was reached. Ends 0 if all counts are the same, 1 if not, 2 if fewer than two builds could be made.
#
# The cases themselves are the same for every build by one compiler. Another compiler may work out the operands of an
# expression in another order, and so draw its random numbers in another: then it is asked other cases of the same kind.
#
#     tests/hard_cases/compilers.sh                                g++ and clang++-19, a few thousand cases a cell
#     COMPILERS="g++ clang++" tests/hard_cases/compilers.sh --cases 20000 --seed 7
set -u
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=${BUILD:-$source/build/compilers}
[ $# -gt 0 ] || set -- --quick --cases 4000 --seed 1

# One line for each default row, in order: what it is, and what was counted.
counts_of() {
    awk '/^  \{/ { row = ""; is_default = 0; next }
         /^  \}/ { if (is_default) print row; next }
         /"default": true/ { is_default = 1 }
         /^   "(family|test|kernel|scalar|parameter|misclassified|nan|acne|leaks|reached)"/ { row = row $0 }' "$1"
}

builds=0
different=0
for compiler in ${COMPILERS:-g++ clang++-19}; do
    if ! command -v "$compiler" > /dev/null; then
        echo "$compiler: not installed, left out"
        continue
    fi
    for native in ON OFF; do
        name=$compiler-$([ $native = ON ] && echo native || echo plain)
        build=$folder/$name
        mkdir -p "$build"
        if ! { cmake -S "$source" -B "$build" -G Ninja -DCOURSE_TESTS=ON -DCMAKE_CXX_COMPILER="$compiler" \
            -DCOURSE_NATIVE=$native && cmake --build "$build" --target accuracy; } > "$build/build.log" 2>&1; then
            echo "$name: could not be built, see $build/build.log"
            different=1
            continue
        fi
        "$build/tests/accuracy" "$@" --out-folder "$build/out" > "$build/accuracy.log" 2>&1 || {
            echo "$name: accuracy ended $?, see $build/accuracy.log"
            different=1
        }
        counts_of "$build/out/accuracy.json" > "$build/rows"
        builds=$((builds + 1))
        first=${first:-$build}
        if cmp -s "$first/rows" "$build/rows"; then
            echo "$name: $(wc -l < "$build/rows") default rows, the same"
        else
            echo "$name: differs from $(basename "$first") in these default rows"
            diff "$first/rows" "$build/rows" | sed -n '1,20p'
            different=1
        fi
    done
done
[ $builds -gt 1 ] || { echo "fewer than two builds: nothing to compare" >&2; exit 2; }
exit $different

#!/bin/sh
# ./course exercise: builds and grades the exercises, one alone or a whole class. exercises/README.md tells how to work.
#   COURSE_WORK, COURSE_BUILD: other folders for the learner's files and for the build (the tests use them)
set -u
work=${COURSE_WORK:-exercises/work}
build=${COURSE_BUILD:-build}
seconds=${COURSE_SECONDS:-10} # of the processor's time that an answer may take

say() { printf '%s\n' "$*"; }
fail() { printf 'course: %s\n' "$*" >&2; exit 2; }

case $seconds in '' | 0* | *[!0-9]*) fail "COURSE_SECONDS is a whole number of seconds, not '$seconds'" ;; esac

help_text() {
    cat <<'TEXT'
  ./course exercise               the same as list
  ./course exercise list          every exercise and how far you are
  ./course exercise NAME          builds and grades one; the first time, it lays out your file
  ./course exercise hint NAME     a hint; the next one with each call (--all: all three)
  ./course exercise solution NAME shows the solution, after asking (--yes: without)
  ./course exercise reset NAME    begins anew; your file is kept beside the new one
  ./course exercise watch NAME    grades again whenever you save; Ctrl-C ends it
  ./course exercise grade FOLDER  grades a class: FOLDER/STUDENT/NN_name/FILE becomes a table
                                  (--only NAME: one exercise; --out FILE.csv instead of out/grades.csv)

NAME is any beginning that fits one exercise alone: 01_sphere_roots, 01, 1 or sphere.
Exit status: 0 passed, 1 wrong, 2 a mistake on the command line, 3 not done.
TEXT
}

if [ -t 1 ]; then
    green=$(printf '\033[32m') red=$(printf '\033[31m') yellow=$(printf '\033[33m') bold=$(printf '\033[1m') plain=$(printf '\033[0m')
else
    green='' red='' yellow='' bold='' plain=''
fi
coloured() {
    sed -e "s/^  passed /  ${green}passed${plain} /" -e "s/^  wrong /  ${red}wrong${plain} /" \
        -e "s/^  not done /  ${yellow}not done${plain} /" -e "s/^First to mend: .*/${bold}&${plain}/"
}

# ---- Names and files -----------------------------------------------------------------------------------------------

exercises() { for test in exercises/[0-9]*/test.cpp; do [ -e "$test" ] && basename "$(dirname "$test")"; done; }
answer_file() { basename "$(find "exercises/$1/starter" -type f | head -n 1)"; } # of the exercise of that name
title() { sed -n '1s/^# *[0-9]* · *//p' "exercises/$1/README.md"; }

# The exercise that alone begins so: its number, its whole name, or the words after the number.
exercise() {
    [ $# -eq 1 ] && [ -n "$1" ] || fail "which exercise? ./course exercise list shows them"
    case $1 in
    [0-9] | [0-9]_*) begins="0$1" ;;
    *) begins=$1 ;;
    esac
    found='' count=0
    for name in $(exercises); do
        if [ "$name" = "$begins" ] || [ "${name#*_}" = "$begins" ]; then
            say "$name"
            return 0
        fi
        case $name in
        "$begins"*) ;;
        *) case ${name#*_} in "$begins"*) ;; *) continue ;; esac ;;
        esac
        found="$found${found:+ or }$name" count=$((count + 1))
    done
    [ "$count" -gt 0 ] || fail "there is no exercise '$1'; ./course exercise list shows them"
    [ "$count" -eq 1 ] || fail "'$1' could be $found"
    say "$found"
}

# Lays out the learner's file, and never touches one that is there.
lay_out() {
    file=$work/$1/$(answer_file "$1")
    [ -e "$file" ] && return 0
    mkdir -p "$work/$1" 2>/dev/null || fail "$work/$1 cannot be made"
    cp "exercises/$1/starter/$(answer_file "$1")" "$file" || fail "$file cannot be written"
    say "Your file is $file"
    say "The task stands in exercises/$1/README.md"
}

# ---- Building and grading --------------------------------------------------------------------------------------------

# The graders of these exercises; what went wrong is shown.
build_graders() {
    [ -f "$build/build.ninja" ] || fail "there is no build in $build; ./course exercise makes one"
    mkdir -p "$build/exercises/results"
    targets=
    for grader in "$@"; do targets="$targets grade_$grader"; done
    log=$build/exercises/graders.log
    [ -x "$build/exercises/grade_$1" ] || say "Building the grader (the first time, this takes a few seconds more)" >&2
    # shellcheck disable=SC2086 # several targets
    cmake --build "$build" --target $targets >"$log" 2>&1 ||
        { grep -E -A 6 'error|FAILED' "$log" | head -n 20 >&2; fail "the grader could not be built ($log)"; }
    compile_command=$(ninja -C "$build" -t commands hand_over | sed -n 's/ -MD .*hand_over\.cpp$//p')
    [ -n "$compile_command" ] || fail "the build does not tell how it compiles"
    # Warnings inform, they do not refuse; and an answer that makes the compiler work without end is stopped, too.
    compile_command="$compile_command -Wno-error -Wno-conversion -Wno-float-conversion -Wno-sign-conversion -shared"
}

# limited SECONDS COMMAND...: with bounds on time, memory, and size of files, and no more than 64 KB of output. The time
# is the processor's; a program that only waits is stopped after four times as long.
limited() {
    limit=$1
    shift
    {
        (
            ulimit -c 0
            ulimit -f 40960 # blocks of 512 bytes
            ulimit -v 4194304 2>/dev/null # KB
            ulimit -t "$limit"
            exec timeout -k 1 $((4 * limit)) "$@"
        ) 2>&1
        say $? >"$status_file"
    } 2>/dev/null | timeout $((4 * limit + 3)) head -c 65536
}

# grade_file NAME FILE FOLDER: compiles and grades FILE. Leaves in FOLDER: verdict (one word or two, passed checks, all
# checks, what happened, with tabs between), output (what the answer printed), report, compiler.
grade_file() {
    name=$1 file=$2 folder=$3
    mkdir -p "$folder"
    rm -f "$folder"/verdict "$folder"/report "$folder"/journal
    : >"$folder/output"
    status_file=$folder/status
    answer=$folder/answer.so
    case $file in
    *.glsl) answer=$file; : >"$folder/compiler" ;;
    *)  limited 60 sh -c "$compile_command"' -o "$2" -include "$1" exercises/grading/hand_over.cpp' sh "$file" "$answer" \
            | sed '/^In file included from <command-line>:$/d' >"$folder/compiler"
        if [ "$(cat "$status_file")" != 0 ]; then
            printf 'does not compile\t0\t0\t%s\n' "$(grep -m 1 'error' "$folder/compiler" | sed 's/\t/ /g')" >"$folder/verdict"
            return 0
        fi ;;
    esac
    limited "$seconds" "$build/exercises/grade_$name" "$answer" "$folder/journal" "$folder/report" >"$folder/output"
    status=$(cat "$status_file")
    passed=$(grep -c '^passed' "$folder/journal" 2>/dev/null) all=$(grep -c '^running' "$folder/journal" 2>/dev/null)
    at=$(sed -n 's/^running\t//p' "$folder/journal" 2>/dev/null | tail -n 1)
    ended=$(sed -n 's/^end\t//p' "$folder/journal" 2>/dev/null)
    first=$(sed -n 's/^wrong\t//p' "$folder/journal" 2>/dev/null | head -n 1)
    case $status:$ended in
    0:passed) verdict=passed said= ;;
    1:wrong) verdict=wrong said=$first ;;
    3:'not done') verdict='not done' said= ;;
    124:* | 137:* | 152:*) verdict='too slow' said="stopped after $seconds s at: $at" ;;
    141:*) verdict='prints too much' said="stopped after 64 KB of output at: $at" ;;
    139:*) verdict=crashed said="segmentation fault at: $at" ;;
    134:*) verdict=crashed said="aborted at: $at" ;;
    136:*) verdict=crashed said="arithmetic exception at: $at" ;;
    *) verdict=crashed said="ended with status $status before its grade, at: $at" ;;
    esac
    printf '%s\t%s\t%s\t%s\n' "$verdict" "${passed:-0}" "${all:-0}" "$said" >"$folder/verdict"
}

# ---- One learner -----------------------------------------------------------------------------------------------------

results() { say "$build/exercises/results/$1"; }

# Changes when the answer or what grades it changes.
key() { cat "$work/$1/$(answer_file "$1")" "exercises/$1"/*.?pp exercises/grading/* 2>/dev/null | cksum; }

# Grades unless the last result still holds.
refresh() {
    folder=$(results "$1")
    [ -e "$folder/verdict" ] && [ "$(cat "$folder/key" 2>/dev/null)" = "$(key "$1")" ] && return 0
    grade_file "$1" "$work/$1/$(answer_file "$1")" "$folder"
    key "$1" >"$folder/key"
}

field() { cut -f "$1" "$(results "$2")/verdict"; }
is_new() { [ ! -e "$work/$1/$(answer_file "$1")" ] || cmp -s "$work/$1/$(answer_file "$1")" "exercises/$1/starter/$(answer_file "$1")"; }

exit_status() {
    case $1 in
    passed) return 0 ;;
    'not done') return 3 ;;
    *) return 1 ;;
    esac
}

grade_one() {
    lay_out "$1"
    build_graders "$1"
    refresh "$1"
    folder=$(results "$1") file=$work/$1/$(answer_file "$1")
    say "$bold$1: $(title "$1")$plain"
    verdict=$(field 1 "$1") passed=$(field 2 "$1") all=$(field 3 "$1") said=$(field 4 "$1")
    case $verdict in
    'does not compile')
        say "  ${red}does not compile$plain"
        say
        head -n 24 "$folder/compiler"
        ;;
    *)
        head -n 12 "$folder/compiler" # warnings
        if [ -s "$folder/output" ]; then
            say "  your program printed:"
            head -n 20 "$folder/output" | sed 's/^/    /'
        fi
        say
        if [ -s "$folder/report" ]; then
            coloured <"$folder/report"
            say
        fi
        ;;
    esac
    case $verdict in
    passed) say "${green}Passed: all $all checks.$plain Compare with the solution: ./course exercise solution $1" ;;
    'not done') say "${yellow}Not done yet:$plain $passed of $all checks pass. Write your lines in $file" ;;
    wrong) say "${red}Not right yet:$plain $passed of $all checks pass. Your file: $file" ;;
    'does not compile') ;;
    *) say "${red}$verdict:$plain $said" ;;
    esac
    [ "$verdict" = passed ] || say "Stuck? ./course exercise hint $1"
    exit_status "$verdict"
}

list() {
    begun=
    for name in $(exercises); do is_new "$name" || begun="$begun $name"; done
    # shellcheck disable=SC2086 # several names
    [ -z "$begun" ] || build_graders $begun
    done=0 number=0 next=
    for name in $(exercises); do
        number=$((number + 1))
        verdict='not done' detail=
        if ! is_new "$name"; then
            refresh "$name"
            verdict=$(field 1 "$name") detail=" ($(field 2 "$name") of $(field 3 "$name"))"
        fi
        case $verdict in
        passed) colour=$green detail='' done=$((done + 1)) ;;
        'not done') colour=$yellow ;;
        wrong) colour=$red ;;
        'does not compile') colour=$red detail=' (does not build)' verdict=wrong ;; # all within 80 columns
        'prints too much') colour=$red detail=' (prints on)' verdict=wrong ;;
        *) colour=$red detail=" ($verdict)" verdict=wrong ;;
        esac
        [ "$verdict" = passed ] || next=${next:-$name}
        printf '  %s%-9s%s %-19s %s%s\n' "$colour" "$verdict" "$plain" "$name" "$(title "$name")" "$detail"
    done
    say
    say "$done of $number exercises passed.${next:+ Next: ./course exercise $next}"
}

# The text of hint N of a README.
hint_text() {
    awk -v wanted="<details><summary>Hint $2</summary>" '$0 == wanted { inside = 1; next } /^<\/details>/ { inside = 0 } inside' "$1" |
        sed -e '/./,$!d'
}

hint() {
    all=
    [ "${1-}" = --all ] && { all=1; shift; }
    [ "${2-}" = --all ] && all=1
    name=$(exercise ${1+"$1"}) || exit 2
    [ $# -le 2 ] && { [ $# -lt 2 ] || [ "$2" = --all ]; } || fail "hint takes the name of one exercise, and --all"
    mkdir -p "$work/$name" 2>/dev/null || fail "$work/$name cannot be made"
    given=$(cat "$work/$name/.hints" 2>/dev/null || say 0)
    case $given in [0-3]) ;; *) given=0 ;; esac
    now=$((given < 3 ? given + 1 : 3))
    [ -z "$all" ] || now=3
    first=$now
    [ -z "$all" ] || first=1
    for number in 1 2 3; do
        [ "$number" -ge "$first" ] && [ "$number" -le "$now" ] || continue
        say "${bold}Hint $number of 3$plain"
        say
        hint_text "exercises/$name/README.md" "$number"
    done
    say "$now" >"$work/$name/.hints"
    if [ "$now" -lt 3 ]; then say "Another: ./course exercise hint $name"; else say "That is the last one. ./course exercise solution $name shows how it can be done."; fi
}

solution() {
    yes=
    [ "${1-}" = --yes ] && { yes=1; shift; }
    [ "${2-}" = --yes ] && yes=1
    name=$(exercise ${1+"$1"}) || exit 2
    if [ -z "$yes" ]; then
        [ -t 0 ] || fail "solution asks before it shows; add --yes where nobody can answer"
        printf 'Show the solution of %s? [y/N] ' "$name"
        read -r answer || answer=n
        case $answer in y | Y | yes) ;; *) say "Not shown."; return 0 ;; esac
    fi
    file=exercises/$name/solution/$(answer_file "$name")
    cat "$file"
    say
    say "It stands in $file"
}

reset_one() {
    name=$(exercise ${1+"$1"}) || exit 2
    [ $# -eq 1 ] || fail "reset takes the name of one exercise"
    file=$work/$name/$(answer_file "$name")
    if [ -e "$file" ]; then
        number=1
        while [ -e "$file.$number" ]; do number=$((number + 1)); done
        mv "$file" "$file.$number" || fail "$file cannot be moved"
        say "Your file is kept as $file.$number"
    fi
    rm -f "$work/$name/.hints"
    lay_out "$name"
}

watch_one() {
    name=$(exercise ${1+"$1"}) || exit 2
    [ $# -eq 1 ] || fail "watch takes the name of one exercise"
    lay_out "$name"
    file=$work/$name/$(answer_file "$name") before=
    trap 'exit 0' INT TERM
    while :; do
        now=$(cksum <"$file" 2>/dev/null)
        if [ -n "$now" ] && [ "$now" != "$before" ]; then
            before=$now
            [ ! -t 1 ] || printf '\033[2J\033[H'
            grade_one "$name"
            say "Watching $file: save it to grade again, Ctrl-C to end."
        fi
        sleep 0.5
    done
}

# ---- A class ---------------------------------------------------------------------------------------------------------

csv() { printf '"%s"' "$(printf '%s' "$1" | sed 's/"/""/g')"; }

# One line of the table: grade_submission NAME FOLDER STUDENT WORK
grade_submission() {
    file=$2/$3/$1/$(answer_file "$1")
    if [ -f "$file" ]; then
        grade_file "$1" "$file" "$4"
    else
        mkdir -p "$4"
        printf 'not handed in\t0\t0\t\n' >"$4/verdict"
    fi
    tab=$(printf '\t')
    while IFS="$tab" read -r verdict passed all said; do
        printf '%s,%s,%s,%s,%s,%s\n' "$(csv "$3")" "$1" "$verdict" "$passed" "$all" "$(csv "$said")"
    done <"$4/verdict"
}

grade_class() {
    class= only= out=out/grades.csv
    while [ $# -gt 0 ]; do
        case $1 in
        --only) [ $# -ge 2 ] || fail "--only needs the name of an exercise"; only=$(exercise "$2") || exit 2; shift ;;
        --out) [ $# -ge 2 ] || fail "--out needs a file"; out=$2; shift ;;
        -*) fail "grade takes --only NAME and --out FILE.csv, not '$1'" ;;
        *) [ -z "$class" ] || fail "grade takes one folder, not '$class' and '$1'"; class=$1 ;;
        esac
        shift
    done
    [ -n "$class" ] || fail "grade needs the folder of the submissions"
    [ -d "$class" ] || fail "$class is no folder"
    [ ! -d "$out" ] || fail "$out is a folder, not a file"
    mkdir -p "$(dirname "$out")" 2>/dev/null && (: >"$out.part") 2>/dev/null || fail "$out cannot be written"
    names=${only:-$(exercises)}
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch" "$out.part"' EXIT
    trap 'exit 130' INT TERM
    # shellcheck disable=SC2086 # several names
    build_graders $names
    say 'student,exercise,result,passed,checks,remark' >"$out.part"
    students=0
    for student in "$class"/*/; do
        [ -d "$student" ] || continue
        student=$(basename "$student") students=$((students + 1))
        for name in $names; do
            grade_submission "$name" "$class" "$student" "$scratch/work" >"$scratch/line"
            cat "$scratch/line" >>"$out.part"
            [ ! -t 2 ] || cat "$scratch/line" >&2
            rm -rf "$scratch/work"
        done
    done
    [ "$students" -gt 0 ] || fail "$class holds no folder of a student"
    mv "$out.part" "$out" || fail "$out cannot be written"
    say "$students students, $(say "$names" | wc -w) exercises: $out"
}

# ---- The command line ------------------------------------------------------------------------------------------------

command=${1:-list}
case $command in
list) [ $# -le 1 ] || fail "list takes nothing, not '$2'"; list ;;
hint) shift; hint "$@" ;;
solution) shift; solution "$@" ;;
reset) shift; reset_one "$@" ;;
watch) shift; watch_one "$@" ;;
grade) shift; grade_class "$@" ;;
help | -h | --help) help_text ;;
--hint-text) hint_text "$2" "$3" ;; # for the maintainers' test
-*) fail "exercise does not know '$1'; ./course exercise help lists what it does" ;;
*)  [ $# -eq 1 ] || fail "exercise takes one name, not also '$2'"
    name=$(exercise "$1") || exit 2
    grade_one "$name" ;;
esac

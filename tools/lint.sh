#!/bin/sh
# What reviewers should not have to look for: formatting, scripts, layers, circles of includes, long files, names of methods and
# constants where they do not belong, and GLSL that WebGL or a second compiler refuses. Every finding begins with its file and line.
# tools/lint.sh [CHECK ...]: all of them by default; the names are those of the functions check_* below.
# The checks are called by their names, and the names of files have no blanks.
# shellcheck disable=SC2046,SC2317
set -eu
export LC_ALL=C
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

check_format() {
    git ls-files '*.c' '*.h' '*.hpp' 'src/*.cpp' | xargs clang-format --dry-run -Werror
}

check_scripts() {
    git ls-files '*.sh' .ci/run | xargs shellcheck -f gcc
}

check_cppcheck() {
    cppcheck --quiet -j "$(nproc)" --std=c11 --enable=warning,performance,portability --inline-suppr --error-exitcode=1 \
        --suppress=missingIncludeSystem --template=gcc -D_POSIX_C_SOURCE=200809L -Isrc $(git ls-files 'src/*.c')
}

# includes FOLDER FILES: one line for each include of a file of FOLDER by another: "file line included".
includes() {
    root=$1
    shift
    grep -Hn '^ *#include "' "$@" | sed -n "s|^$root/\([^:]*\):\([0-9]*\): *#include \"\([^\"]*\)\".*|\1 \2 \3|p"
}

# layered FOLDER "a b c=d" FILES: a file includes from its own folder and from folders before it in the list; = joins equals.
# What stands beside the folders is named like one. Files outside of every layer, such as main.c, may include all.
layered() {
    root=$1 layers=$2
    shift 2
    includes "$root" "$@" | awk -v root="$root" -v layers="$layers" '
        function layer(path) { sub("/.*", "", path); return path in level ? level[path] : 0 }
        BEGIN {
            n = split(layers, list, " ")
            for (i = 1; i <= n; i++) { m = split(list[i], equals, "="); for (k = 1; k <= m; k++) level[equals[k]] = i }
        }
        layer($3) == 0 { printf "%s/%s:%d: %s is in no known layer\n", root, $1, $2, $3; bad = 1; next }
        layer($1) && layer($3) > layer($1) {
            printf "%s/%s:%d: includes %s, of a layer above its own\n", root, $1, $2, $3
            bad = 1
        }
        END { exit bad }'
}

# circles FOLDER FILES: x.c and x.h count as one. An include is part of a circle if its file is reached again from what it includes.
circles() {
    root=$1
    shift
    includes "$root" "$@" | awk -v root="$root" '
        function unit(path) { sub(/\.(c|h|cpp|hpp)$/, "", path); return path }
        function reaches(from, to, seen, count, queue, i, k, next_) {
            queue[count = 1] = from
            for (i = 1; i <= count; i++) {
                for (k = 1; k <= out[queue[i]]; k++) {
                    next_ = edge[queue[i], k]
                    if (next_ == to) return 1
                    if (!(next_ in seen)) { seen[next_]; queue[++count] = next_ }
                }
            }
            return 0
        }
        {
            a = unit($1); b = unit($3)
            if (a == b) next
            edge[a, ++out[a]] = b
            from[++n] = a; to[n] = b; line[n] = root "/" $1 ":" $2 ": includes " $3
        }
        END {
            for (i = 1; i <= n; i++) if (reaches(to[i], from[i])) { print line[i] ", which leads back here"; bad = 1 }
            exit bad
        }'
}

check_layers() {
    layered src "base image source scene gl choice sky render error view chart export cmd" $(git ls-files 'src/*.[ch]' 'src/*.[ch]pp')
}

check_circles() {
    circles src $(git ls-files 'src/*.[ch]' 'src/*.[ch]pp')
}

# The library is pure: only files of pass/ have uniforms and textures, and know of the program's inputs and outputs.
check_glsl_layers() {
    found=0
    layered glsl "math scene.glsl color=shape=distance=material sequence=sky mist sun=light=emission pass" $(git ls-files 'glsl/*.glsl') || found=1
    circles glsl $(git ls-files 'glsl/*.glsl') || found=1
    for file in $(git ls-files 'glsl/*.glsl' ':!glsl/pass'); do
        sed 's|//.*||' "$file" | grep -nE '^ *(layout.*)?uniform |\<sampler[123]D|\<texture[A-Z(]|\<texel|\<gl_|^#version|^(in|out) ' >"$work/lines" || continue
        sed "s|^\([0-9]*\):|$file:\1: belongs into glsl/pass: |" "$work/lines"
        found=1
    done
    return "$found"
}

# A file of src/ has one subject and at most 300 lines. What is longer stands here, with its reason.
long_files=""
check_length() {
    found=0
    for file in $(git ls-files 'src/*.[ch]' 'src/*.[ch]pp'); do
        lines=$(wc -l <"$file")
        [ "$lines" -gt 300 ] || continue
        case " $long_files " in *" $file "*) continue ;; esac
        echo "$file:301: the file has $lines lines, more than 300"
        found=1
    done
    return "$found"
}

# A method is told by what its row says, not by its name. (src/scene, which knows no methods, has words of the same spelling.)
check_methods() {
    names=$(sed -n 's/.*\.name = "\([a-z]*\)".*/\1/p' src/choice/method.c | sort -u | paste -sd '|')
    [ -n "$names" ] || { echo "src/choice/method.c:1: no row with a name was found"; return 1; }
    ! grep -nE "strn?cmp\([^;]*\"($names)[\":]" $(git ls-files 'src/*.[ch]' 'src/*.[ch]pp' ':!src/choice/method.c' ':!src/scene')
}

# One pi, in base/vec3.h, and one in glsl/math.
check_constants() {
    ! grep -nE 'M_PI|3\.1415|#define +(pi|PI)|(double|float) +(pi|PI|degree|DEGREE) *=' \
        $(git ls-files 'src/*.[ch]' 'src/*.[ch]pp' 'glsl/*.glsl' ':!src/base' ':!glsl/math')
}

# What WebGL refuses and other compilers take (glsl/README.md): ?: between structures, and textures that are looked up by derivatives.
# A side of ?: is a structure if it is a call of a function that returns one, or a name that the file declares as one.
# shellcheck disable=SC2086
check_webgl() {
    files=$(git ls-files 'glsl/*.glsl' 'scenes/*.glsl')
    structures=$(sed -n 's/^struct \([A-Za-z0-9_]*\).*/\1/p' $files | sort -u | paste -sd '|')
    calls=$(grep -ohE "^($structures) [a-z_0-9]+\(" $files | sed 's/.* //; s/($//' | sort -u | paste -sd '|')
    found=0
    for file in $files; do
        awk -v file="$file" -v structures="$structures" -v calls="$calls" '
            { sub("//.*", "") }
            FNR == 1 { call = "(" structures "|" calls ")[(]" }
            /(^|[^A-Za-z0-9_])texture[(]/ { print file ":" NR ": texture() needs a derivative; use textureLod(..., 0.0)"; bad = 1 }
            # A statement may go on over several lines. It stands where its ? does.
            { text = text " " $0 }
            text ~ /[?]/ && !at { at = NR }
            /[;{}] *$/ || /^ *$/ { look(); text = ""; at = 0 }
            # Names stay declared to the end of the file: a name stands for one type there.
            function look(rest, names) {
                rest = text
                while (match(rest, "(^|[^A-Za-z0-9_])(" structures ") [a-z_0-9]+")) {
                    names = substr(rest, RSTART, RLENGTH)
                    sub(".* ", "", names)
                    declared[names]
                    rest = substr(rest, RSTART + RLENGTH)
                }
                rest = text
                while (match(rest, "[?:] *[A-Za-z0-9_]+ *[^A-Za-z0-9_]")) {
                    names = substr(rest, RSTART + 1, RLENGTH - 1)
                    gsub("^ +| +", "", names)
                    rest = substr(rest, RSTART + RLENGTH - 1)
                    if (text ~ /[?]/ && (names ~ "^" call "$" || (names ~ /[;:,)]$/ && substr(names, 1, length(names) - 1) in declared))) {
                        print file ":" at ": WebGL refuses ?: between structures; use an if"
                        bad = 1
                        return
                    }
                }
            }
            END { exit bad }' "$file" || found=1
    done
    return "$found"
}

# The names of a family's methods: methods --light.
methods() { build/magichour info | awk -v family="$1" '/^[^ ]/ { listed = $1 == family; next } listed { print $1 }'; }

# other_program NAME ENTRY SLOT FILE: what the window and `sky` draw is no pass of a picture, so that its text is made here, in the
# way of src/source/glsl_source.c: each file once, and a file in place of the slot.
other_program() {
    awk -v entry="$2" -v slot="$3" -v file="$4" '
        function emit(path, number, n, line) {
            while ((getline line <path) > 0) {
                n++
                if (line ~ /^#include "/) { split(line, part, "\""); include("glsl/" part[2]) }
                else if (line == "#include <" slot ">") include(file)
                else { print line; if (n > 1 || line !~ /^#version/) continue }
                print "#line " n + 1 " " number
            }
        }
        function include(path) {
            if (path in seen) return
            seen[path]
            print "#line 1 " ++count
            emit(path, count)
        }
        BEGIN { emit("glsl/pass/" entry ".glsl", 0) }' >"$programs/$1.frag"
    echo "$1" >"$programs/$1.choice"
}

other_programs() {
    echo 'void mainImage(out vec4 color, in vec2 at) { color = vec4(at / iResolution.xy, iTime, 1.0); }' >"$work/toy.glsl"
    for way in glsl/pass/shown_*.glsl; do
        grep -q 'vec3 shown_color' "$way" || continue
        other_program "display-$(basename "$way" .glsl)" display shown "$way"
    done
    other_program sky_probe sky_probe sky glsl/pass/sky_uniform.glsl
    build/magichour flatten "$work/toy.glsl" >"$programs/shadertoy.frag"
    echo shadertoy >"$programs/shadertoy.choice"
}

# The air between the surfaces, for the scenes that have a switch for it: under a sky that has air and one that has none, in three colours and by a spectrum.
air() {
    grep -q '^//@ *air ' "$1" || return 0
    for atmosphere in simmons2017 simmons2017-ozone earth; do
        for light in $lights; do echo "$1 --set air=on --light $light --atmosphere $atmosphere"; done
    done
    echo "$1 --set air=on --sky uniform"
    echo "$1 --set air=on --sun-disk=chance"
    echo "$1 --set air=on --atmosphere earth --set atmosphere.spectrum=3 --sun-disk"
}

# The mist that begins switched off.
mist() {
    grep -q '^//@ *mist *off' "$1" || return 0
    for light in $lights; do echo "$1 --set mist=on --light $light --sun-disk"; done
}

# Every program of each scene, with each method, through the reference compiler: a driver accepts more than the language has.
# Programs that are made more than once are compiled once.
check_glslang() {
    make -s all >/dev/null
    lights=$(methods --light) sequences=$(methods --sequence)
    for scene in scenes/*.glsl; do
        for atmosphere in simmons2017 simmons2017-ozone earth; do
            for sky in table gauss:4 gauss:12 paper; do echo "$scene --sky $sky --atmosphere $atmosphere"; done
        done
        for sky in table gauss; do echo "$scene --sky $sky --atmosphere earth --set atmosphere.spectrum=3"; done
        echo "$scene --sky uniform"
        echo "$scene --sun-disk=chance"
        air "$scene"
        mist "$scene"
        for light in $lights; do
            for sequence in $sequences; do
                echo "$scene --light $light --sequence $sequence"
                echo "$scene --light $light --sequence $sequence --sun-disk"
            done
        done
    done >"$work/choices"
    found=0 programs=$work/programs
    mkdir "$programs"
    export programs
    xargs -a "$work/choices" -d '\n' -n 1 -P "$(nproc)" "$0" --flatten || found=1
    other_programs
    find "$programs" -name '*.frag' -print0 | xargs -0 -n 1 -P "$(nproc)" "$0" --compile >"$work/findings" || found=1
    # Each place once, with one of the choices that come by it.
    sort -u -t '(' -k 1,1 "$work/findings"
    echo "lint: glslang: $(wc -l <"$work/choices") choices, $(find "$programs" -name '*.frag' | wc -l) different programs"
    return "$found"
}

# The programs of one choice, each into a file that is named by its content.
if [ "${1-}" = --flatten ]; then
    # shellcheck disable=SC2086
    if ! build/magichour flatten $2 --all >"$work/all" 2>"$work/log"; then
        echo "${2%% *}:1: flatten $2: $(cat "$work/log")"
        exit 1
    fi
    awk -v folder="$work" '/^\/\/ ==== / { n++; next } { print >(folder "/" n + 0 ".frag") }' "$work/all"
    for program in "$work"/*.frag; do
        name=$programs/$(sha1sum <"$program" | cut -d ' ' -f 1)
        echo "$2" >"$name.choice"
        mv "$program" "$name.frag"
    done
    exit 0
fi

# One program: glslang's messages begin "ERROR: N:LINE:". What follows the program's first "#line M N" is line M of the file.
if [ "${1-}" = --compile ]; then
    glslangValidator "$2" >"$work/log" && exit 0
    grep '^ERROR: [0-9]*:[0-9]*:' "$work/log" | while IFS=: read -r _ source line message; do
        text=$(sed -n "/^#line [0-9]*$source\$/{n;p;q;}" "$2")
        file=$(grep -rlxF --include='*.glsl' -e "$text" glsl scenes | head -n 1)
        echo "${file:-program}:$line:$message (flatten $(cat "${2%.frag}.choice"))"
    done
    exit 1
fi

failed=0
[ $# -gt 0 ] || set -- format scripts cppcheck layers circles glsl_layers length methods constants webgl glslang
for check in "$@"; do
    start=$(date +%s)
    result=clean
    "check_$check" || result=FAILED failed=1
    echo "lint: $check: $result, $(($(date +%s) - start)) s"
done
exit $failed

#!/bin/sh
# Do two builds make the same pictures, to the bit? tools/same.sh BASE NEW [FOLDER] [options]
#
# BASE and NEW are folders that hold build/magichour, glsl/ and scenes/; each build renders its own scenes, with the same
# seed. Pictures and results go to FOLDER, out/same by default. Three sets of pictures are rendered of every scene:
#   light x sequence x sun disk, with the default sky of the atmosphere simmons2017;
#   sky x sun disk, with the default light;
#   preset x sun disk, with every method by default and the scene's own atmosphere.
# A choice that both builds refuse with the same message counts as the same. Where no value differs by more than a millionth of
# it, as when a sum is taken in another order, the picture counts as rounded. Exits with 1 if anything differs by more.
#
#   --quick             about two minutes: every light with the sun's disk, one sequence, no further skies, no presets
#   --scenes "A B"      only these scenes, by their names without .glsl
#   --lights, --sequences, --disks, --skies, --presets "A B"   only these; "" leaves that set of pictures out.
#                       A sky may begin with an atmosphere's name and a slash: earth/table; simmons2017 if it does not
#   --size WxH, --spp N, --seed N, --jobs N
set -eu
export LC_ALL=C
# shellcheck source=tools/measure.sh
. "$(dirname "$0")/measure.sh"

# render FOLDER PICTURE SCENE OPTIONS...: what the build in FOLDER says goes to PICTURE.log.
render() {
    folder=$1 picture=$2 scene=$3
    shift 3
    (cd "$folder" && timeout 300 build/magichour render "scenes/$scene.glsl" "$@" --quiet -o "$picture") >"$picture.log" 2>&1
}

# What a build said, without the name of its folder.
words() { sed "s|$1/||g" "$2.log"; }

# What `compare` measures, and the value that differs most for its size. Succeeds where that is a millionth at most.
difference() {
    "$BASE/build/magichour" compare "$2" "$1" 2>&1 | awk '$1 == "relRMSE" { printf "relRMSE %s %%, ", $2 }'
    for picture in "$1" "$2"; do pfm_values "$picture" >"$picture.txt"; done
    paste "$1.txt" "$2.txt" | awk '
        function size(x) { return x < 0 ? -x : x }
        $1 "" == $2 "" { next }
        {
            n++
            most = size($1) > size($2) ? size($1) : size($2)
            part = most > 0 && $0 !~ /n/ ? size($1 - $2) / most : 1
            if (!(part <= worst)) { worst = part; a = $1; b = $2 }
        }
        END { printf "%d of %d values, at most %s for %s\n", n, NR, b, a; exit !(worst <= 1e-6) }'
}

# One line about one choice: `same`, `refused`, `rounded` or `DIFFERS`, the choice, and how it differs.
if [ "${1-}" = --one ]; then
    choice=$2
    name=$(echo "$choice" | tr -c 'a-zA-Z0-9.\n' '-')
    a=$FOLDER/$name.base.pfm b=$FOLDER/$name.new.pfm
    # The words of a choice are a scene's name and options, without blanks in them.
    # shellcheck disable=SC2086
    set -- $choice $OPTIONS
    rm -f "$a" "$b"
    code_a=0 code_b=0
    render "$BASE" "$a" "$@" || code_a=$?
    render "$NEW" "$b" "$@" || code_b=$?
    if [ $code_a != $code_b ]; then
        result="DIFFERS $choice: exit codes $code_a and $code_b: $(cat "$a.log" "$b.log" | head -n 3 | tr '\n' ' ')"
    elif [ $code_a != 0 ] && [ "$(words "$BASE" "$a")" = "$(words "$NEW" "$b")" ]; then
        result="refused $choice: $(words "$BASE" "$a" | head -n 1)"
    elif [ $code_a != 0 ]; then
        result="DIFFERS $choice: refused with other words: $(words "$BASE" "$a" | head -n 1) / $(words "$NEW" "$b" | head -n 1)"
    elif cmp -s "$a" "$b"; then
        result="same $choice"
    elif how=$(difference "$a" "$b"); then
        result="rounded $choice: $how"
    else
        result="DIFFERS $choice: $how"
    fi
    case $result in
    DIFFERS*) echo "$result" ;;
    *) rm -f "$a" "$b" "$a.log" "$b.log" "$a.txt" "$b.txt" ;;
    esac
    echo "$result" >>"$FOLDER/results"
    exit 0
fi

usage() { sed -n '2,/^set/s/^# \{0,1\}//p' "$0" >&2; exit 2; }
[ $# -ge 2 ] || usage
BASE=$(realpath "$1") NEW=$(realpath "$2")
shift 2
FOLDER=out/same
case ${1-} in --*) ;; ?*) FOLDER=$1 && shift ;; esac

scenes="" size=24x24 spp=16 seed=1 jobs=2
lights="control mis cosine paper" sequences="sobol additive random" disks="off sampled chance"
skies="table gauss:4 gauss:8 gauss:12 paper:16x4 uniform simmons2017-ozone/table simmons2017-ozone/gauss:8
simmons2017-ozone/paper:16x4 earth/table"
presets=all
while [ $# -gt 0 ]; do
    case $1 in
    --quick)
        sequences=sobol disks=sampled skies="" presets=""
        shift
        continue
        ;;
    --*) [ $# -ge 2 ] || usage ;;
    esac
    case $1 in
    --scenes) scenes=$2 ;;
    --lights) lights=$2 ;;
    --sequences) sequences=$2 ;;
    --disks) disks=$2 ;;
    --skies) skies=$2 ;;
    --presets) presets=$2 ;;
    --size) size=$2 ;;
    --spp) spp=$2 ;;
    --seed) seed=$2 ;;
    --jobs) jobs=$2 ;;
    *) usage ;;
    esac
    shift 2
done
for folder in "$BASE" "$NEW"; do
    [ -x "$folder/build/magichour" ] || { echo "same: no build/magichour in $folder" >&2; exit 2; }
done
if [ -z "$scenes" ]; then
    for file in "$BASE"/scenes/*.glsl; do scenes="$scenes $(basename "$file" .glsl)"; done
fi

mkdir -p "$FOLDER"
FOLDER=$(realpath "$FOLDER")
OPTIONS="--size $size --spp $spp --seed $seed"
export BASE NEW FOLDER OPTIONS
: >"$FOLDER/results"

for scene in $scenes; do
    [ -f "$BASE/scenes/$scene.glsl" ] || { echo "same: no scene $scene in $BASE" >&2; exit 2; }
    for disk in $disks; do
        for light in $lights; do for sequence in $sequences; do
            echo "$scene --atmosphere simmons2017 --light $light --sequence $sequence --sun-disk=$disk"
        done; done
        for sky in $skies; do
            case $sky in
            */*) echo "$scene --atmosphere ${sky%%/*} --sky ${sky#*/} --sun-disk=$disk" ;;
            *) echo "$scene --atmosphere simmons2017 --sky $sky --sun-disk=$disk" ;;
            esac
        done
        names=$presets
        if [ "$presets" = all ]; then
            names=$("$BASE/build/magichour" info "$BASE/scenes/$scene.glsl" | sed -n 's/^ *--preset \([^:]*\):.*/\1/p')
        fi
        for preset in $names; do echo "$scene --preset $preset --sun-disk=$disk"; done
    done
done >"$FOLDER/choices"

start=$(date +%s)
xargs -a "$FOLDER/choices" -d '\n' -n 1 -P "$jobs" sh "$0" --one
count() { grep -c "^$1 " "$FOLDER/results" || true; }
seconds=$(($(date +%s) - start))
same=$(count same) refused=$(count refused) rounded=$(count rounded) differs=$(count DIFFERS) asked=$(wc -l <"$FOLDER/choices")
echo "same: $asked choices in $seconds s: $same same to the bit, $refused refused alike, $rounded rounded, $differs differ"
[ $((same + refused + rounded)) = "$asked" ] && [ "$same" -gt 0 ]

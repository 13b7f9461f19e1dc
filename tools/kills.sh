#!/usr/bin/env bash
# Kills renders that keep a checkpoint at random moments, goes on from it, and compares the end with a render that was never
# interrupted: tools/kills.sh [-n KILLS] [-s SIGNAL] SCENE [options of render]. Prints what was found, and fails if a picture
# differs, a checkpoint cannot be read, or a temporary file is left.
set -euo pipefail
kills=20 signal=KILL
while getopts n:s: option; do
    case $option in
    n) kills=$OPTARG ;;
    s) signal=$OPTARG ;;
    *) exit 2 ;;
    esac
done
shift $((OPTIND - 1))
[ $# -gt 0 ] || { echo "usage: tools/kills.sh [-n KILLS] [-s SIGNAL] SCENE [options of render]" >&2; exit 2; }
magichour=${MAGICHOUR:-$(dirname "$0")/../build/magichour}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

render() { "$magichour" render "$@" --quiet --progress none; }

# All lines of the metadata that a clock or a command line does not change.
facts() { "$magichour" info "$1" | grep -vE 'magichour\.(seconds|command)|^[^ ]*: '; }

start=$(date +%s.%N)
render "$@" -o "$folder/whole.exr" -o "$folder/whole.pfm" || [ $? = 7 ]
seconds=$(awk -v a="$start" -v b="$(date +%s.%N)" 'BEGIN { print b - a }')
echo "never interrupted: $seconds s"

resumed=0 anew=0 finished=0 unequal=0 unread=0
for ((i = 0; i < kills; i++)); do
    rm -f "$folder"/part*
    moment=$(awk -v s="$seconds" -v seed="$RANDOM$RANDOM" 'BEGIN { srand(seed); print s * rand() }')
    render "$@" -o "$folder/part.exr" --checkpoint "$folder/part.state" --checkpoint-every 0.01 2>"$folder/said" &
    sleep "$moment"
    kill -s "$signal" $! 2>/dev/null || finished=$((finished + 1))
    wait $! 2>/dev/null || true
    if [ -e "$folder/part.state" ]; then resumed=$((resumed + 1)); else anew=$((anew + 1)); fi
    status=0
    render "$@" -o "$folder/part.exr" -o "$folder/part.pfm" --checkpoint "$folder/part.state" --resume "$folder/part.state" \
        2>"$folder/said" || status=$?
    if [ $status != 0 ] && [ $status != 7 ]; then
        unread=$((unread + 1))
        cat "$folder/said"
        continue
    fi
    if ! cmp -s "$folder/whole.pfm" "$folder/part.pfm" || ! diff <(facts "$folder/whole.exr") <(facts "$folder/part.exr"); then
        unequal=$((unequal + 1))
    fi
done
left=$(find "$folder" -name '.magichour*' | wc -l)
echo "$kills killed by $signal: $resumed resumed from a checkpoint, $anew begun anew because there was none yet ($finished had ended already);" \
    "$unequal unequal, $unread not to be read, $left temporary files left"
[ "$unequal" = 0 ] && [ "$unread" = 0 ] && [ "$left" = 0 ]

#!/bin/sh
# Long runs: tools/long_runs.sh MAGICHOUR FOLDER [SAMPLES [WINDOW_SECONDS]]
#
# A picture of 4x4 pixels of the crater is rendered with SAMPLES samples (10,000,000), and with a tenth, a hundredth and a thousandth of them, by
# each sequence: the mean must not drift, and memory and speed must stay as they are. No picture has more than 2^24 samples of a pixel, because
# a film counts no more. So numbers of samples never come near 2^32; those of light paths have 64 bits.
# Then a window of its own display plays a day for WINDOW_SECONDS (600), and its memory and frames are noted 20 times.
# FOLDER/samples.csv has sequence,samples,drift_percent,noise_percent,peak_kb,mpaths_per_s: the drift is the difference of the means to the picture
# of most samples. FOLDER/window.csv has seconds,resident_kb,frames.
set -eu
export LC_ALL=C
magichour=$1 folder=$2 samples=${3:-10000000} window=${4:-600}
scenes=$(dirname "$0")/../scenes
mkdir -p "$folder"

# The largest resident memory of a process in kB. One that has ended has none.
peak_of() {
    peak=0
    while now=$(awk '/^VmHWM/ { print $2 }' "/proc/$1/status" 2>/dev/null) && [ -n "$now" ]; do
        peak=$now
        sleep 0.05
    done
    echo "$peak"
}

echo "sequence,samples,drift_percent,noise_percent,peak_kb,mpaths_per_s" >"$folder/samples.csv"
for sequence in sobol random additive; do
    for part in 1 10 100 1000; do
        count=$((samples / part)) picture=$folder/$sequence-$part.exr
        "$magichour" render "$scenes/crater.glsl" --size 4x4 --spp "$count" --sequence "$sequence" --progress json -o "$picture" \
            >/dev/null 2>"$folder/progress" &
        process=$!
        peak=$(peak_of "$process")
        wait "$process"
        last=$(tail -n 1 "$folder/progress")
        speed=$(echo "$last" | sed 's/.*"paths_per_s": \([0-9.e+]*\).*/\1/')
        noise=$(echo "$last" | sed 's/.*"noise_percent": \([0-9.e+-]*\).*/\1/')
        # Of one channel, because all have the same random numbers.
        drift=$("$magichour" compare "$picture" "$folder/$sequence-1.exr" --json | sed 's/.*"bias_R_G_B": \[\([^],]*\).*/\1/')
        echo "$sequence,$count,$drift,$noise,$peak,$speed" | awk -F, '{ printf "%s,%s,%s,%s,%s,%.2f\n", $1, $2, $3, $4, $5, 1e-6 * $6 }' |
            tee -a "$folder/samples.csv"
    done
done

echo "seconds,resident_kb,frames" >"$folder/window.csv"
rm -rf "$folder/frames"
xvfb-run -a -s "-screen 0 800x600x24" "$magichour" view "$scenes/crater.glsl" --size 320x240 --spp 4 --record "$folder/frames" \
    --frames 99999 --progress none >/dev/null 2>&1 &
runner=$!
trap 'kill "$runner" 2>/dev/null || true' EXIT
began=$(date +%s) step=$((window / 20))
[ "$step" -gt 0 ] || step=1
while [ $(($(date +%s) - began)) -lt "$window" ]; do
    sleep "$step"
    process=$(pgrep -f "^$magichour view" | head -n 1)
    if [ -z "$process" ]; then
        echo "the window has ended" >&2
        exit 1
    fi
    resident=$(awk '/^VmRSS/ { print $2 }' "/proc/$process/status")
    frames=$(find "$folder/frames" -name 'frame-*.png' | wc -l)
    echo "$(($(date +%s) - began)),$resident,$frames" | tee -a "$folder/window.csv"
done
kill -INT "$process"
wait "$runner" || true
trap - EXIT
rm -rf "$folder/frames"

#!/bin/sh
# Compares renders with stored pictures: renders.sh check|store [OPTION OF render...]
#
# Run it in the folder that holds pictures.txt. Each of its lines is one picture:
#     NAME BOUND SCENE [OPTION OF render...]        for example: noon 0.01 scenes/ball.glsl --sun 60 --size 256x256 --spp 64
# BOUND is the largest relRMSE that passes, in percent. Empty lines and lines that begin with # are left out. Words are parted by
# blanks alone: there is no quoting. The further options on the command line are those of all pictures, such as --backend osmesa.
#
# `store` renders stored/NAME.exr. `check` renders out/NAME.exr and compares it with that. Of a picture that differs by more it
# keeps, besides the EXR, out/NAME.png (the new picture, the stored one and their difference beside each other) and
# out/NAME.txt (the figures). The exit status is 6 if a picture differs, 1 if one is missing, and that of `render` if that failed.
# MAGICHOUR names the program where it is not on the PATH.
set -euf
program=${MAGICHOUR:-magichour}
action=${1-}
case $action in check | store) shift ;; *) sed -n '2s/^# //p' "$0" >&2; exit 2 ;; esac
[ -e pictures.txt ] || { echo "renders: no pictures.txt in $(pwd)" >&2; exit 2; }

status=0
# The first failure that is more than a difference is the whole's.
fail() { if [ "$status" = 0 ] || [ "$status" = 6 ]; then status=$1; fi; }

check() {
    name=$1 bound=$2
    if [ ! -e "stored/$name.exr" ]; then
        echo "$name: MISSING: stored/$name.exr; look at out/$name.exr and make it: renders.sh store"
        fail 1
        return
    fi
    compared=0
    "$program" compare "out/$name.exr" "stored/$name.exr" --max-relrmse "$bound" --side-by-side "out/$name.png" \
        >"out/$name.txt" 2>&1 || compared=$?
    figure=$(sed -n 's/^relRMSE *//p' "out/$name.txt")
    case $compared in
    0)
        echo "$name: equal within $bound % (relRMSE $figure)"
        rm -f "out/$name.exr" "out/$name.png" "out/$name.txt"
        ;;
    6)
        echo "$name: DIFFERS: relRMSE $figure, and $bound % is allowed; see out/$name.png"
        fail 6
        ;;
    *)
        cat "out/$name.txt"
        fail $compared
        ;;
    esac
}

folder=out
if [ "$action" = store ]; then folder=stored; fi
mkdir -p $folder
while read -r name bound arguments; do
    case $name in '' | '#'*) continue ;; esac
    rendered=0
    # shellcheck disable=SC2086
    "$program" render $arguments "$@" -o "$folder/$name.exr" --quiet </dev/null || rendered=$?
    if [ "$rendered" != 0 ]; then
        echo "$name: NOT RENDERED: exit status $rendered"
        fail $rendered
    elif [ "$action" = store ]; then
        echo "$name: stored/$name.exr"
    else
        check "$name" "$bound"
    fi
done <pictures.txt
exit "$status"

#!/bin/sh
# What reviewers should not have to look for: formatting, upward includes, GLSL by a second compiler.
set -eu
cd "$(dirname "$0")/.."
failed=0

echo "lint: clang-format"
git ls-files '*.c' '*.h' '*.hpp' 'src/*.cpp' | xargs clang-format --dry-run -Werror || failed=1

# src/ is layered: a file includes from its own folder and from folders before it in this list.
echo "lint: upward includes"
layers="base image scene gl choice sky render error chart view cmd"
allowed=""
for layer in $layers; do
    allowed="$allowed $layer"
    for file in src/"$layer"/*.[ch] src/"$layer"/*.cpp; do
        [ -f "$file" ] || continue
        for included in $(sed -n 's|^#include "\([a-z]*\)/.*|\1|p' "$file"); do
            case " $allowed " in
            *" $included "*) ;;
            *) echo "$file includes $included/, a layer above its own" >&2; failed=1 ;;
            esac
        done
    done
done

# Each scene, flattened with each method, through the reference compiler: a driver accepts more than the language has.
echo "lint: glslang"
magichour=build/magichour
make -s all
text=$(mktemp --suffix .frag)
trap 'rm -f "$text"' EXIT
check() {
    if ! "$magichour" flatten "$@" >"$text" || ! glslangValidator -S frag "$text" >"$text.log" 2>&1; then
        echo "flatten $*:" >&2
        cat "$text.log" >&2
        failed=1
    fi
    rm -f "$text.log"
}
for scene in scenes/*.glsl; do
    for sky in table gauss:4 gauss:12 paper uniform; do check "$scene" --sky $sky; done
    check "$scene" --sun-disk=chance
    for sky in table gauss paper; do check "$scene" --sky $sky --atmosphere earth; done
    for sequence in sobol additive random; do
        for light in control mis paper cosine; do
            check "$scene" --light $light --sequence $sequence
            check "$scene" --light $light --sequence $sequence --sun-disk
        done
    done
done

[ $failed = 0 ] && echo "lint: clean"
exit $failed

#!/bin/sh
# The scenes as one folder of static pages: tools/site.sh MAGICHOUR FOLDER [SCENE.glsl...]; by default all of scenes/.
# FOLDER/index.html needs neither scripts nor a server: it has each scene's picture, what to look for in it, its text, its page
# (`magichour export`) and its texts for Shadertoy, or the reason why there is none. With the same driver, the same bytes come each time.
#
# SPP=N     samples a pixel of the pictures; by default as many as each scene needs
# SIZE=WxH  their size; by default each scene's own
set -eu
export LC_ALL=C
magichour=$(realpath "$1")
mkdir -p "$2"
folder=$(realpath "$2")
shift 2
root=$(realpath "$(dirname "$0")/..")
# From the project's root, so that pages name a scene of the project as everybody would.
for scene in "$@"; do
    shift
    set -- "$@" "$(realpath --relative-base="$root" "$scene")"
done
cd "$root"
[ $# -gt 0 ] || set -- scenes/*.glsl
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
shadertoy=$("$magichour" export --help | grep -e --shadertoy || true)

# Rooms find light with difficulty, and the glow about a low sun is narrow.
samples() {
    case $1 in
    house | *-room | shafts) echo "${SPP:-2048}" ;;
    pillars | author-ball | spheres) echo "${SPP:-1024}" ;;
    *) echo "${SPP:-256}" ;;
    esac
}

escape() { sed 's/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g; s/"/\&quot;/g'; }

# number FILE OFFSET: four bytes, the highest first.
number() { od -An -tu4 --endian=big -j "$2" -N 4 "$1" | tr -d ' '; }

# kept FILE: where in a PNG its chunks without texts are: the first byte, counted from 1, and how many.
kept() {
    od -An -v -tu1 -w1 "$1" | awk '
        NR <= 8 { next }
        skip > 0 { skip--; next }
        { field[++n] = $1 }
        n == 8 {
            size = ((field[1] * 256 + field[2]) * 256 + field[3]) * 256 + field[4] + 12
            kind = sprintf("%c%c%c%c", field[5], field[6], field[7], field[8])
            if (kind ~ /^(tEXt|zTXt|iTXt)$/) { if (count) print first, count; count = 0 }
            else { if (!count) first = NR - 7; count += size }
            skip = size - 8; n = 0
        }
        END { if (count) print first, count }'
}

# plain FILE: a PNG without its texts, which say how long it took.
plain() {
    head -c 8 "$1"
    kept "$1" | while read -r first count; do tail -c "+$first" "$1" | head -c "$count"; done
}

# sized FILE: the attributes by which a page keeps the picture's place before it is there.
sized() { echo "width=\"$(number "$1" 16)\" height=\"$(number "$1" 20)\""; }

# exported SCENE OPTIONS...: prints nothing, or why `export` refuses the scene. Any other error ends all.
exported() {
    status=0
    "$magichour" export "$@" >"$work/log" 2>&1 || status=$?
    case $status in
    0) ;;
    2 | 3)
        reason=$(head -n 1 "$work/log")
        reason=${reason#magichour: }
        echo "${reason#"$(dirname "$1")/"}"
        ;;
    *) cat "$work/log" >&2 && return "$status" ;;
    esac
}

# The README's pictures, with what it says of them.
gallery() {
    sed -n '/^## /q; s/!\[/\n&/gp' README.md | sed -n 's|^!\[\(.*\)\](scenes/gallery/\(.*\)\.png).*|\2 \1|p' | while read -r name words; do
        plain "scenes/gallery/$name.png" >"$folder/gallery-$name.png"
        echo "<img src=\"gallery-$name.png\" alt=\"$(echo "$words" | escape)\" $(sized "$folder/gallery-$name.png") loading=\"lazy\">"
    done
}

# none WHAT REASON
none() { [ -z "$2" ] || echo "<p class=\"none\">There is no $1: $(echo "$2" | escape)</p>"; }

# simpler NAME SCENE: the texts for Shadertoy of a scene that they do not hold as it is; prints what they leave out, or nothing.
simpler() {
    while read -r options; do
        # shellcheck disable=SC2086
        [ -z "$(exported "$2" --shadertoy -o "$folder/$1-shadertoy" $options)" ] || continue
        echo "$options"
        return
    done <<OPTIONS
--sun-disk=off
--orders 1 --set atmosphere.ground_albedo=0
--orders 1 --set atmosphere.ground_albedo=0 --sun-disk=off
OPTIONS
}

# links NAME SCENE: the scene's page and texts, or why there is none.
links() {
    texts=
    left_out=
    rm -rf "$folder/$1.html" "$folder/$1-shadertoy"
    reason=$(exported "$2" -o "$folder/$1.html")
    [ -z "$shadertoy" ] || texts=$(exported "$2" --shadertoy -o "$folder/$1-shadertoy")
    [ -z "$texts" ] || left_out=$(simpler "$1" "$2")
    [ -z "$left_out" ] || texts=
    echo '<ul>'
    [ -n "$reason" ] || echo "<li><a href=\"$1.html\">Move its sun in the browser</a>"
    for file in "$folder/$1-shadertoy"/*.glsl; do
        [ ! -e "$file" ] || echo "<li><a href=\"$1-shadertoy/$(basename "$file")\">$(basename "$file") for Shadertoy</a>"
    done
    echo "<li><a href=\"$1.txt\">The scene's text</a>"
    echo '</ul>'
    [ -z "$left_out" ] || echo "<p class=\"none\">The texts for Shadertoy are made with <code>$left_out</code>, because they hold no tables and no disk.</p>"
    none "page of it" "$reason"
    none "text of it for Shadertoy" "$texts"
}

# card SCENE
card() {
    name=$(basename "$1" .glsl)
    "$magichour" info "$1" >"$work/info"
    title=$(sed -n "1s|^[^:]*: ||p" "$work/info" | escape)
    look=$(sed -n 's/^  look for: //p' "$work/info" | escape)
    "$magichour" render "$1" ${SIZE:+--size "$SIZE"} --spp "$(samples "$name")" --quiet -o "$work/picture.png"
    plain "$work/picture.png" >"$folder/$name.png"
    cp "$1" "$folder/$name.txt"
    links "$name" "$1" >"$work/links"
    picture="<img src=\"$name.png\" alt=\"$title${look:+: $look}\" $(sized "$folder/$name.png") loading=\"lazy\">"
    target=$name.html
    [ -e "$folder/$target" ] || target=$name.png
    echo "<article id=\"$name\">"
    echo "<a href=\"$target\">$picture</a>"
    echo "<h2>$title</h2>"
    [ -z "$look" ] || echo "<p>What to look for: $look.</p>"
    cat "$work/links"
    echo "<p><code>magichour view $name</code></p>"
    echo '</article>'
}

index() {
    cat tools/site.head.html
    echo '<div class="gallery">'
    gallery
    echo '</div>'
    echo '<main>'
    for scene in "$@"; do
        echo "site: $(basename "$scene" .glsl)" >&2
        card "$scene"
    done
    echo '</main>'
    echo "<footer>Made by $("$magichour" --version).</footer>"
    echo '</html>'
}

index "$@" >"$work/index.html"
mv "$work/index.html" "$folder/index.html"
echo "site: $folder/index.html"

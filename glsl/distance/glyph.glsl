#include "distance/polyline.glsl"

// Characters made of straight strokes, as distances in a plane. They have no inside: op_round() gives the strokes a width. There are capital letters,
// digits and the signs !'()+,-./:=? All other characters are empty. A word is the least of its characters' distances:
//
//     float d = distance_glyph(p, vec2(0.0), 1.0, 72);                                  // H
//     d = min(d, distance_glyph(p, vec2(GLYPH_ADVANCE, 0.0), 1.0, 73));                 // I
//
// A character whose code is a constant costs about as much as eight lines, since compilers leave out the rest. Other codes cost three times as much.

// From one character's corner to the next one's, for the height 1.
const float GLYPH_ADVANCE = 0.75;

// The strokes of a character go through at most 12 points of 5 bits, six in each number from the lowest bits on. A point is x + 4 y, with x from 0 to 3
// and y from 0 to 6. A point of 31 lifts the pen.
uvec2 glyph_strokes(int code) {
    uvec2 strokes = uvec2(0x3FFFFFFFu);
    strokes = code == 33 ? uvec2(0x3E10FD39u, 0x3FFFFFFFu) : strokes; // !
    strokes = code == 39 ? uvec2(0x3FFFFE39u, 0x3FFFFFFFu) : strokes; // '
    strokes = code == 40 ? uvec2(0x3FF116BAu, 0x3FFFFFFFu) : strokes; // (
    strokes = code == 41 ? uvec2(0x3FF09AD9u, 0x3FFFFFFFu) : strokes; // )
    strokes = code == 43 ? uvec2(0x3EE67D31u, 0x3FFFFFFFu) : strokes; // +
    strokes = code == 44 ? uvec2(0x3FFFFC05u, 0x3FFFFFFFu) : strokes; // ,
    strokes = code == 45 ? uvec2(0x3FFFFDCCu, 0x3FFFFFFFu) : strokes; // -
    strokes = code == 46 ? uvec2(0x3FFFFC21u, 0x3FFFFFFFu) : strokes; // .
    strokes = code == 47 ? uvec2(0x3FFFFF60u, 0x3FFFFFFFu) : strokes; // /
    strokes = code == 48 ? uvec2(0x0F7D6684u, 0x3FFB9022u) : strokes; // 0
    strokes = code == 49 ? uvec2(0x040F8734u, 0x3FFFFFFFu) : strokes; // 1
    strokes = code == 50 ? uvec2(0x013BEB34u, 0x3FFFFFE3u) : strokes; // 2
    strokes = code == 51 ? uvec2(0x1D3BEB34u, 0x3E4088EBu) : strokes; // 3
    strokes = code == 52 ? uvec2(0x3FF5A342u, 0x3FFFFFFFu) : strokes; // 4
    strokes = code == 53 ? uvec2(0x0EB7331Bu, 0x3FFF9022u) : strokes; // 5
    strokes = code == 54 ? uvec2(0x024A6757u, 0x3EC72CE2u) : strokes; // 6
    strokes = code == 55 ? uvec2(0x3FFF8778u, 0x3FFFFFFFu) : strokes; // 7
    strokes = code == 56 ? uvec2(0x0F7D6684u, 0x1ECF9022u) : strokes; // 8
    strokes = code == 57 ? uvec2(0x35738824u, 0x3EF6C299u) : strokes; // 9
    strokes = code == 58 ? uvec2(0x3E52FE31u, 0x3FFFFFFFu) : strokes; // :
    strokes = code == 61 ? uvec2(0x3EA47E50u, 0x3FFFFFFFu) : strokes; // =
    strokes = code == 63 ? uvec2(0x133BEB34u, 0x3FFF843Fu) : strokes; // ?
    strokes = code == 65 ? uvec2(0x073D6600u, 0x3FFFBD9Fu) : strokes; // A
    strokes = code == 66 ? uvec2(0x1D3BEB00u, 0x0023ADCCu) : strokes; // B
    strokes = code == 67 ? uvec2(0x024A6757u, 0x3FFFFCE2u) : strokes; // C
    strokes = code == 68 ? uvec2(0x047BEB00u, 0x3FFFFFE0u) : strokes; // D
    strokes = code == 69 ? uvec2(0x19F1831Bu, 0x3FFFFFEEu) : strokes; // E
    strokes = code == 70 ? uvec2(0x1CCF831Bu, 0x3FFFFFFFu) : strokes; // F
    strokes = code == 71 ? uvec2(0x024A6757u, 0x3FF73CE2u) : strokes; // G
    strokes = code == 72 ? uvec2(0x3FB1FF00u, 0x3FFFFDECu) : strokes; // H
    strokes = code == 73 ? uvec2(0x3E1CFF58u, 0x3FFFFC40u) : strokes; // I
    strokes = code == 74 ? uvec2(0x3E4088FBu, 0x3FFFFFFFu) : strokes; // J
    strokes = code == 75 ? uvec2(0x06CDFF00u, 0x3FFFFFFFu) : strokes; // K
    strokes = code == 76 ? uvec2(0x3FFF8C18u, 0x3FFFFFFFu) : strokes; // L
    strokes = code == 77 ? uvec2(0x07B73700u, 0x3FFFFFFFu) : strokes; // M
    strokes = code == 78 ? uvec2(0x3FFD8F00u, 0x3FFFFFFFu) : strokes; // N
    strokes = code == 79 ? uvec2(0x0F7D6684u, 0x3FFF9022u) : strokes; // O
    strokes = code == 80 ? uvec2(0x1D3BEB00u, 0x3FFFFFECu) : strokes; // P
    strokes = code == 81 ? uvec2(0x0F7D6684u, 0x069F9022u) : strokes; // Q
    strokes = code == 82 ? uvec2(0x1D3BEB00u, 0x3FFF8DACu) : strokes; // R
    strokes = code == 83 ? uvec2(0x1B0A6757u, 0x08111D6Eu) : strokes; // S
    strokes = code == 84 ? uvec2(0x3E1CFF58u, 0x3FFFFFFFu) : strokes; // T
    strokes = code == 85 ? uvec2(0x36710498u, 0x3FFFFFFFu) : strokes; // U
    strokes = code == 86 ? uvec2(0x3FFD8838u, 0x3FFFFFFFu) : strokes; // V
    strokes = code == 87 ? uvec2(0x36373418u, 0x3FFFFFFFu) : strokes; // W
    strokes = code == 88 ? uvec2(0x3E3C7F60u, 0x3FFFFFFFu) : strokes; // X
    strokes = code == 89 ? uvec2(0x37F7B618u, 0x3FF20447u) : strokes; // Y
    strokes = code == 90 ? uvec2(0x3FF18378u, 0x3FFFFFFFu) : strokes; // Z
    return strokes;
}

// The character with this code in ASCII. It is `height` high, up to half as wide, and `corner` is its lower left corner.
float distance_glyph(vec2 p, vec2 corner, float height, int code) {
    uvec2 strokes = glyph_strokes(code);
    vec3 q = vec3(6.0 / height * (p - corner), 0.0);
    vec3 last = vec3(0.0);
    bool down = false;
    float square = INFINITY;
    for (int i = 0; i < 12; i++) {
        uint point = strokes.x & 31u;
        strokes.x = (strokes.x >> 5u) | ((strokes.y & 31u) << 25u);
        strokes.y = strokes.y >> 5u;
        vec3 next = vec3(float(point & 3u), float(point >> 2u), 0.0);
        float nearer = min(square, polyline_square(q, last, next));
        bool draws = down && point != 31u;
        square = draws ? nearer : square;
        down = point != 31u;
        last = next;
    }
    return sqrt(square) * height / 6.0;
}

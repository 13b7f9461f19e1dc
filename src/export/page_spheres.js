// The spheres of a scene in a tree of boxes, as the lists that glsl/shape/spheres.glsl reads (src/scene/sphere_tree.h). A page has this file only if its scene
// has spheres. The tree is divided at the median of its longest side: it is built in less code than that of src/scene/sphere_tree.c, and finds the same hits.
const LEAF = 4, ENTRY = 8, COLUMNS = 4096;

MAKERS.sphere_tree = ([drawn]) => {
    const spheres = new Float32Array(4 * drawn.width * drawn.height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, drawn.framebuffer);
    gl.readPixels(0, 0, drawn.width, drawn.height, gl.RGBA, gl.FLOAT, spheres);
    const numbers = [];
    for (let i = 0; i < spheres.length / 4; i++) if (spheres[4 * i + 3] > 0) numbers.push(i);
    const root = numbers.length && tree_of(spheres, Int32Array.from(numbers)), entries = root ? root.entries : 0;
    const rows = Math.max(Math.ceil((8 * 2 * entries) / COLUMNS), 1), texels = new Float32Array(4 * COLUMNS * rows);
    for (let octant = 0, at = 0; root && octant < 8; octant++) at = write_node(spheres, root, octant, texels, at);
    if (rows > gl.getParameter(gl.MAX_TEXTURE_SIZE)) throw new Error("There are more spheres than this graphics driver's textures hold.");
    return { textures: [texture(COLUMNS, rows, gl.RGBA32F, gl.NEAREST, texels)], values: { spheres_count: [entries] } };
};

// Rounded outward.
function corner(value, way) {
    const near = Math.fround(value), step = Math.abs(near) * 1.2e-7 + 1e-38;
    return way < 0 ? (near > value ? Math.fround(near - step) : near) : near < value ? Math.fround(near + step) : near;
}

function tree_of(spheres, numbers) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (const i of numbers)
        for (let k = 0; k < 3; k++) {
            low[k] = Math.min(low[k], corner(spheres[4 * i + k] - spheres[4 * i + 3], -1));
            high[k] = Math.max(high[k], corner(spheres[4 * i + k] + spheres[4 * i + 3], 1));
        }
    if (numbers.length === 1) return { numbers, entries: 1 };
    if (numbers.length <= LEAF) return { low, high, numbers, entries: 1 + numbers.length };
    const sides = minus(high, low), axis = sides.indexOf(Math.max(...sides));
    const order = numbers.sort((a, b) => spheres[4 * a + axis] - spheres[4 * b + axis]), half = order.length >> 1;
    const halves = [tree_of(spheres, order.slice(0, half)), tree_of(spheres, order.slice(half))];
    return { low, high, axis, halves, entries: 1 + halves[0].entries + halves[1].entries };
}

// Writes a node's entries from float `at` on, and returns where they end. A ray of the octant meets the first half first.
function write_node(spheres, node, octant, texels, at) {
    if (node.low) {
        for (let k = 0; k < 3; k++) {
            const negative = (octant >> k) & 1;
            texels[at + k] = negative ? node.high[k] : node.low[k];
            texels[at + 4 + k] = negative ? node.low[k] : node.high[k];
        }
        texels[at + 7] = node.entries;
        at += ENTRY;
    }
    if (node.halves) {
        const first = (octant >> node.axis) & 1;
        return write_node(spheres, node.halves[1 - first], octant, texels, write_node(spheres, node.halves[first], octant, texels, at));
    }
    for (const i of node.numbers) {
        texels.set(spheres.subarray(4 * i, 4 * i + 4), at);
        texels[at + 4] = i;
        at += ENTRY;
    }
    return at;
}

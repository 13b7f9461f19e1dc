"use strict";
// The renderer: reads the page's data, fills the tables, adds samples to the film and shows it. It knows neither scenes nor methods: what it draws,
// in which order and with which uniforms is in the data (src/export/README.md).

// ---- The data: an object a line.
const DATA = { parameters: [], states: [], steps: [], variants: [], pieces: [], shaders: [], shows: {} };
for (const line of document.getElementById("data").textContent.trim().split("\n").map((text) => JSON.parse(text))) {
    if ("title" in line) Object.assign(DATA, line);
    else if ("parameter" in line) DATA.parameters.push(line);
    else if ("state" in line) DATA.states.push({ ...line, values: {} });
    else if ("value" in line) DATA.states.at(-1).values[line.value] = line.values;
    else if ("piece" in line) DATA.pieces.push(line.piece);
    else if ("shader" in line) DATA.shaders.push(line.shader);
    else if ("shows" in line) DATA.shows[line.shows] = line.draws;
    else if ("variant" in line) DATA.variants.push(line.variant.split(" ").map((number) => DATA.steps[number]));
    else DATA.steps.push(line);
}

const VERTEX = `#version 300 es
void main() {
vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
gl_Position = vec4(corner, 0.0, 1.0);
}`;
// Milliseconds that a draw may take: browsers end the page's drawing where one takes seconds.
const STRIP_MS = 30, PREVIEW_MS = 50;
const MOST_SAMPLES = 1 << 20;

const canvas = document.getElementById("picture");
let gl = null, filtered = true, parallel = null, programs = [], tables = [], films = {};

class Stale extends Error {}

function begin_gl() {
    gl = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false, preserveDrawingBuffer: true, powerPreference: "high-performance" });
    if (!gl) throw new Error("This browser has no WebGL 2, or it is switched off, and the picture is drawn with it.");
    if (!gl.getExtension("EXT_color_buffer_float"))
        throw new Error("This graphics driver cannot draw into textures of floats (EXT_color_buffer_float), in which the samples are summed.");
    filtered = !!gl.getExtension("OES_texture_float_linear") && filters_floats();
    parallel = gl.getExtension("KHR_parallel_shader_compile");
    gl.enable(gl.SCISSOR_TEST);
    programs = [], tables = [], films = {};
}

// Some drivers announce that they interpolate floats and do not.
function filters_floats() {
    const pair = texture(2, 1, gl.RGBA32F, gl.LINEAR, new Float32Array([0, 0, 0, 0, 1, 1, 1, 1]));
    const id = link(`#version 300 es
precision highp float;
uniform highp sampler2D pair;
layout(location = 0) out vec4 mean;
void main() { mean = texture(pair, vec2(0.5)); }`);
    const one = target(1, 1, 1, gl.RGBA32F, gl.NEAREST), mean = new Float32Array(4);
    if (!gl.getProgramParameter(id, gl.LINK_STATUS)) return false;
    gl.useProgram(id);
    gl.bindFramebuffer(gl.FRAMEBUFFER, one.framebuffer);
    gl.viewport(0, 0, 1, 1);
    gl.scissor(0, 0, 1, 1);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, pair);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, mean);
    return Math.abs(mean[0] - 0.5) < 0.01;
}

// ---- Textures and targets.
function texture(width, height, format, filter, texels = null) {
    const id = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, id);
    gl.texImage2D(gl.TEXTURE_2D, 0, format, width, height, 0, gl.RGBA, format === gl.RGBA16F && !texels ? gl.HALF_FLOAT : gl.FLOAT, texels);
    for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
    for (const way of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, way, filter);
    return id;
}

function target(width, height, count, format, filter) {
    const made = { width, height, textures: [], framebuffer: gl.createFramebuffer() }, outputs = [];
    for (let i = 0; i < count; i++) made.textures.push(texture(width, height, format, filter));
    gl.bindFramebuffer(gl.FRAMEBUFFER, made.framebuffer);
    for (let i = 0; i < count; i++) {
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, made.textures[i], 0);
        outputs.push(gl.COLOR_ATTACHMENT0 + i);
    }
    gl.drawBuffers(outputs);
    if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE)
        throw new Error(`This graphics driver cannot draw into ${count} float textures of ${width} x ${height}.`);
    return made;
}

// The same in halves, to the nearest: some drivers cut what is drawn into halves, and tables hold fourth roots, by which the error is four times as large.
function halved(exact, filter) {
    const id = link(`#version 300 es
precision highp float;
precision highp int;
uniform highp sampler2D one, other;
layout(location = 0) out vec4 first;
layout(location = 1) out vec4 second;
vec4 nearest(vec4 v) { return uintBitsToFloat((floatBitsToUint(v) + 0x1000u) & 0xffffe000u); }
void main() {
first = nearest(texelFetch(one, ivec2(gl_FragCoord.xy), 0));
second = nearest(texelFetch(other, ivec2(gl_FragCoord.xy), 0));
}`);
    const { width, height, textures } = exact, made = target(width, height, textures.length, gl.RGBA16F, filter);
    gl.useProgram(id);
    gl.uniform1i(gl.getUniformLocation(id, "other"), textures.length - 1);
    textures.forEach((texture, unit) => { gl.activeTexture(gl.TEXTURE0 + unit); gl.bindTexture(gl.TEXTURE_2D, texture); });
    gl.bindFramebuffer(gl.FRAMEBUFFER, made.framebuffer);
    gl.viewport(0, 0, width, height);
    gl.scissor(0, 0, width, height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.deleteProgram(id);
    drop(exact);
    return made;
}

function drop(made) {
    made.textures.forEach((id) => gl.deleteTexture(id));
    gl.deleteFramebuffer(made.framebuffer);
}

// ---- Programs.
function link(fragment) {
    const id = gl.createProgram();
    for (const [stage, text] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, fragment]]) {
        const shader = gl.createShader(stage);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        gl.attachShader(id, shader);
    }
    gl.linkProgram(id);
    return id;
}

const source = (number) => DATA.shaders[number].split(" ").map((piece) => DATA.pieces[piece]).join("");

function refuse(id) {
    if (gl.isContextLost()) throw new Stale();
    const [vertex, fragment] = gl.getAttachedShaders(id).sort((a) => (gl.getShaderParameter(a, gl.SHADER_TYPE) === gl.VERTEX_SHADER ? -1 : 1));
    const log = gl.getShaderInfoLog(fragment) || gl.getShaderInfoLog(vertex) || gl.getProgramInfoLog(id), [, line] = log.match(/^ERROR: 0:(\d+):/) || [];
    // The line itself says more than its number in a text that nobody sees.
    const text = line ? ` The line is: ${gl.getShaderSource(fragment).split("\n")[line - 1]}` : "";
    throw new Error(`This browser's compiler refuses a shader: ${log.slice(0, 400)}${text}`);
}

// Asking for the result would wait for it.
async function program(number) {
    if (programs[number]) return programs[number];
    const id = link(source(number)), made = { id, uniforms: [], samplers: [] };
    while (parallel && !gl.getProgramParameter(id, parallel.COMPLETION_STATUS_KHR)) await pause();
    if (!gl.getProgramParameter(id, gl.LINK_STATUS)) refuse(id);
    gl.useProgram(id);
    for (let i = 0; i < gl.getProgramParameter(id, gl.ACTIVE_UNIFORMS); i++) {
        const { name, type, size } = gl.getActiveUniform(id, i), place = gl.getUniformLocation(id, name);
        const uniform = { name: name.replace(/\[0\]$/, ""), type, size, place };
        if (type !== gl.SAMPLER_2D) made.uniforms.push(uniform);
        else gl.uniform1i(place, made.samplers.push(uniform) - 1);
    }
    return (programs[number] = made);
}

// The elements of an array may have values of their own.
function value_of({ name, size }, values) {
    const parts = Array.from({ length: size }, (_, i) => values[`${name}[${i}]`]);
    return values[name] || (parts.every(Boolean) && parts.flat());
}

function set(made, values) {
    for (const uniform of made.uniforms) {
        const { name, type, size, place } = uniform, value = value_of(uniform, values);
        if (!value) throw new Error(`The page has no value of ${name}.`);
        if (type === gl.FLOAT) gl.uniform1fv(place, value.slice(0, size));
        else if (type === gl.FLOAT_VEC3) gl.uniform3fv(place, value);
        else if (type === gl.FLOAT_VEC4) gl.uniform4fv(place, value);
        else if (type === gl.UNSIGNED_INT) gl.uniform1ui(place, value[0]);
        else gl.uniform1i(place, value[0]);
    }
}

function give(made, textures) {
    made.samplers.forEach(({ name }, unit) => {
        if (!textures[name]) throw new Error(`The page has no texture ${name}.`);
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, textures[name]);
    });
}

// ---- Draws.
// Lets the browser do other things.
const pause = () => new Promise((go) => setTimeout(go, 0));

// Waits for the draws without blocking the page.
async function finished() {
    const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    for (;;) {
        if (gl.isContextLost()) throw new Stale();
        const status = gl.clientWaitSync(sync, 0, 0);
        if (status === gl.ALREADY_SIGNALED || status === gl.CONDITION_SATISFIED) break;
        await pause();
    }
    gl.deleteSync(sync);
}

// Draws into a rectangle of a target, all of it if none is given, in strips of rows. `pace` keeps how many pixels a millisecond takes, and `stale` says whether the rest is still wanted.
async function draw(made, values, textures, into, pace, stale = () => false, [left, top, width, height] = [0, 0, into.width, into.height]) {
    for (let row = 0; row < height;) {
        const rows = Math.max(1, Math.min(height - row, Math.round((STRIP_MS * pace.speed) / width))), begin = performance.now();
        gl.useProgram(made.id);
        set(made, values);
        give(made, textures);
        gl.bindFramebuffer(gl.FRAMEBUFFER, into.framebuffer);
        gl.viewport(0, 0, into.width, into.height);
        gl.scissor(left, top + row, width, rows);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        await finished();
        pace.speed = Math.min(2 * pace.speed, (rows * width) / Math.max(performance.now() - begin, 0.05));
        row += rows;
        if (row < height && stale()) throw new Stale();
    }
}

// ---- What follows from the sun, the camera and the sliders.
const RADIANS = Math.PI / 180;
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (v, length) => v.map((x) => (x * length) / Math.hypot(...v));
const minus = (a, b) => a.map((x, i) => x - b[i]);
const clamp = (x, low, high) => Math.min(Math.max(x, low), high);

function direction_of(elevation, azimuth) {
    const level = [Math.sin(azimuth * RADIANS), 0, Math.cos(azimuth * RADIANS)], c = Math.cos(elevation * RADIANS);
    return { level, direction: [c * level[0], Math.sin(elevation * RADIANS), c * level[2]] };
}

function camera_of(state, width, height) {
    const half = Math.tan((state.fov * RADIANS) / 2), forward = scaled(minus(state.target, state.eye), 1);
    const over = Math.abs(forward[1]) > 1 - 1e-12 ? [0, 0, 1] : [0, 1, 0];
    const right = scaled(cross(forward, over), (half * width) / height);
    return { forward, right, up: scaled(cross(right, forward), half) };
}

function computed(state, air, width, height) {
    const [elevation, azimuth] = state.sun, { level, direction } = direction_of(elevation, azimuth), camera = camera_of(state, width, height);
    const values = {
        sun_direction: direction, sun_level: level, sun_disk_middle: direction,
        camera_eye: state.eye, camera_forward: camera.forward, camera_right: camera.right, camera_up: camera.up,
        picture_size: [width, height, 0], iResolution: [width, height, 1], iTime: [state.time], iMouse: [0, 0, 0, 0], iFrame: [0],
        seed: [DATA.seed], film_first: [0], film_zero: [0], ...state.values,
    };
    const sine = (degrees) => Math.sin(clamp(degrees, -90, 90) * RADIANS), high = sine(elevation + air.radius), low = Math.max(sine(elevation - air.radius), air.horizon);
    // A point well inside of the visible disk.
    const lift = Math.tan(Math.max((Math.asin(low) / RADIANS + Math.min(elevation + air.radius, 90)) / 2 - elevation, 0) * RADIANS), { level: across } = direction_of(0, azimuth + 90);
    const up = cross(direction, across), heart = direction.map((x, i) => x + lift * up[i]), rim = [];
    for (let angle = 0; angle < 360; angle += 6) {
        const [c, s] = [Math.cos(angle * RADIANS), Math.sin(angle * RADIANS)], out = Math.tan(1.01 * air.radius * RADIANS);
        rim.push(project(camera, direction.map((x, i) => x + out * (c * up[i] + s * across[i])), width, height));
    }
    const forward = Number(state.values[air.forward] || air.forward), spheres = Math.trunc(Number(state.values[air.spheres] || air.spheres));
    values.fill_count = [spheres];
    values.scattered_forward = [forward];
    values.scattered_share = [clamp((0.75 - Math.abs(forward)) / 0.1, 0, 1)];
    values.sun_disk_heights = [low, high, 0];
    values.sun_image_heart = project(camera, heart, width, height) || [-1, -1, 0];
    // Where the disk is in the picture: all of it where a part of the disk is behind the camera and a part is not.
    const ahead = rim.filter(Boolean), edge = (axis, pick, most) => clamp(pick(...ahead.map((at) => at[axis])), 0, most);
    const whole = ahead.length === rim.length, left = whole ? Math.floor(edge(0, Math.min, width)) : 0, top = whole ? Math.floor(edge(1, Math.min, height)) : 0;
    const size = [(whole ? Math.ceil(edge(0, Math.max, width)) : width) - left, (whole ? Math.ceil(edge(1, Math.max, height)) : height) - top];
    values.disk = ahead.length && high > low && size[0] > 0 && size[1] > 0 ? [left, top, ...size] : null;
    values.sun_image_corner = values.disk && whole ? [left, top, 0] : [-9, 0, 0];
    values.sizes = { cover: values.disk && whole ? size : [1, 1], spheres: [1024, Math.max(Math.ceil(spheres / 1024), 1)] };
    return values;
}

// In pixels; null behind the camera.
function project(camera, direction, width, height) {
    const ahead = dot(direction, camera.forward), along = (axis) => dot(direction, axis) / dot(axis, axis) / ahead;
    return ahead > 0 ? [((1 + along(camera.right)) / 2) * width, ((1 - along(camera.up)) / 2) * height, 0] : null;
}

// The variant that draws a state: its switches choose among those of the preset.
function variant_of(state) {
    const preset = DATA.states.find((other) => other.state === state.preset);
    let setting = 0;
    preset.switches.split(" ").filter(Boolean).forEach((name, bit) => { setting |= (state.values[name][0] ? 1 : 0) << bit; });
    if (preset.variants[setting] < 0) throw new Error(preset.why);
    return DATA.variants[preset.variants[setting]];
}

// ---- Tables.
let fills = 0;

async function fill(step, values, textures, made, stale) {
    const serials = step.inputs.split(" ").filter(Boolean).map((place) => made[place].serial);
    const drawn = "draws" in step && (await program(step.draws));
    const key = JSON.stringify([step.table, step.draws, values.size, step.sized && values.sizes[step.sized], serials, drawn && drawn.uniforms.map((uniform) => value_of(uniform, values))]);
    let table = tables[step.place];
    if (!table || table.key !== key) {
        const [width, height] = step.sized ? values.sizes[step.sized] : values.size, samplers = step.samplers.split(" "), half = step.linear && !filtered;
        const count = samplers.length > 1 && samplers[1] ? 2 : 1, filter = step.linear ? gl.LINEAR : gl.NEAREST;
        const again = drawn && !half && table && table.draws === step.draws && table.width === width && table.height === height;
        if (table && !again) drop(table);
        tables[step.place] = null;
        if (drawn) {
            if (!again) table = Object.assign(target(width, height, count, gl.RGBA32F, half ? gl.NEAREST : filter), { draws: step.draws });
            // If drawing is given up, the textures serve the next time.
            table.key = "";
            tables[step.place] = table;
            const reads = { ...textures };
            for (const read of step.reads.split(" ").filter(Boolean)) {
                const [name, place, output] = read.split(/[=.]/);
                reads[name] = made[place].textures[output];
            }
            await draw(drawn, values, reads, table, step.pace ??= { speed: 20 }, stale);
            if (half) table = halved(table, filter);
        } else {
            table = MAKERS[step.maker](step.inputs.split(" ").map((place) => made[place]), values);
        }
        table.key = key;
        table.serial = ++fills;
        tables[step.place] = table;
    }
    made[step.place] = table;
    Object.assign(values, table.values);
    step.samplers.split(" ").forEach((name, i) => { if (name) textures[name] = table.textures[i]; });
}

// As src/sky/sky_sampler.c: bins of equal probability over the sky's patches, along Hilbert's curve above the horizon.
const MAKERS = { sky_sampler };
function sky_sampler([patches], values) {
    const [columns, above, below] = values.patch_count, cells = columns * (above + below), bins = 256 * 128;
    const light = new Float32Array(4 * cells), toward = new Float32Array(4 * cells);
    gl.bindFramebuffer(gl.FRAMEBUFFER, patches.framebuffer);
    for (const [i, into] of [light, toward].entries()) {
        gl.readBuffer(gl.COLOR_ATTACHMENT0 + i);
        gl.readPixels(0, 0, columns, above + below, gl.RGBA, gl.FLOAT, into);
    }
    gl.readBuffer(gl.COLOR_ATTACHMENT0);
    const weights = new Float64Array(cells), order = Array.from({ length: cells }, (_, place) => (place < columns * above ? hilbert(columns, place) : place));
    let total = 0, sum = 0, wanted = 0;
    for (let i = 0; i < cells; i++) {
        const luminance = 0.2126 * light[4 * i] + 0.7152 * light[4 * i + 1] + 0.0722 * light[4 * i + 2];
        total += weights[i] = toward[4 * i + 1] > 0 ? Math.max(luminance, 0) : 0;
    }
    for (let i = 0; i < cells; i++) {
        if (toward[4 * i + 1] > 0) weights[i] += ((total > 0 ? 0.01 * total : 1) * light[4 * i + 3]) / (2 * Math.PI);
        if (weights[i] > 0) wanted++;
    }
    // In the order of src/sky/sky_sampler.c, so that the same bins come of it.
    for (const cell of order) sum += weights[cell];
    const table = new Float32Array(4 * bins), shares = new Float32Array(4 * cells);
    let passed = 0, given = 0, first = 0;
    for (const cell of order) {
        passed += weights[cell];
        const upto = Math.round((passed / sum) * (bins - wanted)), count = weights[cell] > 0 ? 1 + upto - given : 0;
        given = upto;
        for (let k = first; k < first + count; k++) table.set([cell, first, count, 0], 4 * k);
        shares.fill(count / bins, 4 * cell, 4 * cell + 4);
        first += count;
    }
    return { textures: [texture(256, 128, gl.RGBA32F, gl.NEAREST, table), texture(columns, above + below, gl.RGBA32F, gl.NEAREST, shares)], framebuffer: null };
}

function hilbert(side, place) {
    let x = 0, y = 0;
    for (let s = 1; s < side; s *= 2, place = place >> 2) {
        const rx = 1 & (place >> 1), ry = 1 & (place ^ rx);
        if (!ry) {
            if (rx) (x = s - 1 - x), (y = s - 1 - y);
            [x, y] = [y, x];
        }
        (x += s * rx), (y += s * ry);
    }
    return y * side + x;
}

// ---- Pictures.
// The film of a size: the sums of samples, read on one side and written on the other.
function film_of(width, height, kind) {
    let film = films[kind];
    if (film && (film.sides[0].width !== width || film.sides[0].height !== height)) film.sides.forEach(drop), (film = null);
    film ??= { sides: [0, 1].map(() => target(width, height, 2, gl.RGBA32F, gl.NEAREST)), front: 0, samples: 0 };
    return (films[kind] = film);
}

function empty(film) {
    gl.bindFramebuffer(gl.FRAMEBUFFER, film.sides[film.front].framebuffer);
    gl.scissor(0, 0, film.sides[0].width, film.sides[0].height);
    for (const output of [0, 1]) gl.clearBufferfv(gl.COLOR, output, [0, 0, 0, 0]);
    film.samples = 0;
}

// A picture is begun: its tables are filled and its film is empty. `shrink` is by how much a preview is smaller.
async function begin_picture(state, width, height, shrink, stale) {
    const variant = variant_of(state), air = variant[0], coarse = shrink > 1;
    const w = Math.max(1, Math.round(width / shrink)), h = Math.max(1, Math.round(height / shrink));
    const picture = { values: computed(state, air, w, h), textures: {}, step: null, group: 1, state, coarse }, made = {};
    for (const step of variant) {
        if ("uniform" in step) {
            if ((step.from ?? -90) <= state.sun[0] && (coarse || !step.coarse)) picture.values[step.uniform] = step.values;
        } else if (step.table === "film") {
            picture.step = step;
        } else if ("table" in step) {
            await fill(step, picture.values, picture.textures, made, stale);
        }
    }
    picture.program = await program(picture.step.draws);
    picture.pace = picture.step.pace ??= { speed: 20 };
    picture.film = film_of(w, h, coarse ? "preview" : "picture");
    if ("image" in picture.step) await begin_image(picture, w, h);
    empty(picture.film);
    return picture;
}

// The sun's own image is drawn by itself before each group, where it may be: in the disk's rectangle, or anywhere if there are mirrors.
async function begin_image(picture, width, height) {
    const where = picture.step.mirrors ? [0, 0, width, height] : picture.values.disk, [w, h] = where ? [width, height] : [1, 1];
    const image = (films.image ??= { width: 0 });
    if (image.width !== w || image.height !== h) {
        if (image.width) drop(image);
        Object.assign(image, target(w, h, 1, gl.RGBA32F, gl.NEAREST));
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, image.framebuffer);
    gl.scissor(0, 0, w, h);
    gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
    picture.image = where && { program: await program(picture.step.image), into: image, where, pace: (picture.step.image_pace ??= { speed: 5 }) };
    picture.textures.sun_image_sums = image.textures[0];
}

// Adds a group of samples to each pixel.
async function add_samples(picture, group, stale) {
    const film = picture.film, front = film.sides[film.front], back = film.sides[1 - film.front], { values, textures } = picture;
    values.group_samples = [group];
    values.iFrame = [Math.floor(film.samples / picture.step.group)];
    textures.film_sum = front.textures[0];
    textures.film_rest = front.textures[1];
    if (picture.image) await draw(picture.image.program, values, textures, picture.image.into, picture.image.pace, stale, picture.image.where);
    picture.pace.speed /= group;
    try {
        await draw(picture.program, values, textures, back, picture.pace, stale);
    } finally {
        picture.pace.speed *= group;
    }
    film.front = 1 - film.front;
    film.samples += group;
}

async function show(picture, exposure) {
    const side = picture.film.sides[picture.film.front], same = side.width === canvas.width && side.height === canvas.height;
    const made = await program(DATA.shows[same ? "same" : "enlarged"]);
    gl.useProgram(made.id);
    set(made, { window_size: [canvas.width, canvas.height, 0], gain: [2 ** exposure] });
    give(made, { film_a: side.textures[0] });
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.scissor(0, 0, canvas.width, canvas.height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
}

// The means: four floats a pixel, the top row first.
function pixels_of(picture) {
    const side = picture.film.sides[picture.film.front], { width, height } = side;
    const sum = new Float32Array(4 * width * height), rest = new Float32Array(4 * width * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, side.framebuffer);
    for (const [i, into] of [sum, rest].entries()) {
        gl.readBuffer(gl.COLOR_ATTACHMENT0 + i);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, into);
    }
    gl.readBuffer(gl.COLOR_ATTACHMENT0);
    for (let i = 0; i < sum.length; i++) {
        const samples = sum[i | 3] || 1;
        if (i % 4 < 3) sum[i] = (sum[i] + rest[i]) / samples;
    }
    for (let i = 3; i < sum.length; i += 4) sum[i] = sum[i] > 0 ? 1 : 0;
    return { width, height, rgba: sum };
}

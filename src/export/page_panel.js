// The page: its state, what changes it, and the loop that draws it.
const by_id = (id) => document.getElementById(id);
const size = [DATA.width, DATA.height];
let state = state_of(""), version = 0, moved_ms = -Infinity, paused = false, limit = MOST_SAMPLES, previews = true;
let picture = null, shown = 0, rate = 0, frames = 0, trouble = "";
// A call of wake() during a draw is kept for the next wait, so that none is lost.
let woken = false, stop_waiting = () => {};
const wake = () => { woken = true; stop_waiting(); };
async function to_be_woken() {
    if (!woken) await new Promise((go) => { stop_waiting = go; });
    woken = false;
}

function state_of(name) {
    const preset = DATA.states.find((other) => other.state === name);
    if (!preset) throw new Error(`no preset "${name}"`);
    const { sun, eye, target, fov, exposure, time, values } = structuredClone(preset);
    return { preset: name, sun, eye, target, fov, exposure, time, values };
}

// ---- Settings by name: presets, the link, the controls and the tests all go this way. Returns what is wrong, or "".
const numbers_of = (text) => text.split(",").map((word) => (word.trim() === "" ? NaN : Number(word)));
const SETTINGS = {
    sun: { get: () => state.sun, low: [-90, -360], high: [90, 360] },
    "camera.eye": { get: () => state.eye, low: [-1e6, -1e6, -1e6], high: [1e6, 1e6, 1e6] },
    "camera.target": { get: () => state.target, low: [-1e6, -1e6, -1e6], high: [1e6, 1e6, 1e6] },
    "camera.fov": { get: () => [state.fov], put: (v) => { state.fov = v[0]; }, low: [1], high: [170] },
    exposure: { get: () => [state.exposure], put: (v) => { state.exposure = v[0]; }, low: [-30], high: [30], light: true },
    size: { get: () => size, low: [1, 1], high: [4096, 4096] },
};
for (const { parameter, type, min, max } of DATA.parameters) {
    const count = type === "color" ? 3 : 1, [low, high] = type === "slider" ? [min, max] : [0, 1];
    SETTINGS[parameter] = { get: () => state.values[parameter], low: Array(count).fill(low), high: Array(count).fill(high) };
}

function assign(name, text, moving = false) {
    if (name === "preset") {
        if (!DATA.states.some((other) => other.state === text)) return `There is no preset "${text}".`;
        state = state_of(text);
    } else {
        const setting = SETTINGS[name], numbers = numbers_of(text === "on" ? "1" : text === "off" ? "0" : text);
        if (!setting) return `There is no setting "${name}".`;
        const good = numbers.length === setting.low.length && numbers.every((x, i) => x >= setting.low[i] && x <= setting.high[i]);
        if (!good) return `${name} takes ${setting.low.map((low, i) => `${low} to ${setting.high[i]}`).join(", ")}, not "${text}".`;
        if (setting.put) setting.put(numbers);
        else setting.get().splice(0, 3, ...numbers);
        if (setting.light) return refresh(), (wake(), "");
    }
    if (moving) moved_ms = performance.now();
    version++;
    refresh();
    wake();
    return "";
}

const put = (name, numbers, moving = true) => say(assign(name, numbers.map((x) => String(+x.toPrecision(9))).join(","), moving));
const same = (a, b) => a.length === b.length && a.every((x, i) => x === b[i]);

// What differs from the preset, as [name, text].
function differences() {
    const now = state, list = [];
    const texts = Object.fromEntries(Object.entries(SETTINGS).map(([name, { get }]) => [name, [...get()]]));
    state = state_of(now.preset);
    for (const [name, { get }] of Object.entries(SETTINGS)) if (name !== "size" && !same(get(), texts[name])) list.push([name, texts[name].join(",")]);
    state = now;
    return list;
}

function link_text() {
    const parts = state.preset ? [["preset", state.preset]] : [];
    if (size[0] !== DATA.width || size[1] !== DATA.height) parts.push(["size", size.join(",")]);
    return "#" + [...parts, ...differences()].map(([name, text]) => `${encodeURIComponent(name)}=${encodeURIComponent(text).replaceAll("%2C", ",")}`).join("&");
}

function read_link() {
    const troubles = [];
    for (const part of location.hash.slice(1).split("&").filter(Boolean)) {
        const [name, text = ""] = part.split("=").map((word) => { try { return decodeURIComponent(word); } catch { return word; } });
        troubles.push(assign(name, text));
    }
    say(troubles.filter(Boolean).join(" "));
}

const quoted = (word) => (/^[\w.,:=+/-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);
function command_text() {
    const words = [DATA.command];
    if (state.preset) words.push("--preset", quoted(state.preset));
    words.push("--sun", state.sun.join(","));
    for (const [name, text] of differences()) if (name !== "sun") words.push("--set", quoted(`${name}=${text}`));
    const samples = picture && !picture.coarse ? Math.max(picture.film.samples, 1) : 1;
    return `${words.join(" ")} --size ${size.join("x")} --spp ${samples}${DATA.methods} -o picture.png`;
}

// ---- The panel.
function say(text) {
    trouble = text;
    by_id("trouble").textContent = text;
    by_id("trouble").hidden = !text;
}

const srgb = (v) => (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);
const linear = (v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
const hex = (color) => "#" + color.map((v) => Math.round(255 * srgb(clamp(v, 0, 1))).toString(16).padStart(2, "0")).join("");
const controls = {};

function add_parameter({ parameter, type, label, unit, min, max }) {
    const row = document.createElement("p"), words = document.createElement("label"), inputs = [];
    words.textContent = (label || parameter) + (unit ? `, ${unit}` : "");
    words.htmlFor = `set-${parameter}`;
    const input = (kind, more = {}) => inputs[inputs.push(Object.assign(document.createElement("input"), { type: kind, name: parameter, ...more })) - 1];
    if (type === "checkbox") {
        const box = input("checkbox", { id: words.htmlFor });
        row.className = "check";
        row.append(box, words);
        box.oninput = () => put(parameter, [box.checked ? 1 : 0]);
        controls[parameter] = ([value]) => { box.checked = value > 0; };
    } else if (type === "color") {
        const box = input("color", { id: words.htmlFor });
        row.append(words, box);
        box.oninput = () => put(parameter, [1, 3, 5].map((at) => linear(parseInt(box.value.slice(at, at + 2), 16) / 255)));
        controls[parameter] = (color) => { if (box.value !== hex(color)) box.value = hex(color); };
    } else {
        const range = input("range", { id: words.htmlFor, min, max, step: "any" }), box = input("number", { min, max, step: "any" });
        box.setAttribute("aria-label", `${words.textContent}, typed`);
        row.append(words, range, box);
        range.oninput = () => put(parameter, [Number(Number(range.value).toPrecision(4))]);
        range.onkeydown = (event) => {
            const way = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
            if (!way) return;
            event.preventDefault();
            put(parameter, [clamp(+(state.values[parameter][0] + (way * (max - min)) / (event.shiftKey ? 1000 : 100)).toPrecision(6), min, max)]);
        };
        box.onchange = () => { say(assign(parameter, box.value)); refresh(); };
        controls[parameter] = ([value]) => { range.value = value; if (document.activeElement !== box) box.value = +value.toPrecision(6); };
    }
    by_id("parameters").append(row);
}

// The disc's middle is the zenith, its ring the horizon, and up is where the camera looks.
const view_azimuth = () => Math.atan2(state.target[0] - state.eye[0], state.target[2] - state.eye[2]) / RADIANS;
function place_knob() {
    const turn = (state.sun[1] - view_azimuth()) * RADIANS, from = clamp((90 - state.sun[0]) / 90, 0, 1.16) * 50;
    by_id("knob").setAttribute("cx", -from * Math.sin(turn));
    by_id("knob").setAttribute("cy", -from * Math.cos(turn));
}

function drag_disc(event) {
    const box = by_id("disc").getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width - 0.5) * 120, y = ((event.clientY - box.top) / box.height - 0.5) * 120;
    const azimuth = Math.atan2(-x, -y) / RADIANS + view_azimuth();
    put("sun", [clamp(90 - (Math.hypot(x, y) / 50) * 90, -14, 90), +(azimuth - 360 * Math.round(azimuth / 360)).toFixed(2)].map((v) => +v.toFixed(2)));
}

const turn_sun = (up, right) => put("sun", [clamp(state.sun[0] + up, -90, 90), state.sun[1] - right - 360 * Math.round((state.sun[1] - right) / 360)]);

function orbit(right, up) {
    const arm = minus(state.eye, state.target), length = Math.hypot(...arm);
    const azimuth = Math.atan2(arm[0], arm[2]) / RADIANS - right, elevation = clamp(Math.asin(clamp(arm[1] / length, -1, 1)) / RADIANS - up, -89.5, 89.5);
    const { direction } = direction_of(elevation, azimuth);
    put("camera.eye", state.target.map((x, i) => x + length * direction[i]));
}

function zoom(factor) {
    const arm = minus(state.eye, state.target), wanted = clamp(Math.hypot(...arm) * factor, 1e-3, 1e5);
    put("camera.eye", state.target.map((x, i) => x + scaled(arm, wanted)[i]));
}

function refresh() {
    for (const [name, show_value] of Object.entries(controls)) show_value(state.values[name]);
    for (const [id, at] of [["elevation", 0], ["azimuth", 1]]) if (document.activeElement !== by_id(id)) by_id(id).value = +state.sun[at].toFixed(3);
    by_id("preset").value = state.preset;
    by_id("exposure").value = state.exposure;
    by_id("stops").textContent = `${state.exposure.toFixed(1)} EV`;
    place_knob();
}

async function save(kind) {
    let bytes;
    if (kind === "png") {
        await show(picture, state.exposure);
        bytes = await new Promise((done) => canvas.toBlob(done, "image/png"));
    } else {
        const { width, height, rgba } = pixels_of(picture), rgb = new Float32Array(3 * width * height);
        for (let y = 0; y < height; y++)
            for (let x = 0; x < width; x++) for (let c = 0; c < 3; c++) rgb[3 * ((height - 1 - y) * width + x) + c] = rgba[4 * (y * width + x) + c];
        bytes = new Blob([`PF\n${width} ${height}\n-1.0\n`, rgb]);
    }
    return bytes;
}

async function download(kind) {
    const a = document.createElement("a"), name = (DATA.title || "picture").toLowerCase().replace(/[^a-z0-9]+/g, "-");
    a.href = URL.createObjectURL(await save(kind));
    a.download = `${name}.${kind}`;
    a.click();
    setTimeout(() => URL.revokeObjectURL(a.href), 1e4);
}

const pointers = new Map();
canvas.onpointerdown = (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY, sun: event.button === 2 || event.shiftKey });
};
canvas.onpointermove = (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const box = canvas.getBoundingClientRect(), right = (event.clientX - last.x) / box.height, up = (last.y - event.clientY) / box.height;
    const other = [...pointers.values()].find((one) => one !== last), apart = other && Math.hypot(last.x - other.x, last.y - other.y);
    last.x = event.clientX, last.y = event.clientY;
    if (other) zoom(clamp(apart / Math.max(Math.hypot(last.x - other.x, last.y - other.y), 1), 0.5, 2));
    else if (last.sun) turn_sun(up * Math.min(state.fov, 90), right * Math.min(state.fov, 90));
    else orbit(right * 180, up * 180);
};
canvas.onpointerup = canvas.onpointercancel = (event) => pointers.delete(event.pointerId);
canvas.oncontextmenu = (event) => event.preventDefault();
canvas.addEventListener("wheel", (event) => { event.preventDefault(); zoom(0.9 ** clamp(-event.deltaY / 100, -3, 3)); }, { passive: false });
canvas.onkeydown = (event) => {
    const step = event.shiftKey ? 0.1 : 1, key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const act = {
        ArrowUp: () => turn_sun(step, 0), ArrowDown: () => turn_sun(-step, 0), ArrowLeft: () => turn_sun(0, -step), ArrowRight: () => turn_sun(0, step),
        a: () => orbit(-5, 0), d: () => orbit(5, 0), w: () => orbit(0, -5), s: () => orbit(0, 5), e: () => zoom(0.9), q: () => zoom(1 / 0.9),
        "-": () => put("exposure", [state.exposure - 0.25]), "=": () => put("exposure", [state.exposure + 0.25]),
        r: () => by_id("camera").click(), " ": () => by_id("pause").click(), p: () => by_id("png").click(),
    }[key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act();
};
by_id("disc").onpointerdown = (event) => { by_id("disc").setPointerCapture(event.pointerId); drag_disc(event); };
by_id("disc").onpointermove = (event) => { if (event.buttons) drag_disc(event); };
for (const id of ["elevation", "azimuth"])
    by_id(id).onchange = () => { say(assign("sun", [by_id("elevation").value, by_id("azimuth").value].join(","))); refresh(); };
by_id("exposure").oninput = () => put("exposure", [Number(by_id("exposure").value)]);
by_id("preset").oninput = () => say(assign("preset", by_id("preset").value));
by_id("pause").onclick = () => { paused = !paused; by_id("pause").setAttribute("aria-pressed", paused); wake(); };
by_id("camera").onclick = () => { const own = state_of(state.preset); Object.assign(state, { eye: own.eye, target: own.target, fov: own.fov }); version++; refresh(); wake(); };
by_id("png").onclick = () => download("png");
by_id("pfm").onclick = () => download("pfm");
by_id("link").onclick = async () => {
    history.replaceState(null, "", link_text());
    await navigator.clipboard?.writeText(location.href).catch(() => {});
    by_id("message").textContent = "The link is in the address bar.";
};
by_id("panel").onsubmit = (event) => event.preventDefault();

// ---- The loop.
function tell() {
    const samples = picture.film.samples, words = [picture.coarse ? "preview" : `${samples} sample${samples > 1 ? "s" : ""} a pixel`];
    if (rate) words.push(`${(rate / 1e6).toPrecision(2)} million paths a second`);
    by_id("figures").textContent = words.join(", ") + (paused ? ", paused" : "");
    by_id("command").value = command_text();
}

// Says so while the browser compiles, which it may put off until the first draw.
async function patiently(work) {
    const begin = performance.now();
    const timer = setInterval(() => { by_id("message").textContent = `Compiling the shaders: ${Math.round((performance.now() - begin) / 1000)} s`; }, 250);
    try {
        return await work();
    } finally {
        clearInterval(timer);
        by_id("message").textContent = "";
    }
}

function fit_canvas() {
    if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
    canvas.style.setProperty("--ratio", size[0] / size[1]);
}

async function draw_next() {
    if (lost) throw new Stale();
    const now = performance.now(), stale = () => version !== shown;
    if (!picture || version !== shown || (picture.coarse && now - moved_ms > 200)) {
        const first = !picture, moving = previews && (first || (version !== shown && now - moved_ms < 200)), speed = picture ? picture.pace.speed : 2000;
        const shrink = moving ? clamp(Math.ceil(Math.sqrt((size[0] * size[1]) / (speed * PREVIEW_MS))), 2, 8) : 1;
        shown = version;
        fit_canvas();
        picture = await begin_picture(structuredClone(state), ...size, shrink, moving ? () => false : stale);
        rate = 0;
    }
    if (picture.film.samples >= (picture.coarse ? 1 : limit) || (paused && picture.film.samples)) {
        await show(picture, state.exposure);
        if (!picture.coarse || paused) await to_be_woken();
        else await pause();
        return;
    }
    const group = Math.min(picture.group, limit - picture.film.samples), begin = performance.now();
    await add_samples(picture, group, picture.coarse ? () => false : stale);
    const taken = performance.now() - begin, { width, height } = picture.film.sides[0];
    rate = (1000 * group * width * height) / taken;
    if (taken < 60) picture.group = Math.min(2 * picture.group, picture.step.group);
    await show(picture, state.exposure);
    frames++;
    tell();
}

// After the context was lost nothing that was made in it is left, and all begins anew when there is another.
let lost = false;
async function run() {
    for (;;) {
        try {
            lost = false;
            begin_gl();
            refresh();
            const go_on = () => draw_next().catch((error) => { if (!(error instanceof Stale) || lost || gl.isContextLost()) throw error; });
            await patiently(async () => { while (!picture || !picture.film.samples) await go_on(); });
            for (;;) await go_on();
        } catch (error) {
            picture = null;
            const gone = gl && gl.isContextLost();
            if (!gone && !lost) say(error.message);
            if (gone || !lost) await to_be_woken();
            if (gl && !gl.isContextLost() && trouble === error.message) say("");
        }
    }
}

canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    lost = true;
    say("The graphics driver has stopped drawing this page. It goes on as soon as the driver allows it; else reload the page.");
    wake();
});
canvas.addEventListener("webglcontextrestored", () => { say(""); wake(); });

DATA.states.forEach(({ state: name }) => by_id("preset").append(new Option(name || "as the scene has it", name)));
by_id("presets-row").hidden = DATA.states.length < 2;
by_id("parameters").hidden = !DATA.parameters.length;
DATA.parameters.forEach(add_parameter);
canvas.setAttribute("aria-label", `${DATA.title}, drawn by path tracing`);
read_link();
fit_canvas();
window.onhashchange = read_link;
run();

// For tests: exactly so many samples of a picture at rest.
window.magichour = {
    assign, save, link_text, command_text,
    get state() { return state; },
    get figures() { return { samples: picture ? picture.film.samples : 0, coarse: !!picture && picture.coarse, frames, rate, trouble }; },
    pixels: () => pixels_of(picture),
    async render(samples) {
        previews = false, limit = samples, version++;
        wake();
        while (!trouble && !(picture && shown === version && !picture.coarse && picture.film.samples === samples)) await pause();
        if (trouble) throw new Error(trouble);
    },
    async rest() { (previews = true), (limit = MOST_SAMPLES); wake(); },
};

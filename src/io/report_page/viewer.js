"use strict";
// The report: tables from the data, and the grid in space. Plain JavaScript and WebGL 2, no library.
(() => {
const data = JSON.parse(document.getElementById("data").textContent);
const quality = data.quality;
const element = id => document.getElementById(id);
const axisName = axis => "ijk"[axis];

// --- Text and tables -------------------------------------------------------------------------

function make(tag, text, attributes = {}) {
  const node = document.createElement(tag);
  if (text !== undefined) node.textContent = text;
  Object.assign(node, attributes);
  return node;
}

/** A number in few digits; "-" where there is none. */
function short(value, digits = 4) {
  if (value === null || value === undefined) return "-";
  const size = Math.abs(value);
  return size !== 0 && (size < 1e-3 || size >= 1e6) ? value.toExponential(2)
                                                    : String(+value.toPrecision(digits));
}

const whole = value => Number(value).toLocaleString("en");
const point = p => p ? `(${p.map(value => short(value, 6)).join(", ")})` : "-";
const index = list => `(${list.join(", ")})`;

/** Fills a table; rows are lists of texts, `text` the columns that are words. */
function fill(id, heads, rows, text = [0]) {
  const table = element(id);
  table.append(make("tr"));
  heads.forEach(head => table.rows[0].append(make("th", head, {scope: "col"})));
  for (const cells of rows) {
    const row = table.insertRow();
    cells.forEach((cell, column) => {
      const item = row.insertCell();
      item.textContent = cell;
      if (text.includes(column)) item.className = "text";
    });
  }
  return [...table.rows].slice(1);
}

function tellSummary() {
  const verdict = element("verdict");
  const missed = data.run ? data.run.gates.filter(gate => !gate.met).length : 0;
  const sound = quality.sound && missed === 0;
  verdict.className = sound ? "good" : "bad";
  const faults = [];
  if (quality.folded) faults.push(`${whole(quality.folded)} cells folded`);
  if (quality.not_positive) faults.push(`${whole(quality.not_positive)} cells with a Jacobian that is not positive somewhere`);
  const mismatched = quality.interfaces.reduce((sum, item) => sum + item.mismatched, 0);
  if (mismatched) faults.push(`${whole(mismatched)} interface nodes differ on the two sides`);
  if (missed) faults.push(`${missed} of ${data.run.gates.length} gates missed`);
  verdict.textContent = sound ? "Sound: no cell folded, every interface the same on both sides"
                                + (data.run && data.run.gates.length ? ", every gate met." : ".")
                              : `Not sound: ${faults.join("; ")}.`;
  const worst = Math.min(...quality.zones.map(zone => zone.worst_scaled_jacobian));
  const growth = Math.max(1, ...quality.zones.flatMap(zone => zone.growth.map(along => along.ratio)),
                          ...quality.interfaces.map(item => item.growth.ratio));
  const angles = quality.zones.map(zone => zone.angles);
  const facts = [
    ["cells", whole(quality.cells)], ["zones", quality.zones.length],
    ["interfaces", quality.interfaces.length], ["worst scaled Jacobian", short(worst)],
    ["angles", `${short(Math.min(...angles.map(a => a.least)))} to ${short(Math.max(...angles.map(a => a.greatest)))} degrees`],
    ["greatest growth", short(growth, 3)],
    ["greatest skewness", short(Math.max(...quality.zones.map(zone => zone.greatest_skewness.value)))],
    ["greatest aspect ratio", short(Math.max(...quality.zones.map(zone => zone.greatest_aspect_ratio.value)))],
    ["Jacobian proven positive in", `${whole(quality.cells - quality.not_positive - quality.undecided)} cells`],
    ["file", quality.grid], ["units", quality.units || "not said"]];
  for (const [name, value] of facts) {
    const item = make("li", name + " ");
    item.append(make("b", value));
    element("facts").append(item);
  }
  element("provenance").textContent = data.provenance;
}

function tellTables() {
  fill("zones", ["zone", "nodes", "cells", "folded", "scaled Jacobian", "angles", "skewness max", "mean", "aspect ratio", "growth i, j, k", "bend max", "mean", "least volume"],
    quality.zones.map(zone => [zone.name, zone.nodes.join(" x "), whole(zone.cells), whole(zone.folded),
      short(zone.worst_scaled_jacobian), `${short(zone.angles.least, 3)} to ${short(zone.angles.greatest, 4)}`,
      short(zone.greatest_skewness.value), short(zone.mean_skewness), short(zone.greatest_aspect_ratio.value),
      zone.growth.map(along => short(along.ratio, 3)).join(", "),
      short(Math.max(...zone.bends.map(bend => bend.greatest)), 3),
      short(Math.max(...zone.bends.map(bend => bend.mean)), 3), short(zone.least_volume.value)]));
  const unit = quality.units ? ` [${quality.units}]` : "";
  fill("boundaries", ["family", "nodes", "lines off its normal, mean", "max", `first cell min${unit}`, "median", "max"],
    quality.boundaries.map(wall => [wall.family, whole(wall.nodes), short(wall.mean_angle, 3), short(wall.greatest_angle, 3),
      short(wall.least_height), short(wall.median_height), short(wall.greatest_height)]));
  element("boundary_section").hidden = quality.boundaries.length === 0;
  fill("interfaces", ["interface", "nodes that differ", "growth", "slope break max", "mean"],
    quality.interfaces.map(item => [item.name, whole(item.mismatched), short(item.growth.ratio, 3),
      short(item.bends.greatest, 3), short(item.bends.mean, 3)]));
  element("interface_section").hidden = quality.interfaces.length === 0;
  if (!data.run) return;
  element("gates_section").hidden = data.run.gates.length === 0;
  fill("gates", ["gate", "of", "required", "got", "", "where"], data.run.gates.map(gate =>
    [gate.gate, gate.subject || "the grid", short(gate.limit), short(gate.got), gate.met ? "met" : "MISSED", gate.where]), [0, 1, 5])
    .forEach((row, n) => row.className = data.run.gates[n].met ? "good" : "bad");
  element("run_section").hidden = data.run.parameters.length === 0;
  fill("parameters", ["parameter", "value", ""], data.run.parameters.map(item =>
    [item.name, short(item.value, 8), item.overridden ? "by --set" : ""]));
}

function tellHistograms() {
  for (const histogram of quality.histograms) {
    const total = histogram.counts.reduce((sum, count) => sum + count, 0);
    if (total === 0) continue;
    const most = Math.max(...histogram.counts);
    const figure = make("figure");
    figure.append(make("figcaption", histogram.measure));
    const limits = histogram.limits;
    histogram.counts.forEach((count, bin) => {
      const range = bin === 0 ? `< ${limits[0]}` : bin === limits.length ? `>= ${limits[bin - 1]}` : `${limits[bin - 1]} - ${limits[bin]}`;
      const bar = make("div", undefined, {className: "bar", title: `${whole(count)} of ${whole(total)}`});
      const filled = make("div");
      filled.style.width = `${100 * count / most}%`;
      filled.style.visibility = count ? "visible" : "hidden";
      bar.append(make("span", range), filled, make("span", count ? `${short(100 * count / total, 3)} %` : ""));
      figure.append(bar);
    });
    element("histograms").append(figure);
  }
}

// --- The grid in space -----------------------------------------------------------------------

function bytesOf(text) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let n = 0; n < bytes.length; ++n) bytes[n] = characters.charCodeAt(n);
  return bytes;
}

/** A sheet's cells as triangles: six vertices a cell, positions and the cell's measures. */
function trianglesOf(sheet) {
  const nodes = new Float32Array(bytesOf(sheet.points).buffer);
  const measures = bytesOf(sheet.measures);
  const [ni, nj] = sheet.nodes;
  const cells = (ni - 1) * (nj - 1);
  const positions = new Float32Array(cells * 18);
  const values = new Uint8Array(cells * 24);
  let at = 0;
  for (let j = 0; j + 1 < nj; ++j) {
    for (let i = 0; i + 1 < ni; ++i) {
      const low = j * ni + i;
      for (const node of [low, low + 1, low + ni + 1, low, low + ni + 1, low + ni]) {
        positions.set(nodes.subarray(3 * node, 3 * node + 3), 3 * at);
        const cell = 4 * (j * (ni - 1) + i);
        values.set(measures.subarray(cell, cell + 4), 4 * at);
        ++at;
      }
    }
  }
  return {nodes, positions, values, count: at};
}

const surfaceVertex = `#version 300 es
uniform vec3 target; uniform mat3 turn; uniform vec3 scale;
layout(location = 0) in vec3 position; layout(location = 1) in vec4 measures;
out vec3 seen; out vec2 within; flat out vec4 shown;
void main() {
  int corner = gl_VertexID % 6;
  within = vec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5);
  seen = turn * (position - target);
  shown = measures;
  gl_Position = vec4(seen * scale, 1.0);
}`;

// Grid lines are drawn inside of the cells, as wide as a pixel, and fade where cells are too small.
const surfaceFragment = `#version 300 es
precision highp float;
uniform vec3 colour; uniform int measure; uniform bool lines; uniform bool lit; uniform float opacity;
in vec3 seen; in vec2 within; flat in vec4 shown;
out vec4 result;
vec3 ramp(float bad) {
  vec3 a = vec3(0.13, 0.40, 0.67), b = vec3(0.57, 0.77, 0.87), c = vec3(0.97, 0.95, 0.84),
       d = vec3(0.96, 0.65, 0.38), e = vec3(0.70, 0.09, 0.17);
  float x = clamp(bad, 0.0, 1.0) * 4.0;
  return x < 1.0 ? mix(a, b, x) : x < 2.0 ? mix(b, c, x - 1.0) : x < 3.0 ? mix(c, d, x - 2.0) : mix(d, e, x - 3.0);
}
void main() {
  vec3 base = measure < 0 ? colour : ramp(measure == 0 ? 1.0 - shown.x : measure == 1 ? shown.y : shown.z);
  if (measure >= 0 && shown.w > 0.5) base = vec3(0.85, 0.0, 0.75);
  float light = 1.0;
  if (lit) light = 0.62 + 0.38 * abs(normalize(cross(dFdx(seen), dFdy(seen))).z);
  vec2 size = fwidth(within);
  vec2 line = 1.0 - smoothstep(0.35, 1.1, min(within, 1.0 - within) / size);
  vec2 strength = line * clamp((1.0 / size - 2.0) / 5.0, 0.0, 1.0);
  float ink = lines ? max(strength.x, strength.y) * 0.7 : 0.0;
  result = vec4(mix(base * light, base * 0.25, ink), opacity);
}`;

const lineVertex = `#version 300 es
uniform vec3 target; uniform mat3 turn; uniform vec3 scale; uniform float raise;
layout(location = 0) in vec3 position;
void main() { gl_Position = vec4(turn * (position - target) * scale - vec3(0, 0, raise), 1.0); }`;

const lineFragment = `#version 300 es
precision highp float;
uniform vec3 colour; out vec4 result;
void main() { result = vec4(colour, 1.0); }`;

class Viewer {
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext("webgl2", {antialias: true, preserveDrawingBuffer: true});
    this.measure = -1;
    this.lines = true;
    this.surfaces = [];
    this.strokes = [];
    this.pending = false;
    if (!this.gl) return;
    this.surfaceProgram = this.program(surfaceVertex, surfaceFragment);
    this.lineProgram = this.program(lineVertex, lineFragment);
  }

  program(vertex, fragment) {
    const gl = this.gl;
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    const uniforms = {};
    for (let n = 0; n < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++n) {
      const name = gl.getActiveUniform(program, n).name;
      uniforms[name] = gl.getUniformLocation(program, name);
    }
    return {program, uniforms};
  }

  buffer(array, location, size, type, normalized) {
    const gl = this.gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, array, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, size, type, normalized, 0, 0);
  }

  addSurface(sheet, colour) {
    const gl = this.gl;
    const triangles = trianglesOf(sheet);
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    this.buffer(triangles.positions, 0, 3, gl.FLOAT, false);
    this.buffer(triangles.values, 1, 4, gl.UNSIGNED_BYTE, true);
    const surface = {sheet, colour, array, count: triangles.count, nodes: triangles.nodes, shown: false};
    this.surfaces.push(surface);
    return surface;
  }

  addStroke(nodes, colour, mode, raise) {
    const gl = this.gl;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    this.buffer(new Float32Array(nodes), 0, 3, gl.FLOAT, false);
    const stroke = {array, count: nodes.length / 3, colour, mode, raise, shown: true};
    this.strokes.push(stroke);
    return stroke;
  }

  /** What of the view is to hold these nodes: its middle and height, as the grid is turned now. */
  framing(lists) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    const rows = this.rows();
    for (const nodes of lists) {
      for (let n = 0; n + 2 < nodes.length; n += 3) {
        rows.forEach((row, axis) => {
          const at = row[0] * nodes[n] + row[1] * nodes[n + 1] + row[2] * nodes[n + 2];
          if (!Number.isFinite(at)) return;
          low[axis] = Math.min(low[axis], at);
          high[axis] = Math.max(high[axis], at);
        });
      }
    }
    const middle = low.map((value, axis) => 0.5 * (value + high[axis]));
    const aspect = this.canvas.clientWidth / Math.max(this.canvas.clientHeight, 1);
    return {target: [0, 1, 2].map(n => rows.reduce((sum, row, axis) => sum + row[n] * middle[axis], 0)),
            height: 1.12 * Math.max(high[1] - low[1], (high[0] - low[0]) / aspect) || 1,
            depth: Math.hypot(...high.map((value, axis) => value - low[axis])) || 1};
  }

  /** The whole grid, by which depths are measured; and the walls, where there are any. */
  frame(planar, whole, walls) {
    this.planar = planar;
    this.view = planar ? {yaw: 0, pitch: Math.PI / 2} : {yaw: -0.64, pitch: 0.5};
    this.radius = this.framing(whole).depth;
    this.home = {...this.view, ...this.framing(whole)};
    this.close = walls.length > 0 ? {...this.view, ...this.framing(walls)} : null;
    if (this.close && planar) this.close.height *= 1.6;
    this.goHome(this.close);
  }

  goHome(place) {
    const home = place || this.home;
    this.view = {...home, target: [...home.target]};
    this.draw();
  }

  /** Rows: right, up, towards the eye. */
  rows() {
    const {yaw, pitch} = this.view;
    const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
    return [[cy, sy, 0], [-sp * sy, sp * cy, cp], [cp * sy, -cp * cy, sp]];
  }

  draw() {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => { this.pending = false; this.render(); });
  }

  render() {
    const gl = this.gl, canvas = this.canvas;
    const ratio = window.devicePixelRatio || 1;
    const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
    if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
    gl.viewport(0, 0, width, height);
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    const rows = this.rows();
    const half = 0.5 * this.view.height;
    // Close up, what is far before or behind is cut off, so that depths can tell thin cells apart.
    const depth = Math.min(4 * this.radius, 100 * this.view.height);
    const scale = [height / (half * width), 1 / half, -1 / depth];
    const turn = [0, 1, 2].flatMap(column => rows.map(row => row[column]));
    const use = program => {
      gl.useProgram(program.program);
      gl.uniform3fv(program.uniforms.target, this.view.target);
      gl.uniformMatrix3fv(program.uniforms.turn, false, turn);
      gl.uniform3fv(program.uniforms.scale, scale);
      return program.uniforms;
    };
    const surface = use(this.surfaceProgram);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
    gl.uniform1i(surface.lines, this.lines);
    gl.uniform1i(surface.lit, !this.planar);
    gl.uniform1i(surface.measure, this.measure);
    const shown = this.surfaces.filter(part => part.shown);
    const inside = shown.filter(part => part.sheet.family < 0);
    // Boundaries are seen through while something inside of them is shown.
    const veils = inside.length > 0 ? shown.filter(part => part.sheet.family >= 0) : [];
    const draw = part => {
      gl.uniform3fv(surface.colour, part.colour);
      gl.bindVertexArray(part.array);
      gl.drawArrays(gl.TRIANGLES, 0, part.count);
    };
    gl.uniform1f(surface.opacity, 1);
    shown.filter(part => !veils.includes(part)).forEach(draw);
    gl.uniform1f(surface.opacity, 0.15);
    gl.uniform1i(surface.lines, false);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    veils.forEach(draw);
    gl.depthMask(true);
    gl.disable(gl.BLEND);
    const line = use(this.lineProgram);
    for (const stroke of this.strokes.filter(stroke => stroke.shown)) {
      gl.uniform3fv(line.colour, stroke.colour);
      gl.uniform1f(line.raise, stroke.raise);
      gl.bindVertexArray(stroke.array);
      gl.drawArrays(stroke.mode, 0, stroke.count);
    }
  }

  /** Moves by a part of the view's height, right and up. */
  move(right, up) {
    const rows = this.rows();
    for (let n = 0; n < 3; ++n) this.view.target[n] -= this.view.height * (rows[0][n] * right + rows[1][n] * up);
    this.draw();
  }

  rotate(yaw, pitch) {
    this.view.yaw += yaw;
    this.view.pitch = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, this.view.pitch + pitch));
    this.draw();
  }

  /** Zooms about a place on the canvas, in parts of its height from its middle. */
  zoom(factor, right = 0, up = 0) {
    const before = this.view.height;
    this.view.height = Math.max(before * factor, 1e-7 * this.radius);
    const shift = 1 - this.view.height / before;
    const rows = this.rows();
    for (let n = 0; n < 3; ++n) this.view.target[n] += before * shift * (rows[0][n] * right + rows[1][n] * up);
    this.draw();
  }

  goTo(target, height) {
    this.view.target = [...target];
    this.view.height = height;
    this.draw();
  }
}

/** Drags, wheel, touches and keys. */
function listen(viewer) {
  const canvas = viewer.canvas;
  const pointers = new Map();
  const place = event => {
    const box = canvas.getBoundingClientRect();
    return [(event.clientX - box.left - box.width / 2) / box.height, -(event.clientY - box.top - box.height / 2) / box.height];
  };
  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, place(event));
  });
  canvas.addEventListener("pointermove", event => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const now = place(event);
    if (pointers.size === 2) {
      const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
      const spread = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]) || 1e-6;
      viewer.zoom(spread(before, other) / spread(now, other), (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
      viewer.move((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
    } else if (viewer.planar || event.shiftKey || event.buttons & 6) {
      viewer.move(now[0] - before[0], now[1] - before[1]);
    } else {
      viewer.rotate(-3 * (now[0] - before[0]), -3 * (now[1] - before[1]));
    }
    pointers.set(event.pointerId, now);
  });
  for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, event => pointers.delete(event.pointerId));
  canvas.addEventListener("contextmenu", event => event.preventDefault());
  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    viewer.zoom(Math.exp(Math.sign(event.deltaY) * Math.min(Math.abs(event.deltaY), 100) * 0.002), ...place(event));
  }, {passive: false});
  canvas.addEventListener("dblclick", event => { const at = place(event); viewer.move(-at[0], -at[1]); });
  canvas.addEventListener("keydown", event => {
    const turns = {ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
    if (turns && (viewer.planar || event.shiftKey)) viewer.move(0.05 * turns[0], -0.05 * turns[1]);
    else if (turns) viewer.rotate(-0.1 * turns[0], -0.1 * turns[1]);
    else if (event.key === "+" || event.key === "=") viewer.zoom(0.8);
    else if (event.key === "-") viewer.zoom(1.25);
    else if (event.key === "r" || event.key === "R") viewer.goHome(null);
    else if (event.key === "w" || event.key === "W") viewer.goHome(viewer.close);
    else return;
    event.preventDefault();
  });
  window.addEventListener("resize", () => viewer.draw());
}

const rgb = text => [1, 3, 5].map(at => parseInt(text.slice(at, at + 2), 16) / 255);
const lighter = colour => colour.map(value => 0.45 * value + 0.55);

/** Checkboxes for the families (of surface grids: the zones). */
function offerParts(viewer) {
  const byFamily = data.sheets.some(sheet => sheet.family >= 0);
  const things = byFamily ? data.families : data.zones;
  element("parts_title").textContent = byFamily ? "Boundaries" : "Zones";
  const far = /far|inflow|outflow|symmetry|tunnel/i;
  things.forEach((thing, number) => {
    const own = viewer.surfaces.filter(part => part.sheet.worst < 0
      && (byFamily ? part.sheet.family === number : part.sheet.zone === number && data.sheets.indexOf(part.sheet) < data.zones.length && planarSheets));
    if (own.length === 0) return;
    const walls = data.families.some(family => !far.test(family.type));
    const shown = !byFamily || !walls || !far.test(thing.type);
    own.forEach(part => part.shown = shown);
    const label = make("label");
    const box = make("input", undefined, {type: "checkbox", checked: shown});
    const patch = make("i");
    patch.style.background = thing.colour;
    box.addEventListener("change", () => { own.forEach(part => part.shown = box.checked); viewer.draw(); });
    label.append(box, patch, make("span", byFamily ? `${thing.name} (${thing.type})` : thing.name));
    element("parts").append(label);
  });
}

const planarSheets = !data.sheets.some(sheet => sheet.family >= 0) && data.zones.every(zone => zone.nodes[2] === 1);

/** The choice of an index plane: zone, axis, and a slider over those that are in the page. */
function offerPlanes(viewer) {
  const planes = viewer.surfaces.filter(part => part.sheet.family < 0 && part.sheet.worst < 0 && !planarSheets);
  element("plane_set").hidden = planes.length === 0;
  if (planes.length === 0) return;
  data.zones.forEach((zone, number) => element("plane_zone").append(make("option", zone.name, {value: number})));
  const [zone, axis, slider, toggle] = ["plane_zone", "plane_axis", "plane_index", "plane_toggle"].map(element);
  axis.selectedIndex = 2;
  const choices = () => planes.filter(part => part.sheet.zone === +zone.value && part.sheet.axis === axis.selectedIndex)
                              .sort((a, b) => a.sheet.index - b.sheet.index);
  const name = part => `${data.zones[part.sheet.zone].name}: ${axisName(part.sheet.axis)} = ${part.sheet.index}`;
  let current = null;
  const list = () => {
    element("planes_shown").replaceChildren(...planes.filter(part => part.kept).map(part => {
      const label = make("label");
      const box = make("input", undefined, {type: "checkbox", checked: part.shown});
      box.addEventListener("change", () => { part.kept = part.shown = box.checked; if (part === current) tell(); list(); viewer.draw(); });
      label.append(box, make("span", name(part)));
      return label;
    }));
  };
  const tell = () => {
    const part = choices()[+slider.value];
    element("plane_text").textContent = part ? `${name(part)} of ${data.zones[part.sheet.zone].nodes[part.sheet.axis]}` : "none in this page";
    toggle.textContent = part && part.shown ? "hide" : "show";
    toggle.disabled = !part;
    element("plane_note").textContent = part && part.sheet.stride > 1 ? `Every ${part.sheet.stride}th line of it is in this page.` : "";
  };
  const choose = () => {
    const all = choices();
    slider.max = Math.max(all.length - 1, 0);
    if (current && current.shown) {
      // The plane that is shown goes with the slider.
      current.shown = current.kept = false;
      current = all[+slider.value] || null;
      if (current) current.shown = current.kept = true;
      list();
      viewer.draw();
    }
    tell();
  };
  const restart = () => { current = null; slider.max = Math.max(choices().length - 1, 0); slider.value = Math.floor(slider.max / 2); choose(); };
  zone.addEventListener("change", restart);
  axis.addEventListener("change", restart);
  slider.addEventListener("input", choose);
  toggle.addEventListener("click", () => {
    const part = choices()[+slider.value];
    part.shown = part.kept = !part.shown;
    current = part.shown ? part : null;
    list();
    tell();
    viewer.draw();
  });
  restart();
}

function tellLegend(viewer) {
  const legend = element("legend");
  legend.replaceChildren();
  if (viewer.measure < 0) return;
  const ends = [["1", "0 and below"], ["0", "1"], ["1", "10^6 and above"]][viewer.measure];
  const bar = make("i", undefined, {className: "ramp"});
  bar.style.background = "linear-gradient(90deg, #2166ab, #92c4de, #f8f2d6, #f5a661, #b3172b)";
  const ramp = make("span", ends[0]);
  ramp.append(bar, ends[1]);
  const folded = make("span");
  const patch = make("i");
  patch.style.background = "#d900bf";
  folded.append(patch, "folded");
  legend.append(ramp, folded);
}

/** The rows of the worst cells lead to them. */
function offerWorst(viewer) {
  const rows = fill("worst", ["zone", "cell", "scaled Jacobian", "skewness", "volume", "place"],
    quality.worst.map(cell => [cell.zone, index(cell.cell), short(cell.scaled_jacobian), short(cell.skewness), short(cell.volume), point(cell.place)]));
  element("worst_section").hidden = rows.length === 0;
  if (!viewer.gl) return;
  const edges = [[0, 1], [0, 2], [1, 3], [2, 3], [4, 5], [4, 6], [5, 7], [6, 7], [0, 4], [1, 5], [2, 6], [3, 7]];
  const marks = data.worst_cells.map(nodes => {
    const ends = edges.filter(([, b]) => b < nodes.length).flatMap(([a, b]) => [...nodes[a], ...nodes[b]]);
    const mark = viewer.addStroke(ends, [0.85, 0, 0.75], viewer.gl.LINES, 2e-5);
    mark.shown = false;
    return mark;
  });
  rows.forEach((row, rank) => {
    row.className = "pick";
    row.tabIndex = 0;
    const go = () => {
      rows.forEach(other => other.classList.toggle("chosen", other === row));
      marks.forEach((mark, n) => mark.shown = n === rank);
      viewer.surfaces.forEach(part => { if (part.sheet.worst >= 0) part.shown = part.sheet.worst === rank; });
      const nodes = data.worst_cells[rank];
      let size = 0;
      nodes.forEach(a => nodes.forEach(b => size = Math.max(size, Math.hypot(...a.map((value, n) => value - b[n])))));
      const cell = quality.worst[rank];
      element("picked").textContent = `${rank + 1}: zone ${cell.zone}, cell ${index(cell.cell)}, scaled Jacobian ${short(cell.scaled_jacobian)}, at ${point(cell.place)}`;
      if (cell.place) viewer.goTo(cell.place, 8 * size || viewer.home.height);
      element("canvas").scrollIntoView({block: "nearest"});
    };
    row.addEventListener("click", go);
    row.addEventListener("keydown", event => { if (event.key === "Enter") go(); });
  });
}

function start() {
  tellSummary();
  tellTables();
  tellHistograms();
  const viewer = new Viewer(element("canvas"));
  if (!viewer.gl) {
    element("message").hidden = false;
    element("message").textContent = "This browser offers no WebGL 2: the grid cannot be drawn here. The tables below are complete.";
    offerWorst(viewer);
    return;
  }
  for (const sheet of data.sheets) {
    const family = sheet.family >= 0 ? data.families[sheet.family] : data.zones[sheet.zone];
    viewer.addSurface(sheet, lighter(rgb(family.colour)));
  }
  for (const line of data.lines) viewer.addStroke(line.nodes, rgb(data.families[line.family].colour), viewer.gl.LINE_STRIP, 1e-5);
  offerParts(viewer);
  offerPlanes(viewer);
  offerWorst(viewer);
  const wall = family => data.families[family].type.startsWith("BCWall");
  viewer.frame(data.planar, viewer.surfaces.filter(part => part.sheet.worst < 0).map(part => part.nodes),
    [...viewer.surfaces.filter(part => part.sheet.family >= 0 && wall(part.sheet.family)).map(part => part.nodes),
     ...data.lines.filter(line => wall(line.family)).map(line => line.nodes)]);
  element("walls").hidden = !viewer.close;
  element("walls").addEventListener("click", () => viewer.goHome(viewer.close));
  listen(viewer);
  element("colour").addEventListener("change", event => {
    viewer.measure = event.target.value === "family" ? -1 : +event.target.value;
    tellLegend(viewer);
    viewer.draw();
  });
  element("show_lines").addEventListener("change", event => { viewer.lines = event.target.checked; viewer.draw(); });
  element("reset").addEventListener("click", () => {
    element("picked").textContent = "";
    viewer.surfaces.forEach(part => { if (part.sheet.worst >= 0) part.shown = false; });
    viewer.goHome(null);
  });
  element("controls").addEventListener("submit", event => event.preventDefault());
}

start();
})();

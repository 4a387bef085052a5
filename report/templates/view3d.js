"use strict";
// The deformed model: drag turns, Shift and drag (or two fingers) moves, the wheel (after a click) or two fingers zoom.
(() => {
  const bytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer;
  const COLOURS = ["#e8edf2", "#9cc3dd", "#4f9d8f", "#f2c14e", "#e4572e", "#7a0f2b"];
  const rgb = hex => [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16) / 255);
  const VERTEX = `#version 300 es
in vec3 point; in vec3 moved; in float value;
uniform mat3 turn; uniform vec3 shift; uniform vec2 scale; uniform float enlarge, mirror, pull, depth;
out float v; out vec3 eye;
void main() {
  vec3 p = point + enlarge * moved; p.y *= mirror;
  eye = turn * p; v = value;
  gl_Position = vec4((eye.xy + shift.xy) * scale, -depth * eye.z - pull, 1.0);
}`;
  const FRAGMENT = `#version 300 es
precision highp float;
in float v; in vec3 eye; out vec4 colour;
uniform vec3 colours[6]; uniform vec2 range; uniform float line;
void main() {
  if (line > 0.5) { colour = vec4(0.1, 0.15, 0.2, 1.0) * 0.35; return; }
  float s = clamp((v - range.x) / (range.y - range.x), 0.0, 1.0) * 5.0;
  vec3 c = colours[0];
  for (int i = 0; i < 5; i++) c = mix(c, colours[i + 1], clamp(s - float(i), 0.0, 1.0));
  vec3 n = normalize(cross(dFdx(eye), dFdy(eye)));
  colour = vec4(c * (0.62 + 0.38 * abs(n.z)), 1.0);
}`;

  function program(gl) {
    const made = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(kind); gl.shaderSource(shader, text); gl.compileShader(shader); gl.attachShader(made, shader);
    }
    gl.linkProgram(made);
    return gl.getProgramParameter(made, gl.LINK_STATUS) ? made : null;
  }

  class View {
    constructor(holder, model) {
      this.model = model;
      this.canvas = holder.appendChild(document.createElement("canvas")); this.canvas.tabIndex = 0;
      this.canvas.setAttribute("aria-label", "The deformed model in three dimensions; arrow keys turn it, plus and minus zoom, 0 puts it back");
      this.gl = this.canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
      this.shader = this.gl && program(this.gl);
      if (!this.shader) return;
      this.hidden = new Set(); this.field = model.fields[0]; this.enlarge = 1; this.edges = true;
      this.load(); this.controls(holder); this.reset(); this.listen();
    }
    get works() { return Boolean(this.shader); }
    load() {
      const gl = this.gl, m = this.model, array = (name, data, n) => {
        const at = gl.getAttribLocation(this.shader, name);
        gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer()); gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
        gl.enableVertexAttribArray(at); gl.vertexAttribPointer(at, n, gl.FLOAT, false, 0, 0);
      };
      gl.useProgram(this.shader);
      array("point", bytes(m.points), 3); array("moved", bytes(m.moved), 3);
      this.values = new Map(m.fields.map(f => [f, bytes(f.values)]));
      this.setField = f => { this.field = f; array("value", this.values.get(f), 1); };
      this.setField(this.field);
      this.indices = ["triangles", "lines"].map(name => {
        const buffer = gl.createBuffer(); gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, bytes(m[name]), gl.STATIC_DRAW); return buffer;
      });
      this.place = Object.fromEntries(["turn", "shift", "scale", "enlarge", "mirror", "pull", "depth", "colours", "range", "line"].map(n => [n, gl.getUniformLocation(this.shader, n)]));
      gl.enable(gl.DEPTH_TEST); gl.enable(gl.BLEND); gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
      gl.uniform3fv(this.place.colours, COLOURS.flatMap(rgb));
    }
    controls(holder) {
      const bar = holder.appendChild(document.createElement("div")); bar.className = "controls";
      const add = (html, parent = bar) => { const l = parent.appendChild(document.createElement("label")); l.innerHTML = html; return l; };
      const choice = add('<select aria-label="field"></select>').firstChild;
      for (const f of this.model.fields) choice.appendChild(new Option(`${f.name} (${f.unit})`));
      choice.onchange = () => { this.setField(this.model.fields[choice.selectedIndex]); this.scaleBar(); this.draw(); };
      for (const name of Object.keys(this.model.parts)) {
        const box = add('<input type="checkbox" checked> ').firstChild; box.parentNode.append(name);
        box.onchange = () => { box.checked ? this.hidden.delete(name) : this.hidden.add(name); this.draw(); };
      }
      const edges = add('<input type="checkbox" checked> cells').firstChild; edges.onchange = () => { this.edges = edges.checked; this.draw(); };
      if (this.model.half) {
        this.whole = true; const box = add('<input type="checkbox" checked> mirrored half').firstChild;
        box.onchange = () => { this.whole = box.checked; this.draw(); };
      }
      if (this.model.largest > 1) {
        const label = add(`deformation × <output>1</output> <input type="range" min="1" max="${this.model.largest}" value="1" step="any">`), range = label.lastChild;
        range.oninput = () => { this.enlarge = Number(range.value); label.children[0].textContent = this.enlarge.toFixed(0); this.draw(); };
      }
      const back = bar.appendChild(document.createElement("button")); back.type = "button"; back.textContent = "back"; back.onclick = () => this.reset();
      this.bar = holder.appendChild(document.createElement("div")); this.bar.className = "scale"; this.scaleBar();
    }
    scaleBar() {
      const f = this.field, text = v => Number(v.toPrecision(3)).toString();
      this.bar.innerHTML = `<span>${text(f.low)}</span><i style="background:linear-gradient(90deg,${COLOURS})"></i><span>${text(f.high)} ${f.unit}</span><span>${f.name}, largest ${text(f.largest)} ${f.unit}</span>`;
    }
    reset() { this.yaw = this.model.half ? 2.5 : 2.2; this.pitch = 0.75; this.zoom = 1.15; this.shift = [0, 0]; this.draw(); }
    listen() {
      const c = this.canvas, held = new Map();
      c.addEventListener("pointerdown", e => { held.set(e.pointerId, [e.clientX, e.clientY]); c.setPointerCapture(e.pointerId); });
      for (const name of ["pointerup", "pointercancel"]) c.addEventListener(name, e => held.delete(e.pointerId));
      c.addEventListener("pointermove", e => {
        const before = held.get(e.pointerId); if (!before) return;
        const now = [e.clientX, e.clientY], dx = now[0] - before[0], dy = now[1] - before[1], other = [...held].find(([id]) => id !== e.pointerId);
        held.set(e.pointerId, now);
        if (other) {
          const d = p => Math.max(1, Math.hypot(p[0] - other[1][0], p[1] - other[1][1]));
          this.zoom = Math.min(200, Math.max(0.2, this.zoom * d(now) / d(before))); this.move(dx / 2, dy / 2);
        } else if (e.shiftKey || e.buttons === 2) this.move(dx, dy);
        else { this.yaw -= 0.008 * dx; this.pitch = Math.max(-1.57, Math.min(1.57, this.pitch + 0.008 * dy)); }
        this.draw();
      });
      c.addEventListener("contextmenu", e => e.preventDefault());
      c.addEventListener("wheel", e => {
        if (!e.ctrlKey && document.activeElement !== c) return;
        e.preventDefault(); this.zoom = Math.min(200, Math.max(0.2, this.zoom * Math.exp(-0.0015 * e.deltaY))); this.draw();
      }, { passive: false });
      c.addEventListener("dblclick", () => this.reset());
      c.addEventListener("keydown", e => {
        const turns = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
        if (turns[e.key]) { this.yaw += turns[e.key][0]; this.pitch = Math.max(-1.57, Math.min(1.57, this.pitch + turns[e.key][1])); }
        else if (e.key === "+" || e.key === "=") this.zoom *= 1.2;
        else if (e.key === "-") this.zoom /= 1.2;
        else if (e.key === "0") this.reset();
        else return;
        e.preventDefault(); this.draw();
      });
      new ResizeObserver(() => this.draw()).observe(c);
    }
    move(dx, dy) { const k = 2 / (this.unit || 1); this.shift = [this.shift[0] + k * dx / 2, this.shift[1] - k * dy / 2]; }
    draw() {
      const gl = this.gl, c = this.canvas, ratio = window.devicePixelRatio || 1, w = c.clientWidth, h = c.clientHeight;
      if (!w) return;
      if (c.width !== Math.round(w * ratio) || c.height !== Math.round(h * ratio)) { c.width = Math.round(w * ratio); c.height = Math.round(h * ratio); }
      this.unit = 0.8 * Math.min(w, 1.6 * h) / this.model.size * this.zoom;  // pixels a metre
      const cy = Math.cos(this.yaw), sy = Math.sin(this.yaw), cp = Math.cos(this.pitch), sp = Math.sin(this.pitch);
      const right = [-sy, cy, 0], towards = [cp * cy, cp * sy, sp], up = [-sp * cy, -sp * sy, cp], p = this.place;
      gl.viewport(0, 0, c.width, c.height); gl.clearColor(0, 0, 0, 0); gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.uniformMatrix3fv(p.turn, false, [0, 1, 2].flatMap(i => [right[i], up[i], towards[i]]));
      gl.uniform3f(p.shift, this.shift[0], this.shift[1], 0); gl.uniform2f(p.scale, 2 * this.unit / w, 2 * this.unit / h);
      gl.uniform1f(p.enlarge, this.enlarge); gl.uniform1f(p.depth, 0.6 / this.model.size); gl.uniform2f(p.range, this.field.low, this.field.high);
      for (const [kind, name, buffer, size] of [[gl.TRIANGLES, "triangles", this.indices[0], 3], [gl.LINES, "lines", this.indices[1], 2]]) {
        if (name === "lines" && !this.edges) continue;
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer); gl.uniform1f(p.line, size === 2 ? 1 : 0); gl.uniform1f(p.pull, size === 2 ? 0.0008 : 0);
        for (const side of this.whole ? [1, -1] : [1]) {
          gl.uniform1f(p.mirror, side);
          for (const [part, ranges] of Object.entries(this.model.parts))
            if (!this.hidden.has(part)) gl.drawElements(kind, size * ranges[name][1], this.model.short ? gl.UNSIGNED_SHORT : gl.UNSIGNED_INT,
              (this.model.short ? 2 : 4) * size * ranges[name][0]);
        }
      }
    }
  }

  for (const store of document.querySelectorAll("script.model")) {
    const figure = store.closest("figure"), holder = figure.insertBefore(document.createElement("div"), store);
    holder.className = "view"; figure.classList.add("live");
    const view = new View(holder, JSON.parse(store.textContent));
    if (!view.works) { holder.remove(); figure.classList.remove("live"); }
  }
})();

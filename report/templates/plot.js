"use strict";
// Curves over a figure's picture: drag moves, wheel (after a click, or with Ctrl) and two fingers zoom, a touch of the pointer reads values.
(() => {
  const numbers = text => { const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0)); return new Float32Array(bytes.buffer); };
  const ends = values => values.reduce((e, v) => [Math.min(e[0], v), Math.max(e[1], v)], [Infinity, -Infinity]);
  const padded = ([a, b], share) => { const m = b > a ? share * (b - a) : Math.abs(a) * 0.1 || 1; return [a - m, b + m]; };
  const ticks = (a, b, n) => {
    const raw = (b - a) / n, power = 10 ** Math.floor(Math.log10(raw)), step = power * [1, 2, 5, 10].find(s => s * power >= raw);
    const found = []; for (let k = Math.ceil(a / step - 1e-9); k <= b / step + 1e-9; k++) found.push(k * step);
    return { at: found, digits: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
  };
  const said = (v, d) => v.toLocaleString("en", { minimumFractionDigits: d, maximumFractionDigits: d, useGrouping: false }).replace(/^-(?=0*\.?0*$)/, "").replace("-", "−");
  const read = (v, span) => said(v, Math.max(0, Math.min(6, 3 - Math.floor(Math.log10(span || 1)))));

  class Panel {
    constructor(holder, panel, all) {
      Object.assign(this, panel); this.all = all;
      for (const line of this.lines) { line.x = numbers(line.x); line.y = numbers(line.y); line.dash = line.dash ? line.dash.split(" ").map(Number) : []; }
      this.wholeX = padded(ends(this.lines.flatMap(l => ends(l.x))), this.over ? 0 : 0.06);
      this.x0 = this.wholeX.slice(); this.fit();
      if (this.equal) { const more = Math.max(0, 1.7 * (this.y0[1] - this.y0[0]) - this.x0[1] + this.x0[0]) / 2; this.wholeX = [this.x0[0] - more, this.x0[1] + more]; this.x0 = this.wholeX.slice(); }
      const box = holder.appendChild(document.createElement("div"));
      box.className = "panel";
      box.innerHTML = "<strong></strong><canvas tabindex=0></canvas><output></output>";
      box.firstChild.textContent = this.title;
      this.canvas = box.children[1]; this.out = box.children[2]; this.pointers = new Map();
      this.canvas.setAttribute("aria-label", `${this.title}: ${this.y} over ${this.x}. Arrow keys move, plus and minus zoom, 0 shows all`);
      this.listen();
    }
    fit() {  // y by what is to be seen of x
      let e = [Infinity, -Infinity];
      for (const l of this.lines) for (let i = 0; i < l.x.length; i++) {
        const near = !this.over || (l.x[Math.min(i + 1, l.x.length - 1)] >= this.x0[0] && l.x[Math.max(i - 1, 0)] <= this.x0[1]);
        if (near) e = [Math.min(e[0], l.y[i]), Math.max(e[1], l.y[i])];
      }
      this.y0 = padded(e[0] <= e[1] ? e : [0, 1], 0.08);
    }
    square() {  // one millimetre is as long along y as along x
      const half = (this.x0[1] - this.x0[0]) * this.h / this.w / 2, middle = (this.y0[0] + this.y0[1]) / 2;
      this.y0 = [middle - half, middle + half];
    }
    reset() { this.x0 = this.wholeX.slice(); this.fit(); this.share(); }
    share() {
      const same = this.group ? this.all.filter(p => p.group === this.group) : [this];
      for (const p of same) { if (p !== this) { p.x0 = this.x0.slice(); p.fit(); } p.draw(); }
    }
    zoom(factor, px, py) {
      const around = (range, at) => [at - (at - range[0]) * factor, at + (range[1] - at) * factor];
      const next = around(this.x0, this.toX(px)), whole = this.wholeX[1] - this.wholeX[0];
      if (next[1] - next[0] < 1e-5 * whole || next[1] - next[0] > 4 * whole) return;
      this.x0 = next;
      if (this.over) this.fit(); else this.y0 = around(this.y0, this.toY(py));
      this.share();
    }
    move(dx, dy) {
      const kx = (this.x0[1] - this.x0[0]) / this.w; this.x0 = this.x0.map(v => v - kx * dx);
      if (this.over) this.fit(); else { const ky = (this.y0[1] - this.y0[0]) / this.h; this.y0 = this.y0.map(v => v + ky * dy); }
      this.share();
    }
    toX(px) { return this.x0[0] + (px - this.left) / this.w * (this.x0[1] - this.x0[0]); }
    toY(py) { return this.y0[1] - (py - this.top) / this.h * (this.y0[1] - this.y0[0]); }
    px(x) { return this.left + (x - this.x0[0]) / (this.x0[1] - this.x0[0]) * this.w; }
    py(y) { return this.top + (this.y0[1] - y) / (this.y0[1] - this.y0[0]) * this.h; }
    listen() {
      const c = this.canvas, at = e => { const r = c.getBoundingClientRect(); return [e.clientX - r.left, e.clientY - r.top]; };
      c.addEventListener("pointerdown", e => { this.pointers.set(e.pointerId, at(e)); c.setPointerCapture(e.pointerId); });
      for (const name of ["pointerup", "pointercancel"]) c.addEventListener(name, e => this.pointers.delete(e.pointerId));
      c.addEventListener("pointermove", e => {
        const now = at(e), before = this.pointers.get(e.pointerId);
        if (before) {
          const other = [...this.pointers].find(([id]) => id !== e.pointerId);
          this.pointers.set(e.pointerId, now);
          if (other) {
            const d = p => Math.hypot(p[0] - other[1][0], p[1] - other[1][1]);
            this.zoom(d(before) / Math.max(1, d(now)), (now[0] + other[1][0]) / 2, (now[1] + other[1][1]) / 2);
          } else this.move(now[0] - before[0], now[1] - before[1]);
        }
        this.hover(now);
      });
      c.addEventListener("pointerleave", () => { this.out.textContent = ""; this.draw(); });
      c.addEventListener("wheel", e => {
        if (!e.ctrlKey && document.activeElement !== c) return;
        e.preventDefault(); this.zoom(Math.exp(0.0015 * e.deltaY), ...at(e));
      }, { passive: false });
      c.addEventListener("dblclick", () => this.reset());
      c.addEventListener("keydown", e => {
        const moves = { ArrowLeft: [40, 0], ArrowRight: [-40, 0], ArrowUp: [0, 40], ArrowDown: [0, -40] }, middle = [this.left + this.w / 2, this.top + this.h / 2];
        if (moves[e.key]) this.move(...moves[e.key]);
        else if (e.key === "+" || e.key === "=") this.zoom(0.7, ...middle);
        else if (e.key === "-") this.zoom(1 / 0.7, ...middle);
        else if (e.key === "0") this.reset();
        else return;
        e.preventDefault();
      });
    }
    nearest(line, [px, py]) {
      let best = -1, least = Infinity;
      for (let i = 0; i < line.x.length; i++) {
        const dx = this.px(line.x[i]) - px, d = this.over ? Math.abs(dx) : Math.hypot(dx, this.py(line.y[i]) - py);
        if (d < least) { least = d; best = i; }
      }
      return this.over || least < 40 ? best : -1;
    }
    hover(at) {
      this.draw(); const pen = this.pen, parts = [];
      const unit = axis => (axis.match(/\(([^)–-]+)\)/) || ["", ""])[1], named = { x: unit(this.x), y: unit(this.y) };
      const value = (v, axis) => `${read(v, this[axis + "0"][1] - this[axis + "0"][0])} ${named[axis]}`.trim();
      if (this.over) parts.push(`${this.x.split(" (")[0]} ${value(this.toX(at[0]), "x")}`);
      for (const line of this.lines) {
        const i = this.nearest(line, at); if (i < 0) continue;
        let x = line.x[i], y = line.y[i];
        if (this.over) {  // on the straight line between samples
          x = this.toX(at[0]); const j = line.x[i] <= x ? Math.min(i + 1, line.x.length - 1) : Math.max(i - 1, 0);
          if (x < line.x[0] || x > line.x[line.x.length - 1]) continue;
          const s = line.x[j] === line.x[i] ? 0 : (x - line.x[i]) / (line.x[j] - line.x[i]); y += s * (line.y[j] - line.y[i]);
        }
        parts.push(`${line.label}: ${this.over ? "" : value(x, "x") + ", "}${value(y, "y")}`);
        pen.beginPath(); pen.arc(this.px(x), this.py(y), 3, 0, 7); pen.fillStyle = line.colour; pen.fill();
      }
      this.out.textContent = parts.join("; ");
    }
    draw() {
      const c = this.canvas, ratio = window.devicePixelRatio || 1, width = c.clientWidth, height = c.clientHeight;
      if (!width) return;
      if (c.width !== Math.round(width * ratio) || c.height !== Math.round(height * ratio)) { c.width = Math.round(width * ratio); c.height = Math.round(height * ratio); }
      const pen = this.pen = c.getContext("2d"); pen.setTransform(ratio, 0, 0, ratio, 0, 0); pen.clearRect(0, 0, width, height);
      Object.assign(this, { left: 54, top: 6, w: width - 62, h: height - 42 });
      if (this.equal) this.square();
      pen.font = "11px system-ui, 'DejaVu Sans', sans-serif"; pen.lineWidth = 1; pen.strokeStyle = "#e3e8ec"; pen.fillStyle = "#1c2733"; pen.textAlign = "center";
      const xs = ticks(...this.x0, Math.max(2, this.w / 70)), ys = ticks(...this.y0, Math.max(2, this.h / 40));
      const stroke = (a, b, d, e) => { pen.beginPath(); pen.moveTo(a, b); pen.lineTo(d, e); pen.stroke(); };
      for (const x of xs.at) { stroke(this.px(x), this.top, this.px(x), this.top + this.h); pen.fillText(said(x, xs.digits), this.px(x), this.top + this.h + 14); }
      pen.textAlign = "right";
      for (const y of ys.at) { stroke(this.left, this.py(y), this.left + this.w, this.py(y)); pen.fillText(said(y, ys.digits), this.left - 5, this.py(y) + 4); }
      pen.strokeStyle = "#66727f"; stroke(this.left, this.top, this.left, this.top + this.h); stroke(this.left, this.top + this.h, this.left + this.w, this.top + this.h);
      pen.textAlign = "center"; pen.fillText(this.x, this.left + this.w / 2, this.top + this.h + 30);
      pen.save(); pen.translate(11, this.top + this.h / 2); pen.rotate(-Math.PI / 2); pen.fillText(this.y, 0, 0); pen.restore();
      pen.save(); pen.beginPath(); pen.rect(this.left, this.top, this.w, this.h); pen.clip();
      pen.strokeStyle = "#a3123a"; pen.setLineDash([1.5, 2.5]);
      for (const v of this.levels) this.mark === "x" ? stroke(this.px(v), this.top, this.px(v), this.top + this.h) : stroke(this.left, this.py(v), this.left + this.w, this.py(v));
      pen.lineJoin = "round";
      for (const l of this.lines) {
        pen.strokeStyle = l.colour; pen.lineWidth = l.width; pen.setLineDash(l.dash); pen.beginPath();
        for (let i = 0; i < l.x.length; i++) i ? pen.lineTo(this.px(l.x[i]), this.py(l.y[i])) : pen.moveTo(this.px(l.x[i]), this.py(l.y[i]));
        pen.stroke();
      }
      pen.restore();
    }
  }

  for (const store of document.querySelectorAll("script.curves")) {
    const figure = store.closest("figure"), holder = figure.insertBefore(document.createElement("div"), store), panels = [];
    holder.className = "plot";
    const data = JSON.parse(store.textContent), legend = holder.appendChild(document.createElement("p"));
    legend.className = "legend";
    const seen = new Set();
    for (const line of data.flatMap(p => p.lines)) {
      if (seen.has(line.label)) continue;
      seen.add(line.label);
      const item = legend.appendChild(document.createElement("span")); item.textContent = line.label;
      item.style.setProperty("--colour", line.colour); item.classList.toggle("dashed", line.dash !== "");
    }
    for (const panel of data) panels.push(new Panel(holder, panel, panels));
    const bar = legend.appendChild(document.createElement("span")); bar.className = "buttons";
    const button = (text, name, act) => {
      const b = bar.appendChild(document.createElement("button")); b.type = "button"; b.textContent = text; b.title = name; b.setAttribute("aria-label", name);
      b.onclick = () => { const done = new Set(); for (const p of panels) if (!p.group || !done.has(p.group)) { done.add(p.group); act(p); } };
    };
    button("+", "Zoom in", p => p.zoom(0.6, p.left + p.w / 2, p.top + p.h / 2));
    button("−", "Zoom out", p => p.zoom(1 / 0.6, p.left + p.w / 2, p.top + p.h / 2));
    button("all", "Show all", p => p.reset());
    const hint = holder.appendChild(document.createElement("p")); hint.className = "hint";
    hint.textContent = "Drag moves the curves; the wheel (after a click) or two fingers zoom; values stand below the pointer.";
    figure.classList.add("live");
    new ResizeObserver(() => panels.forEach(p => p.draw())).observe(holder);
  }
})();

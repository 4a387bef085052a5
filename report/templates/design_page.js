"use strict";
// Sliders, numbers and two pictures over Design.answer; the state stands in the address, so that a page can be sent as it is.
(() => {
  const study = JSON.parse(document.getElementById("study").textContent), get = id => document.getElementById(id);
  const groups = new Map();
  for (const point of study.points) { const rest = point.at.slice(1).join(" "); groups.set(rest, [...(groups.get(rest) || []), point]); }
  for (const rims of groups.values()) rims.sort((a, b) => a.at[0] - b.at[0]);
  const others = get("others");
  for (const rest of groups.keys()) others.add(new Option(study.vary.slice(1).map((key, i) => `${key.key} = ${rest.split(" ")[i]}`).join(", "), rest));
  others.parentElement.hidden = groups.size < 2;
  const rims = () => groups.get(others.value), number = id => Number(get(id).value);
  const said = (value, digits = 3) => value === null ? "not known" : Number(value.toPrecision(digits)).toLocaleString("en", { useGrouping: false, maximumSignificantDigits: digits });

  function bound() {
    const x = rims().map(p => p.at[0]), most = Design.fastest(rims(), number("mass"));
    Object.assign(get("x"), { min: x[0], max: x.at(-1), step: (x.at(-1) - x[0]) / 200 || 1 });
    Object.assign(get("speed"), { min: 0.01, max: Math.floor(1e3 * most) / 1e3, step: 0.001 });
  }
  function path(points, width, height, x, y) {
    return points.map(([a, b], i) => `${i ? "L" : "M"}${(48 + (width - 60) * (a - x[0]) / (x[1] - x[0] || 1)).toFixed(1)} ${(height - 34 - (height - 50) * (b - y[0]) / (y[1] - y[0] || 1)).toFixed(1)}`).join("");
  }
  function ticks(most) {
    const raw = most / 4, power = 10 ** Math.floor(Math.log10(raw)), step = power * [1, 2, 5, 10].find(s => s * power >= raw);
    return Array.from({ length: Math.floor(most / step + 1e-9) + 1 }, (_, k) => k * step);
  }
  function draw(id, points, mark, limit, xLabel, yLabel) {
    const [w, h] = [420, 250], x = [0, Math.max(...points.map(p => p[0]), mark[0])], y = [0, 1.05 * Math.max(...points.map(p => p[1]), limit || 0)];
    const to = (a, b) => path([[a, b]], w, h, x, y).slice(1).split(" ");
    const [mx, my] = to(...mark);
    get(id).innerHTML = ticks(y[1]).map(t => { const [, ty] = to(0, t); return `<path class=grid d="M48 ${ty}H${w - 12}"/><text x=44 y=${ty} dy=3 text-anchor=end>${said(t)}</text>`; }).join("")
      + ticks(x[1]).map(t => `<text x=${to(t, 0)[0]} y=${h - 20} text-anchor=middle>${said(t)}</text>`).join("")
      + `<text x=${w / 2} y=${h - 4} text-anchor=middle>${xLabel}</text><text x=48 y=10>${yLabel}</text>`
      + (limit ? `<path class=limit d="M48 ${to(0, limit)[1]}H${w - 12}"/>` : "") + `<path class=line d="${path(points, w, h, x, y)}"/><circle cx=${mx} cy=${my} r=4 />`;
  }
  function verdict(now, limits) {
    const rows = [["peak_kN", "peak force", "kN", limits.peak_kN], ["depth_mm", "depth", "mm", limits.depth_mm], ["rebound", "rebound", "m/s", limits.rebound_m_per_s],
      ["strain", "plastic strain of the rim", "", limits.strain ?? study.strain_limit]];
    let bad = 0, close = 0, unknown = 0;
    get("rows").innerHTML = rows.map(([name, words, unit, limit]) => {
      const { value, error } = now[name], curve = study.curve_error[{ peak_kN: "force", depth_mm: "depth", rebound: "restitution", strain: "strain" }[name]];
      const off = error === null ? null : Math.hypot(error, curve), worst = value === null ? null : value * (1 + (off ?? 0));
      const judged = limit === undefined || limit === null ? "" : value === null ? "not known" : worst <= limit ? "met" : value <= limit ? "met but for its error" : "not met";
      bad += judged === "not met", close += judged === "met but for its error", unknown += judged === "not known";
      return `<tr><th>${words}</th><td id="${name}">${said(value)} ${value === null ? "" : unit}</td><td>${off === null ? "not known" : off < 1e-3 ? "below 0.1 %" : `${said(100 * off, 2)} %`}</td><td>${limit ?? "–"}</td><td class="${judged === "not met" ? "bad" : ""}">${judged}</td></tr>`;
    }).join("");
    get("verdict").textContent = bad ? "A limit is not met." : close ? "A limit is met, but not with the error on top." : unknown ? "No limit is passed; one cannot be judged." : "Every limit is met, errors included.";
    get("verdict").className = bad || close ? "verdict bad" : "verdict";
  }
  function show() {
    bound();
    const [x, speed, mass] = [number("x"), number("speed"), number("mass")], now = Design.answer(rims(), x, speed, mass), most = Design.fastest(rims(), mass);
    const limits = { ...study.targets }, asked = get("target").value;
    asked === "" ? delete limits.peak_kN : limits.peak_kN = Number(asked);
    for (const [id, value, unit] of [["x", x, study.vary[0].key.split("_").at(-1)], ["speed", speed, "m/s"], ["mass", mass, "kg"]]) get(`${id}-said`).textContent = `${said(value, id === "mass" ? 6 : 3)} ${unit}`;
    verdict(now, limits);
    const speeds = Array.from({ length: 81 }, (_, i) => most * i / 80 * 0.9999), along = speeds.map(v => ({ v, is: Design.answer(rims(), x, v, mass) }));
    draw("over-speed", along.map(p => [p.v, p.is.peak_kN.value ?? 0]), [speed, now.peak_kN.value ?? 0], limits.peak_kN, "speed of approach (m/s)", "peak force (kN)");
    draw("over-depth", along.map(p => [p.is.depth_mm.value ?? 0, p.is.peak_kN.value ?? 0]), [now.depth_mm.value ?? 0, now.peak_kN.value ?? 0], limits.peak_kN, "depth (mm)", "force on the way in (kN)");
    history.replaceState(null, "", `#${new URLSearchParams({ x, speed, mass, target: asked, others: others.value })}`);
  }
  const given = new URLSearchParams(location.hash.slice(1));
  if (groups.has(given.get("others"))) others.value = given.get("others");
  const design = study.answer.design || rims()[0].at;
  Object.assign(get("mass"), { min: study.mass_kg / 4, max: 2 * study.mass_kg, step: study.mass_kg / 200, value: given.get("mass") || study.mass_kg });
  bound();
  get("x").value = given.get("x") || design[0], get("speed").value = given.get("speed") || study.speed_m_per_s;
  get("target").value = given.get("target") ?? study.targets.peak_kN ?? "";
  for (const id of ["x", "speed", "mass", "target", "others"]) get(id).addEventListener("input", show);
  show();
})();

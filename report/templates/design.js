"use strict";
// The rims of a study over their varied dimension, at any speed and mass. `answer` is what geometry --vary computes.
const Design = (() => {
  const columns = { peak_kN: "peak_kN", depth_mm: "depth_mm", rebound: "rebound_m_per_s_sqrt_kg", strain: "strain" };

  // Of one rim at a severity v sqrt(m), straight between the rows of its table; null beyond it or where it has no such column.
  function at(point, name, severity) {
    const x = point.over_severity.severity_m_per_s_sqrt_kg, y = point.over_severity[columns[name]];
    if (!y || !y.length || !(severity <= x[x.length - 1])) return null;
    const i = Math.min(x.length - 2, Math.floor(severity / x[1]));
    return y[i] + (y[i + 1] - y[i]) * (severity - x[i]) / (x[i + 1] - x[i]);
  }

  // A parabola in the logarithms through the three rims next to `x`; its distance from the straight line is its error.
  function between(rims, values, x) {
    const near = rims.findIndex(p => Math.abs(p.at[0] - x) <= 1e-9 * Math.abs(x));
    if (near >= 0) return { value: values[near], error: 0 };
    if (rims.length < 2) return { value: null, error: null };
    const logarithmic = values.every(v => v > 0), scaled = v => logarithmic ? Math.log(v) : v, back = v => logarithmic ? Math.exp(v) : v;
    let right = rims.findIndex(p => x < p.at[0]);
    right = Math.max(1, right < 0 ? rims.length - 1 : right);
    const left = right - 1, l = k => Math.log(rims[k].at[0]);
    const straight = back(scaled(values[left]) + (Math.log(x) - l(left)) / (l(right) - l(left)) * (scaled(values[right]) - scaled(values[left])));
    if (rims.length < 3) return { value: straight, error: null };
    let first = left;
    if (right + 1 === rims.length || (left > 0 && x - rims[left - 1].at[0] < rims[right + 1].at[0] - x)) first--;
    const k = [first, first + 1, first + 2];
    const curved = back(k.reduce((sum, i) => sum + k.filter(j => j !== i).reduce((w, j) => w * (Math.log(x) - l(j)) / (l(i) - l(j)), scaled(values[i])), 0));
    return { value: curved, error: Math.abs(straight / curved - 1) };
  }

  // All four numbers of a rim of dimension `x`, null where they are not known.
  function answer(rims, x, speed, mass) {
    const severity = speed * Math.sqrt(mass), said = { x, speed, mass };
    for (const name of Object.keys(columns)) {
      const values = rims.map(p => at(p, name, severity));
      said[name] = values.some(v => v === null) ? { value: null, error: null } : between(rims, values, x);
    }
    if (said.rebound.value !== null) said.rebound.value /= Math.sqrt(mass);
    return said;
  }
  const fastest = (rims, mass) => Math.min(...rims.map(p => p.over_severity.severity_m_per_s_sqrt_kg.at(-1))) / Math.sqrt(mass);
  return { answer, fastest };
})();

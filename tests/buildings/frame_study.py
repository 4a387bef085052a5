#!/usr/bin/env python3
"""frame_study.py RIMPACT FOLDER [TABLE]: the inelastic frame of thesis 2.5 on three isolators of five curvatures under the records
of table 2-2 at hand, and 2.5.3's sensitivity, beside what the thesis prints. Writes FOLDER/frame_2_5.txt; with TABLE it must say the
same. Exit 1 where a gate fails, 77 without the records (RIMPACT_RECORDS names their folder)."""
import json
import os
import subprocess
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../.."), os.path.join(HERE, "..")]
from stored_table import differ  # noqa: E402

from report.thesis.spectrum import design_spectrum, pseudo_acceleration, read_at2  # noqa: E402

# Both horizontal components of table 2-2's records as far as they are at hand.
RECORDS = {
    1: ("RSN6_IMPVALL.I_I-ELC180", "RSN6_IMPVALL.I_I-ELC270"), 2: ("RSN68_SFERN_PEL090", "RSN68_SFERN_PEL180"),
    3: ("RSN170_IMPVALL.H_H-ECC092",), 4: ("RSN179_IMPVALL.H_H-E04140", "RSN179_IMPVALL.H_H-E04230"),
    5: ("RSN182_IMPVALL.H_H-E07140", "RSN182_IMPVALL.H_H-E07230"), 6: ("RSN183_IMPVALL.H_H-E08140", "RSN183_IMPVALL.H_H-E08230"),
    7: ("RSN185_IMPVALL.H_H-HVP225", "RSN185_IMPVALL.H_H-HVP315"), 8: ("RSN187_IMPVALL.H_H-PTS225", "RSN187_IMPVALL.H_H-PTS315"),
    11: ("RSN776_LOMAP_HSP000", "RSN776_LOMAP_HSP090"), 13: ("FOR090",), 14: ("RSN828_CAPEMEND_PET000", "RSN828_CAPEMEND_PET090"),
    15: ("RIO270", "RIO360"), 16: ("RSN879_LANDERS_LCN260", "RSN879_LANDERS_LCN345"), 17: ("RSN982_NORTHR_JEN022", "RSN982_NORTHR_JEN292"),
    18: ("RSN1063_NORTHR_RRS228", "RSN1063_NORTHR_RRS318"), 19: ("RSN1086_NORTHR_SYL090", "RSN1086_NORTHR_SYL360"),
    20: ("RSN1087_NORTHR_TAR090", "RSN1087_NORTHR_TAR360")}
SHAPES = (1.00, 0.40, 0.35, 0.30, 0.25)  # a / R0
PRINTED_HITS = {4, 8, 9, 11, 14, 19}
PERIODS = np.geomspace(0.5, 3.0, 40)
G = 9.81
SCENE = """[bearing]
name = "shfps-225"
[excitation]
kind = "record"
x = "{path}"
duration_s = {duration:.6g}
scale = {scale:.6g}
[isolator]
step_tolerance = 3e-4
[reduced]
mu_slow = 0.07
mu_fast = 0.07
k_i_kN_per_m = 4.5e5
restitution = 0.65
elastic_slip_mm = 1.0
output_step_ms = 50.0
"""


def component(records, names):
    """(path, time step, acceleration [g]) of the component with the larger velocity."""
    read = [(path, *read_at2(path)) for path in (os.path.join(records, f"{name}.AT2") for name in names)]
    return max(read, key=lambda r: np.abs(np.cumsum(r[2]) * r[1]).max())


def scale_of(dt, ground):
    """Geometric mean over the periods of the MCE spectrum over the record's."""
    return float(np.exp(np.mean(np.log(design_spectrum(PERIODS, 1.67, 0.62) / pseudo_acceleration(dt, ground, PERIODS)))))


def matched(dt, ground):
    """The record with its Fourier amplitudes, not its phases, changed until its spectrum is the MCE's; and the largest share by which
    it still differs over PERIODS."""
    periods = np.geomspace(0.1, 4.0, 60)
    target, size = design_spectrum(periods, 1.67, 0.62), 1 << int(np.ceil(np.log2(2 * len(ground))))
    frequencies = np.fft.rfftfreq(size, dt)
    here, best = ground * scale_of(dt, ground), None
    for _ in range(8):
        ratio = target / pseudo_acceleration(dt, here, periods)
        within = (periods >= PERIODS[0]) & (periods <= PERIODS[-1])
        off = float(np.abs(1 - 1 / ratio[within]).max())
        if best is None or off < best[1]:
            best = (here, off)
        factor = np.interp(np.log(np.maximum(frequencies, 1e-9)), np.log(1 / periods[::-1]), ratio[::-1])
        here = np.fft.irfft(np.fft.rfft(here, size) * factor, size)[:len(ground)]
    return best


def write_at2(path, dt, ground):
    rows = ["".join(f"{a:15.7E}" for a in ground[i:i + 5]) for i in range(0, len(ground), 5)]
    with open(path, "w") as file:
        file.write(f"PEER NGA STRONG MOTION DATABASE RECORD\nmatched\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= {len(ground)}, DT= {dt:.6g} SEC\n" + "\n".join(rows) + "\n")


class Study:
    def __init__(self, rimpact, records, folder):
        self.rimpact, self.folder, self.off = rimpact, folder, 0.0
        os.makedirs(folder, exist_ok=True)
        self.motions = {}
        for number, names in RECORDS.items():
            if not all(os.path.isfile(os.path.join(records, f"{name}.AT2")) for name in names):
                continue
            path, dt, ground = component(records, names)
            scale = scale_of(dt, ground)
            (ground, off), path = matched(dt, ground), os.path.join(folder, f"GM{number}.AT2")
            self.off = max(self.off, off)
            write_at2(path, dt, ground)
            self.motions[number] = (path, min(30.0, dt * (len(ground) - 1)), scale)

    def run(self, number, shape, *settings, factor=1.0):
        path, duration, _ = self.motions[number]
        scene = os.path.join(self.folder, "scene.toml")
        with open(scene, "w") as file:
            file.write(SCENE.format(path=os.path.abspath(path), duration=duration, scale=factor))
        command = [self.rimpact, "building", scene, "--frame", "thesis-2.5", "-o", os.path.join(self.folder, "run"), "--json", "--quiet", "--force"]
        for setting in (f"bearing.surface.a_m={2.25 * shape:.6g}", *settings):
            command += ["--set", setting]
        answer = subprocess.run(command, capture_output=True, text=True)
        if not answer.stdout:
            raise SystemExit(f"GM{number}, a = {shape} R0: {answer.stderr}")
        s = json.loads(answer.stdout)
        b = s["building"]
        sections = {c["name"]: c for c in b["inelastic"]["sections"]}
        return {"u": b["peak_base_displacement_m"], "V": b["peak_base_shear_N"] / b["weight_N"], "hit": len(s["impacts"]),
                "rim": s["peak_impact_force_N"], "drift": [f["peak_drift_m"] for f in b["floors"]], "status": s["status"],
                "ductility": max(c["peak_ductility"] for c in sections.values()), "imbalance": abs(s["energy"]["imbalance_relative"]),
                "seconds": s["wall_time_s"]}


def change(value, reference):
    return 100 * (value / reference - 1)


def five_shapes(study, lines, fails):
    answers = {}
    lines += ["Scale: of the record as a whole, before matching. Peaks: base displacement (mm), base shear / W_s, drifts of storeys 1 2 3 (mm), "
              "* a rim is hit; a / R0 = " + ", ".join(f"{a:.2f}" for a in SHAPES),
              "GM  scale  " + "".join(f"| {a:4.2f}: u_b   V/W   drifts               " for a in SHAPES)]
    for n, (_, _, scale) in study.motions.items():
        row = f"{n:2d}  {scale:5.2f}  "
        for a in SHAPES:
            r = answers[n, a] = study.run(n, a)
            row += f"| {1e3 * r['u']:6.1f}{'*' if r['hit'] else ' '} {r['V']:6.3f}  " + " ".join(f"{1e3 * d:6.1f}" for d in r["drift"]) + "   "
        lines.append(row.rstrip())
        print(lines[-1], file=sys.stderr, flush=True)
    mean = {a: {"u": np.mean([answers[n, a]["u"] for n in study.motions]), "V": np.mean([answers[n, a]["V"] for n in study.motions]),
                "drift": np.mean([answers[n, a]["drift"] for n in study.motions], axis=0)} for a in SHAPES}
    lines.append("mean       " + "".join(f"| {1e3 * mean[a]['u']:6.1f}  {mean[a]['V']:6.3f}  " + " ".join(f"{1e3 * d:6.1f}" for d in mean[a]["drift"]) + "   " for a in SHAPES).rstrip())
    lines += ["", "Means against FPS (a = 1.00 R0), %:            u_b    V/W    drift 1 drift 2 drift 3"]
    for a in SHAPES[1:]:
        values = [change(mean[a][k], mean[1.0][k]) for k in ("u", "V")] + list(change(mean[a]["drift"], mean[1.0]["drift"]))
        lines.append(f"  a = {a:.2f} R0                                 " + " ".join(f"{v:+6.1f} " for v in values).rstrip())
    lines.append("  the thesis                                    -5 (a = 0.30), up to -44, -11, -8, -6 (a = 0.35)")
    hits = {a: sorted(n for n in study.motions if answers[n, a]["hit"]) for a in SHAPES}
    lines.append("")
    for a in SHAPES:
        lines.append(f"Hit at a = {a:.2f} R0: " + (", ".join(f"GM{n}" for n in hits[a]) or "none"))
    at_hand = sorted(PRINTED_HITS & set(study.motions))
    lines.append("The thesis, FPS:   " + ", ".join(f"GM{n}" for n in sorted(PRINTED_HITS)) + f" (at hand {', '.join(f'GM{n}' for n in at_hand)}); "
                 "avoided by SH-FPS in GM4 and GM8, weaker in the others")
    both = sorted(set(hits[1.0]) & PRINTED_HITS)
    lines.append(f"Of those at hand that hit in the thesis, hit here: {len(both)} of {len(at_hand)}; "
                 f"of the others, hit here: {len(set(hits[1.0]) - PRINTED_HITS)} of {len(study.motions) - len(at_hand)}")
    worst = max(answers.values(), key=lambda r: r["imbalance"])["imbalance"]
    lines.append(f"Largest curvature ductility {max(r['ductility'] for r in answers.values()):.1f}; energy imbalance at most 1e-3: {'yes' if worst <= 1e-3 else 'no'}")
    for (n, a), r in answers.items():
        if r["status"] != "done":
            fails.append(f"GM{n}, a = {a} R0: {r['status']}")
    if not mean[0.35]["V"] < mean[1.0]["V"]:
        fails.append("a = 0.35 R0 does not lower the mean base shear; the thesis up to 44 %")
    if worst > 1e-3:
        fails.append(f"energy imbalance {worst:.1e}")
    return max(r["seconds"] for r in answers.values())


def sensitivity(study, lines):
    """2.5.3: Hollister on FPS; at the least scale of the study's, in steps of 5 %, that hits."""
    lines += ["", "2.5.3, GM11 on FPS: changes of base shear, drifts 1 2 3 (%) against k_i 4.5e5 kN/m, e 0.65"]
    for factor in np.arange(1.0, 2.0, 0.05):
        base = study.run(11, 1.0, factor=factor)
        if not base["hit"]:
            continue
        lines.append(f"scale {factor:.2f} x MCE: V/W {base['V']:.3f}, drift 1 {1e3 * base['drift'][0]:.1f} mm, {base['hit']} impacts of bearings")
        for words, setting, printed in ([(f"k_i x {k:.2f}", f"reduced.k_i_kN_per_m={4.5e5 * k:.6g}", "+32, +6, less, less" if k == 1.5 else "") for k in (0.5, 0.75, 1.25, 1.5)] +
                                        [(f"e = {e:.2f}  ", f"reduced.restitution={e}", "+10, +10" if e == 0.7 else "") for e in (0.4, 0.5, 0.6, 0.7)]):
            r = study.run(11, 1.0, setting, factor=factor)
            values = [change(r["V"], base["V"])] + [change(d, b) for d, b in zip(r["drift"], base["drift"])]
            lines.append(f"  {words}  " + " ".join(f"{v:+6.1f}" for v in values) + (f"   thesis {printed}" if printed else ""))
        return


ASSUMED = (
    "Ours, as the thesis does not give it: sections (docs/guide/buildings.md), the component of a record (that of the larger velocity), how its spectrum",
    "(5 %) is made the MCE's (site class C), no vertical motion, friction of 0.07 at every speed, 30 s at most.",
    "Records not at hand: GM9, GM10, GM12; of GM3 and GM13 one component.")


def starred(line):
    """A hit's star as a word of its own; a light touch more or less moves a peak by 2 %."""
    return line.replace("*", " * ")


def main(rimpact, folder, baseline=None):
    records = os.environ.get("RIMPACT_RECORDS", os.path.join(HERE, "../../../shared/records"))
    if not os.path.exists(os.path.join(records, "RSN776_LOMAP_HSP000.AT2")):
        print(f"no records in {records} (set RIMPACT_RECORDS)")
        return 77
    fails = []
    lines = ["Thesis 2.5: inelastic frame of three storeys on three isolators, R0 2.25 m, L_c 0.40 m, mu 0.07, k_i 4.5e5 kN/m, e 0.65", *ASSUMED]
    study = Study(rimpact, records, folder)
    lines += ["", f"Records matched to the MCE spectrum by their Fourier amplitudes, within {100 * study.off:.0f} % over 0.5 to 3 s", ""]
    slowest = five_shapes(study, lines, fails)
    sensitivity(study, lines)
    with open(os.path.join(folder, "frame_2_5.txt"), "w") as file:
        file.write("\n".join(lines) + "\n")
    print("\n".join(lines), f"\nslowest run {slowest:.1f} s")
    if baseline:
        with open(baseline) as file:
            stored = file.read().splitlines()
        fails += [f"now:   {p}\ntable: {q}" for p, q in zip(lines, stored) if differ(starred(p), starred(q), 0.02, 0.2)]
        if len(lines) != len(stored):
            fails.append(f"{len(lines)} lines, {len(stored)} in the table")
    print("\n".join(["", *fails]) if fails else "every gate holds")
    return 1 if fails else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

#!/usr/bin/env python3
"""thesis_buildings.py RIMPACT FOLDER [TABLE]: the building of thesis 2.4 on six bearings under its records, beside what the
thesis prints, and that of 3.5 on six DCFP and six LIR-DCFP bearings. Writes FOLDER/thesis.txt; with TABLE it must
say the same. Exit 1 where a gate fails, 77 without the records (RIMPACT_RECORDS names their folder)."""
import json
import os
import re
import subprocess
import sys

import h5py
import numpy as np

PETROLIA = ("RSN828_CAPEMEND_PET000.AT2", "RSN828_CAPEMEND_PET090.AT2")
EL_CENTRO = ("RSN179_IMPVALL.H_H-E04140.AT2", "RSN179_IMPVALL.H_H-E04230.AT2")
NEWHALL = ("RSN1044_NORTHR_NWH090.AT2", "RSN1044_NORTHR_NWH360.AT2")
COMMON = ["load.vertical_kN=853.0", "reduced.mu_fast=0.07", "reduced.mu_slow=0.04", "reduced.rate_s_per_m=20", "reduced.tolerance=1e-7",
          "reduced.elastic_slip_mm=0.5", "excitation.duration_s=25"]
G = 9.81
# Tables 3-8 to 3-10 by bearing: lateral force x, y, vertical force [kN] and residual interface slip x, y, residual
# displacement x, y [cm] of isolators 1 to 6; drifts [permil] of storeys 1 2 3 by x y; accelerations [g] of base, floors 1 2, roof by x y.
PRINTED = {
    "Newhall": {
        "dcfp": ([(276, 39, 487), (432, 98, 1466), (356, 63, 992), (277, 32, 542), (435, 101, 1539), (359, 67, 1078)],
                 (2.550, 1.092, 2.432, 1.281, 2.228, 1.088), (0.86, 0.47, 0.64, 0.20, 0.65, 0.21, 1.00, 0.39)),
        "lir-dcfp": ([(85, 31, 351), (321, 105, 1290), (185, 60, 728), (122, 28, 491), (357, 107, 1501), (210, 62, 866)],
                     (1.483, 1.093, 1.291, 1.282, 0.948, 1.090), (0.39, 0.34, 0.31, 0.17, 0.30, 0.21, 0.33, 0.38)),
        "residual": [(1.64, 0.47, 2.55, 2.27), (1.15, 0.32, 2.55, 2.33), (1.44, 0.39, 2.55, 2.38), (1.62, 0.48, 2.49, 2.27),
                     (1.11, 0.32, 2.49, 2.33), (1.39, 0.39, 2.49, 2.38)],
        "touch": 4.24, "axis": "x", "less shear": 42, "roof": (1.00, 0.33)},
    "Petrolia": {
        "dcfp": ([(180, 572, 1624), (211, 613, 2465), (178, 548, 1988), (257, 645, 2869), (306, 692, 3014), (228, 606, 1472)],
                 (1.694, 5.034, 1.860, 5.363, 1.741, 5.469), (0.60, 2.05, 0.60, 1.23, 0.69, 1.22, 0.63, 1.95)),
        "lir-dcfp": ([(112, 238, 806), (156, 302, 1638), (76, 198, 872), (191, 347, 1209), (259, 466, 1899), (150, 289, 777)],
                     (1.250, 2.724, 1.074, 2.413, 0.812, 1.909), (0.31, 0.70, 0.25, 0.39, 0.30, 0.53, 0.39, 0.69)),
        "residual": [(1.29, 2.94, 0.24, 0.67), (1.53, 2.89, 0.24, 0.65), (1.27, 2.85, 0.24, 0.64), (1.52, 2.69, 0.25, 0.67),
                     (1.65, 2.75, 0.25, 0.66), (1.47, 2.76, 0.25, 0.64)],
        "touch": 3.2, "axis": "y", "less shear": 54, "roof": (1.95, 0.69)}}
# Table 3-1 names NWH360 in section 3.4, and the impact is "mainly in the global x-direction": x is NWH360.
GROUND = {"Newhall": ("RSN1044_NORTHR_NWH360.AT2", "RSN1044_NORTHR_NWH090.AT2"), "Petrolia": PETROLIA}
ISOLATORS = """[isolator]
space = "spatial"
points = 4
radius_m = 1.55
capacity_m = 0.30
slider_diameter_mm = 300.0
top_height_mm = 70.0
bottom_height_mm = 30.0
top_wall_mm = 40.0
bottom_wall_mm = 10.0
"""
FRAME = """name = "thesis-3.5"
x_m = [0.0, 8.0, 16.0]
y_m = [0.0, 8.0]
storeys_m = [3.5, 3.5, 3.5]
column_x_mm = 700.0
column_y_mm = 700.0
beam_width_mm = 400.0
beam_depth_mm = 700.0
"""


class Runs:
    def __init__(self, rimpact, records, folder):
        self.rimpact, self.records, self.folder = rimpact, records, folder
        os.makedirs(folder, exist_ok=True)

    def fly(self, name, record, bearing, settings=(), frame="thesis-2.4"):
        scene = os.path.join(self.folder, f"{name}.toml")
        with open(scene, "w") as file:
            file.write(f'{bearing}\n[excitation]\nkind = "record"\n' +
                       "".join(f'{axis} = "{os.path.abspath(self.records)}/{file_name}"\n' for axis, file_name in zip("xy", record)))
        out = os.path.join(self.folder, name)
        command = [self.rimpact, "building", scene, "-o", out, "--frame", frame, "--force", "--json", "--quiet"]
        for assignment in [*COMMON, *settings]:
            command += ["--set", assignment]
        run = subprocess.run(command, capture_output=True, text=True)
        if run.returncode not in (0, 4):  # 4: the slider left; what is before it counts
            raise SystemExit(f"{name}: {run.stderr}")
        with h5py.File(os.path.join(out, "response.h5")) as file:
            signals = {key: file[f"response/{key}"][:] for key in file["response"]}
        return json.loads(run.stdout), signals


def peaks(summary, signals):
    b = summary["building"]
    return {"travel": summary["peak_displacement_m"], "shear": summary["peak_lateral_force_N"],
            "shear_x": np.abs(signals["force_x"]).max(), "shear_y": np.abs(signals["force_y"]).max(),
            "drift_x": b["floors"][0]["peak_drift_x_m"], "drift_y": b["floors"][0]["peak_drift_y_m"],
            "drift3_y": b["floors"][2]["peak_drift_y_m"], "impacts": sum(x["impacts"] > 0 for x in b["bearings"]),
            "touch": summary["impacts"][0]["touch_time_s"] if summary["impacts"] else None,
            "direction": summary["impacts"][0]["direction_deg"] if summary["impacts"] else None,
            "imbalance": abs(summary["energy"]["imbalance_relative"])}


def change(a, b):
    return 100 * (b / a - 1)


def chapter_2(runs, lines, fails):
    lines.append("Thesis 2.4: three storeys on six bearings, rim k_i 4.5e5 kN/m, e 0.65; SH-FPS against FPS")
    lines.append(f"{'':44}{'here':>10}{'thesis':>10}")
    answer = {}
    for record, files in (("Petrolia", PETROLIA), ("El Centro #4", EL_CENTRO)):
        for bearing in ("fps-225", "shfps-225"):
            name = f"{record.split()[0].lower()}-{bearing}"
            answer[record, bearing] = peaks(*runs.fly(name, files, f'[bearing]\nname = "{bearing}"'))
            if not answer[record, bearing]["imbalance"] <= 1e-5:
                fails.append(f"{name}: energy imbalance {answer[record, bearing]['imbalance']:.1e}, bound 1e-5")
    row = lambda what, here, thesis: lines.append(f"{what:44}{here:>10}{thesis:>10}")
    a, b = answer["Petrolia", "fps-225"], answer["Petrolia", "shfps-225"]
    row("Petrolia: bearings that hit, FPS", a["impacts"], 0)
    row("Petrolia: bearings that hit, SH-FPS", b["impacts"], 0)
    for what, key, thesis in (("base displacement", "travel", "-3 %"), ("base shear", "shear", "+12.5 %"),
                              ("first storey's drift in y", "drift_y", "+2.7 %"), ("first storey's drift in x", "drift_x", "no rise")):
        row(f"Petrolia: {what}", f"{change(a[key], b[key]):+.1f} %", thesis)
    if a["impacts"] or b["impacts"]:
        fails.append("Petrolia hits a rim; the thesis has no impact")
    if not (-6 < change(a["travel"], b["travel"]) < 0 and 5 < change(a["shear"], b["shear"]) < 20):
        fails.append("Petrolia: displacement or base shear is not near the thesis's change")
    a, b = answer["El Centro #4", "fps-225"], answer["El Centro #4", "shfps-225"]
    row("El Centro #4: bearings that hit, FPS", a["impacts"], 6)
    row("El Centro #4: bearings that hit, SH-FPS", b["impacts"], 0)
    if a["touch"]:
        row("El Centro #4: first touch, FPS (s)", f"{a['touch']:.2f}", "6")
        row("El Centro #4: its direction (deg)", f"{a['direction']:.0f}", "y")
    row("El Centro #4: travel, FPS (mm)", f"{1e3 * a['travel']:.1f}", "400")
    row("El Centro #4: travel, SH-FPS (mm)", f"{1e3 * b['travel']:.1f}", "< 400")
    row("El Centro #4: base shear y, FPS / SH-FPS", f"{a['shear_y'] / b['shear_y']:.2f}", "2.4")
    row("El Centro #4: base shear x, FPS / SH-FPS", f"{a['shear_x'] / b['shear_x']:.2f}", "2.0")
    row("El Centro #4: first drift x, SH-FPS", f"{change(a['drift_x'], b['drift_x']):+.1f} %", "-37 %")
    row("El Centro #4: third drift y, SH-FPS", f"{change(a['drift3_y'], b['drift3_y']):+.1f} %", "-57 %")
    if b["impacts"]:
        fails.append("El Centro #4: SH-FPS hits a rim; the thesis's does not")
    lines.append("")


def during_impact(signals, bearing, first, last):
    """Largest lateral and vertical forces between first touch and last release [kN]."""
    t = signals["time"]
    window = (t >= first - 1e-9) & (t <= last + 1e-9)
    return [np.abs(signals[f"bearing_{bearing}_{what}"][window]).max() / 1e3 for what in ("force_x", "force_y", "normal_force")]


DIFFERENCES = (
    "Why they may differ: the dashpot of rim and stop is of the whole supported mass here, (3-46) leaves it out, so that LIR-DCFP bearings push harder at the touch;",
    "elastic slip and k of the contact points are not printed; slabs are rigid and beams one member long here, so vertical forces during an impact differ;",
    "largest forces of one bearing within an impact are known to 10 % at this step tolerance (sums in another order alone move them by so much);",
    "on DCFP in Petrolia the slider of bearing 3 leaves its 2 cm rim at 3.36 s here and the run ends there; why was not traced, nor were the causes above run one by one.")


def chapter_3(runs, lines, fails):
    frame = os.path.join(runs.folder, "thesis-3.5.toml")
    with open(frame, "w") as file:
        file.write(FRAME)
    settings = ["reduced.mu_slow=0.0467", "reduced.rate_s_per_m=20", "reduced.k_i_kN_per_m=4.0e4", "reduced.elastic_slip_mm=1",
                "excitation.duration_s=12", "isolator.step_tolerance=1e-4"]
    lines.append("Thesis 3.5: three storeys on six bearings of rigid bodies, four points a set; columns 70 x 70, beams 40 x 70; k_imp 4e4 kN/m, e 0.65,")
    lines.append("mu 0.047 to 0.07, mu_s 0.15; x is NWH360; here | thesis. Forces: the largest between the first touch and the last release in 0.5 s of it.")
    for record, files in GROUND.items():
        printed, kept = PRINTED[record], {}
        for model in ("dcfp", "lir-dcfp"):
            summary, signals = runs.fly(f"{model}-{record.lower()}", files, ISOLATORS, [*settings, f"reduced.model={model}"], frame)
            kept[model] = signals
            impacts = summary["impacts"]
            if not impacts:
                fails.append(f"3.5 {record} {model}: no impact")
                continue
            first = impacts[0]["touch_time_s"]
            last = max(i["release_time_s"] or first for i in impacts if i["touch_time_s"] < first + 0.5)
            imbalance = abs(summary["energy"]["imbalance_relative"])
            forces, drifts, accelerations = printed[model]
            if summary["status"] != "done":
                lines.append(f"{record}, {model} ends early: {re.sub(r'[0-9]+[.][0-9]+', lambda m: f'{float(m[0]):.2f}', summary['reason'])}")
            lines.append(f"{record}, {model}: first touch {first:.2f} s | {printed['touch']:g}; energy imbalance at most 1e-5: {'yes' if imbalance <= 1e-5 else 'no'}")
            for i, row in enumerate(forces, 1):
                here = during_impact(signals, i, first, last)
                lines.append(f"  force {i} (kN) x, y, vertical      " + " ".join(f"{v:6.0f}" for v in here) + "  | " + " ".join(f"{v:5g}" for v in row))
            here = [1e3 * np.abs(signals[f"floor_{i}_drift_{axis}"]).max() / 3.5 for i in (1, 2, 3) for axis in "xy"]
            lines.append("  drift (permil) 1 2 3, x y         " + " ".join(f"{v:6.2f}" for v in here) + "  | " + " ".join(f"{v:5.2f}" for v in drifts))
            levels = ["base_acceleration"] + [f"floor_{i}_acceleration" for i in (1, 2, 3)]
            here = [np.abs(signals[f"{level}_{axis}"]).max() / G for level in levels for axis in "xy"]
            lines.append("  acceleration (g) base 1 2 roof, x y " + " ".join(f"{v:4.2f}" for v in here) + "  | " + " ".join(f"{v:4.2f}" for v in accelerations))
            if not abs(first - printed["touch"]) < 0.1:
                fails.append(f"3.5 {record} {model}: first touch {first:.2f} s, the thesis's {printed['touch']}")
        if len(kept) < 2:
            continue
        late = np.searchsorted(kept["lir-dcfp"]["time"], 10.0)
        if late >= len(kept["lir-dcfp"]["time"]):
            continue
        for i, row in enumerate(printed["residual"], 1):
            here = [100 * abs(kept["lir-dcfp"][f"bearing_{i}_{what}"][late]) for what in ("interface_slip_x", "interface_slip_y", "displacement_x", "displacement_y")]
            lines.append(f"  at 10 s {i} (cm) slip x y, plate x y " + " ".join(f"{v:5.2f}" for v in here) + "  | " + " ".join(f"{v:5.2f}" for v in row))
        axis = printed["axis"]
        shear = [np.abs(kept[m][f"force_{axis}"]).max() for m in ("dcfp", "lir-dcfp")]
        roof = [np.abs(kept[m][f"floor_3_acceleration_{axis}"]).max() / G for m in ("dcfp", "lir-dcfp")]
        lines.append(f"  base shear {axis}, lir-dcfp: {100 * (1 - shear[1] / shear[0]):.0f} % less | {printed['less shear']} %; roof {axis} {roof[0]:.2f} -> {roof[1]:.2f} g | {printed['roof'][0]:.2f} -> {printed['roof'][1]:.2f} g")
        if not shear[1] < 0.8 * shear[0]:
            fails.append(f"3.5 {record}: the interface spares {100 * (1 - shear[1] / shear[0]):.0f} % of the base shear; the thesis {printed['less shear']}")
    lines.extend(DIFFERENCES)


def differ(now, stored):
    """Words equal, numbers within 2 % or one of their last digits; largest forces within an impact, which sums in another order alone move by 10 %, within 12 %."""
    a, b = now.split(), stored.split()
    near = 0.12 if "kN) x, y, vertical" in now else 0.02
    if len(a) != len(b):
        return True
    for p, q in zip(a, b):
        try:
            if abs(float(p) - float(q)) > max(near * abs(float(q)), 0.1):
                return True
        except ValueError:
            if p != q:
                return True
    return False


def main(rimpact, folder, baseline=None):
    beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../shared/records")
    records = os.environ.get("RIMPACT_RECORDS", beside)
    if not os.path.exists(os.path.join(records, PETROLIA[0])):
        print(f"no records in {records} (set RIMPACT_RECORDS)")
        return 77
    runs, lines, fails = Runs(rimpact, records, folder), [], []
    chapter_2(runs, lines, fails)
    chapter_3(runs, lines, fails)
    with open(os.path.join(folder, "thesis.txt"), "w") as file:
        file.write("\n".join(lines) + "\n")
    print("\n".join(lines))
    if baseline:
        with open(baseline) as file:
            stored = file.read().splitlines()
        fails += [f"now:   {p}\ntable: {q}" for p, q in zip(lines, stored) if differ(p, q)]
        if len(lines) != len(stored):
            fails.append(f"{len(lines)} lines, {len(stored)} in the table")
    print("\n".join(["", *fails]) if fails else "every gate holds")
    return 1 if fails else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

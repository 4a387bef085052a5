"""slider_study.py RIMPACT FOLDER [BASELINE]: thesis 3.4 under Newhall 360, case by case beside tables 3-2 to 3-7.

Prints every number of the tables with ours, their ratio and a word on the difference; compares ours with BASELINE to
1 % (5 kN, 1 mm). Exit 77: the record is absent (RIMPACT_RECORDS names its folder)."""
import json
import os
import subprocess
import sys

RECORD = "RSN1044_NORTHR_NWH360.AT2"
COLUMNS = ["lateral, kN", "vertical max, kN", "vertical min, kN", "moment, kN m", "interface slip, mm", "plate residual, mm"]
POINTS = [f"{end} {point}, kN" for point in ("A1", "A5", "B1", "B5", "C1", "C5") for end in ("max", "min")]
# tables 3-2, 3-4, 3-6 and beside them 3-3, 3-5, 3-7
THESIS = {
    ("slenderness", 0.33): ([495, 2205, 1835, 316, 18, 5], [471, 385, 423, 322, 417, 281, 469, 387, 480, 397, 415, 316]),
    ("slenderness", 0.66): ([503, 2091, 1846, 344, 24, 1], [502, 375, 428, 278, 429, 221, 533, 376, 512, 398, 407, 284]),
    ("slenderness", 1.00): ([481, 2073, 1832, 359, 14, 0], [513, 360, 444, 249, 445, 201, 559, 362, 495, 395, 406, 296]),
    ("gap", 0.30): ([491, 2061, 1828, 327, 16, 1], [472, 378, 425, 297, 425, 256, 496, 378, 482, 397, 408, 314]),
    ("gap", 0.60): ([488, 2058, 1840, 323, 13, 1], [468, 377, 426, 308, 424, 257, 496, 380, 497, 397, 405, 300]),
    ("gap", 0.90): ([497, 2060, 1837, 328, 18, 1], [482, 380, 423, 301, 424, 245, 507, 380, 505, 397, 409, 290]),
    ("heights", 0.70): ([481, 2098, 1834, 326, 9, 5], [456, 376, 430, 314, 430, 271, 482, 379, 463, 394, 407, 331]),
    ("heights", 1.00): ([481, 2078, 1828, 327, 10, 5], [460, 378, 425, 307, 424, 272, 478, 380, 473, 397, 406, 323]),
    ("heights", 1.40): ([489, 2079, 1823, 333, 12, 5], [462, 379, 423, 301, 423, 268, 483, 381, 483, 393, 412, 312]),
}
D, R_EFF, H_ASSUMED, WALL = 310.0, 3000.0, 155.0, 10.0


def settings(study, ratio):
    """Geometry [mm] of a case; (3-91) to (3-94). The height of the gap and height cases is not printed."""
    height = ratio * D if study == "slenderness" else H_ASSUMED
    top = height * (ratio / (1 + ratio) if study == "heights" else 0.5)
    edge = D * ratio / (2 * (1 + ratio)) if study == "gap" else 50.0
    return {"radius_m": (R_EFF + height) / 2e3, "top_height_mm": top, "bottom_height_mm": height - top,
            "top_wall_mm": edge, "bottom_wall_mm": WALL}


def run(rimpact, folder, record, study, ratio):
    command = [rimpact, "reduced", "lir-dcfp-slider-study", "--quiet", "-o", folder, "--set", f'excitation.x="{record}"']
    for key, value in settings(study, ratio).items():
        command += ["--set", f"isolator.{key}={value!r}"]
    subprocess.run(command, check=True, capture_output=True)
    with open(folder + "/summary.json") as file:
        s = json.load(file)
    i = s["isolator"]
    whole = [s["peak_lateral_force_N"] / 1e3, i["max_vertical_force_N"] / 1e3, i["min_vertical_force_N"] / 1e3,
             i["max_moment_N_m"] / 1e3, i["residual_interface_slip_m"] * 1e3, s["residual_displacement_m"] * 1e3]
    force = i["point_forces"]
    points = [force[p][f"{end}_N"] / 1e3 for p in ("A1", "A5", "B1", "B5", "C1", "C5") for end in ("max", "min")]
    return whole, points


def word(column, ours, thesis):
    """What is known of a difference; nothing is claimed that was not tried."""
    if "mm" in column:
        if abs(ours - thesis) < 3:
            return "same within 3 mm"
        return "pushed less, as the rim's force is smaller" if "slip" in column else "rests elsewhere within the friction's width"
    if abs(ours / thesis - 1) < 0.03:
        return "same within 3 %"
    if column.startswith("lateral"):
        return "not explained; k_imp x 5 closes 60 % of it at slenderness 0.33"
    if column.startswith("vertical"):
        return "not explained; (3-46) would damp less (not tried)"
    if column.startswith("moment"):
        return "ours about the plate's vertex, the thesis's point is not said"
    return "more even than the thesis's points" if abs(ours - 393) < abs(thesis - 393) else "less even than the thesis's points"


def main(rimpact, folder, baseline=None):
    records = os.environ.get("RIMPACT_RECORDS", os.path.join(os.path.dirname(__file__), "../../../../shared/records"))
    record = os.path.abspath(os.path.join(records, RECORD))
    if not os.path.exists(record):
        print(f"skipped: {RECORD} is not in {records} (set RIMPACT_RECORDS)")
        return 77
    lines = []
    for (study, ratio), (whole, points) in THESIS.items():
        ours = run(rimpact, f"{folder}/{study}-{ratio}", record, study, ratio)
        for columns, published, values in ((COLUMNS, whole, ours[0]), (POINTS, points, ours[1])):
            for column, thesis, value in zip(columns, published, values):
                quotient = f"{value / thesis:6.3f}" if thesis and "mm" not in column else "      "
                lines.append(f"{study:11} {ratio:4.2f}  {column:20} {value:8.1f} {thesis:8.0f} {quotient}  {word(column, value, thesis)}")
    print(f"{'case':17} {'':20} {'ours':>8} {'thesis':>8} {'ratio':>6}")
    print("\n".join(lines))
    if baseline is None:
        return 0
    values_of = lambda rows: {row[:39]: float(row[39:47]) for row in rows if not row.startswith("case")}
    now, stored = values_of(lines), values_of(open(baseline))
    bound = lambda name: max(1 if "mm" in name else 5, 0.01 * abs(stored[name]))
    off = [name for name in now if name not in stored or not abs(now[name] - stored[name]) <= bound(name)]
    if off:
        print(f"not as in {baseline}: {off}")
    return 1 if off else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

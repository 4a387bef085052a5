"""impact_sensitivity.py RIMPACT FOLDER [BASELINE]: thesis 2.5.3 by the physical model, beside its percentages.

Hollister - South & Pine (GM11) on the spherical bearing, mu 0.04 to 0.07 at 20 s/m (the thesis gives no rate), k_i x 0.5 to
1.5 and e 0.4 to 0.7. The thesis's scale is not given, so the critical one is sought and some beyond it are run. Prints the
changes of the peak base shear (lateral force over W) against k_i = 4.5e5 kN/m, e = 0.65; compares with BASELINE to 0.1 %.
Exit 77: the records
are absent (RIMPACT_RECORDS names their folder)."""
import json
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from stored_table import differ  # noqa: E402

KI, E = 450000.0, 0.65
STIFFNESS, RESTITUTION = (0.5, 0.75, 1.25, 1.5), (0.4, 0.5, 0.6, 0.7)
PUBLISHED = {("k_i", 1.5): "+32", ("e", 0.7): "+10"}  # the only two the text states as numbers
SCENE = """[bearing]
name = "fps-225"
[excitation]
kind = "record"
x = "{0}/RSN776_LOMAP_HSP000.AT2"
y = "{0}/RSN776_LOMAP_HSP090.AT2"
z = "{0}/RSN776_LOMAP_HSP-UP.AT2"
duration_s = 40
[reduced]
mu_slow = 0.04
mu_fast = 0.07
rate_s_per_m = 20
"""


class Runs:
    def __init__(self, rimpact, records, folder):
        os.makedirs(folder, exist_ok=True)
        self.rimpact, self.folder, self.scene = rimpact, folder, f"{folder}/scene.toml"
        with open(self.scene, "w") as file:
            file.write(SCENE.format(os.path.abspath(records)))

    def run(self, scale, ki=KI, e=E):
        command = [self.rimpact, "reduced", self.scene, "-o", f"{self.folder}/run"]
        for key, value in (("excitation.scale", scale), ("reduced.k_i_kN_per_m", ki), ("reduced.restitution", e)):
            command += ["--set", f"{key}={value!r}"]
        subprocess.run(command, check=True, capture_output=True)
        with open(f"{self.folder}/run/summary.json") as file:
            return json.load(file)

    def critical(self):
        low, high = 0.5, 4.0
        while high - low > 1e-4:
            middle = (low + high) / 2
            low, high = (low, middle) if self.run(middle)["impacts"] else (middle, high)
        return high


def row(runs, scale, label, parameter, factor, ki, e, shear):
    s = runs.run(scale, ki, e)
    change = 100 * (s["peak_lateral_force_N"] / shear - 1)
    return (f"{label:<10} {parameter:<4} {factor:>5.2f} {s['peak_lateral_force_N'] / 853e3:>8.3f} {change:>+8.2f} % "
            f"{PUBLISHED.get((parameter, factor), '-'):>5} % {len(s['impacts']):>3} {s['impacts'][0]['approach_speed_m_s']:>7.3f}")


def table(runs):
    critical = runs.critical()
    lines = [f"critical scale {critical:.3f}",
             "scale      what value  shear/W    change   thesis  hits  m/s"]
    for beyond in (1.05, 1.15, 1.3):
        scale, label = beyond * critical, f"x {beyond:g}"
        shear = runs.run(scale)["peak_lateral_force_N"]
        for factor in (1.0,) + STIFFNESS:
            lines.append(row(runs, scale, label, "k_i", factor, factor * KI, E, shear))
        for e in RESTITUTION:
            lines.append(row(runs, scale, label, "e", e, KI, e, shear))
    return lines


def main(rimpact, folder, baseline=None):
    beside = os.path.join(os.path.dirname(__file__), "../../../shared/records")
    records = os.environ.get("RIMPACT_RECORDS", beside)
    if not os.path.exists(f"{records}/RSN776_LOMAP_HSP000.AT2"):
        print(f"no records in {records} (set RIMPACT_RECORDS)")
        return 77
    lines = table(Runs(rimpact, records, folder))
    print("\n".join(lines))
    if baseline is None:
        return 0
    with open(baseline) as file:
        stored = file.read().splitlines()
    bad = [f"now: {a}\nbaseline: {b}" for a, b in zip(lines, stored) if differ(a, b, 1e-3, 0.02)]
    if len(lines) != len(stored):
        bad.append(f"{len(lines)} lines, {len(stored)} in the baseline")
    print("\n".join(bad))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

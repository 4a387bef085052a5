#!/usr/bin/env python3
"""A rim's curve of static steel, and the same at the strain rate of each speed (`curve --at-speed`), flown into windows whose steel knows its rate.

Errors are against the windows by rung rim on the same mesh. Gates: with the rate in the curve the peak is within 8 % and the depth within 12 %.

usage: fast_curve.py RIMPACT FOLDER [MESH]
"""
import pathlib
import subprocess
import sys

from kept_run import finish, gate, is_kept, kept_run

SPEEDS = (0.2, 0.5, 1.0)
RATE = 'bearing.material.steel.rate="cowper-symonds"'
HEAD = "speed curve    peak_kN  depth_mm  rebound   peak_%  depth_%  rebound_points"
CLOSE = {"peak": 8.0, "depth": 12.0}  # %


def bearing(folder):
    """The default one, its steel mild; a table of its own leaves all else to the default."""
    file = folder / "shfps-225.toml"
    file.write_text('[bearing]\nname = "shfps-225"\n[bearing.material.steel]\nrate = "cowper-symonds"\n[excitation]\nkind = "window"\n'
                    "[load]\nmass_kg = 86952.0\nvertical_kN = 853.0\n")
    return str(file)


def pushed(program, folder, speed, mesh):
    place = folder / f"curve_{speed}"
    if not is_kept(place / "curve.json", program):
        subprocess.run([program, "curve", bearing(folder), "-o", str(place), "--held", "--mesh", mesh, "--speed", str(max(0.3, 1.1 * speed)),
                        "--at-speed", str(speed), "--quiet", "--force"], check=True, stdout=subprocess.DEVNULL)
    return place


def main(program, folder, mesh="0"):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    lines, failures = [HEAD], []
    for speed in SPEEDS:
        settings = [RATE, f"excitation.speed_m_per_s={speed}", "excitation.duration_s=0.1"]
        solid = kept_run(program, "run", "impact-window", folder / f"window_{speed}", settings, ["--mesh", mesh, "--no-fields"])["impacts"][0]
        place = pushed(program, folder, speed, mesh)
        lines.append(f"{speed:5.2f} {'window':8s} {solid['peak_force_N'] / 1e3:8.1f} {1e3 * solid['peak_penetration_m']:9.3f} {solid['restitution']:8.4f}")
        for name in ("curve", "curve-fast"):
            flown = kept_run(program, "reduced", "impact-window", folder / f"{name}_{speed}_flown",
                             [*settings, "reduced.impact_law=curve", f"reduced.impact_curve={place / name}.h5"])["impacts"][0]
            peak, depth = (100 * (flown[key] / solid[key] - 1) for key in ("peak_force_N", "peak_penetration_m"))
            lines.append(f"{speed:5.2f} {'static' if name == 'curve' else 'fast':8s} {flown['peak_force_N'] / 1e3:8.1f} {1e3 * flown['peak_penetration_m']:9.3f} "
                         f"{flown['restitution']:8.4f} {peak:8.1f} {depth:8.1f} {100 * (flown['restitution'] - solid['restitution']):15.1f}")
            if name == "curve-fast":
                gate(failures, f"peak at {speed} m/s [%]", peak, CLOSE["peak"])
                gate(failures, f"depth at {speed} m/s [%]", depth, CLOSE["depth"])
    return finish(folder, lines, failures)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], *sys.argv[3:4]))

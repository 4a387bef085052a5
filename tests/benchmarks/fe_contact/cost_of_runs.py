#!/usr/bin/env python3
"""What dear runs cost, and how far one build's are from another's: time, work and error side by side.

cost_of_runs.py PROGRAM [--against PROGRAM] [--jobs a,b] [--write FILE]. PROGRAM is a rimpact-fe. Each job runs on one
thread and one rank; two builds run side by side, a core each, so that what else the machine does strikes both. Seconds
are the processor's.
"""
import argparse
import json
import os
import pathlib
import platform
import subprocess
import sys
import tempfile

PULSE = ("ricker-0.78g-1.0s", "--set", "excitation.scale=1.05")
WINDOW = ("impact-window", "--set", "excitation.speed_m_per_s=0.5", "--set", 'excitation.with=["weight","friction"]')
JOBS = {
    "pulse-rim": (*PULSE, "--rung", "rim"),
    "pulse-dish": (*PULSE, "--rung", "rigid-dish"),
    "pulse-full": (*PULSE, "--rung", "full"),
    "window-dish": (*WINDOW, "--rung", "rigid-dish"),
    "pulse-to-release": (*PULSE, "--rung", "rigid-dish", "--set", "excitation.duration_s=2.6"),
}
HEAD = f"{'job':18}{'build':8}{'s':>8}{'steps':>7}{'Newton':>8}{'GMRES':>8}{'factors':>8}{'kN':>10}{'restitution':>12}{'mm':>9}{'imbalance':>11}"


def start(program, words, folder, core):
    environment = dict(os.environ, RIMPACT_THREADS="1", OPENBLAS_NUM_THREADS="1")
    with open(folder + ".log", "w") as log:
        return subprocess.Popen([program, "run", *words, "--no-fields", "-o", folder], stdout=log, stderr=log, env=environment,
                                preexec_fn=lambda: os.sched_setaffinity(0, {core}))


def wait(process):
    """Processor seconds of a process that ends well."""
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"a run ended with {os.waitstatus_to_exitcode(status)}")
    return usage.ru_utime + usage.ru_stime


def row(job, build, seconds, folder):
    with open(os.path.join(folder, "summary.json")) as file:
        s = json.load(file)
    work, impact = s["solver_work"], s["impacts"][0] if s["impacts"] else {}
    values = {"force": s["peak_impact_force_N"], "restitution": impact.get("restitution", 0.0), "travel": s["peak_displacement_m"], "seconds": seconds}
    text = (f"{job:18}{build:8}{seconds:8.0f}{s['n_steps']:7}{work['newton_iterations']:8}{work['linear_iterations']:8}{work['factorisations']:8}"
            f"{1e-3 * values['force']:10.2f}{values['restitution']:12.4f}{1e3 * values['travel']:9.3f}{s['energy']['imbalance_relative']:11.1e}")
    return text, values


def compared(job, new, old):
    return (f"{job:18}ratio   {old['seconds'] / new['seconds']:8.2f} times sooner; force {100 * (new['force'] / old['force'] - 1):+.3f} %, "
            f"restitution {new['restitution'] - old['restitution']:+.4f}, travel {1e3 * (new['travel'] - old['travel']):+.4f} mm")


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    words.add_argument("program")
    words.add_argument("--against")
    words.add_argument("--jobs", default=",".join(JOBS))
    words.add_argument("--write")
    given = words.parse_args()
    builds = {"this": given.program, **({"other": given.against} if given.against else {})}
    cores = sorted(os.sched_getaffinity(0))
    lines = [f"# {platform.processor() or platform.machine()}, one thread a run; made by tests/benchmarks/fe_contact/cost_of_runs.py", HEAD]
    print(HEAD, flush=True)
    for job in given.jobs.split(","):
        with tempfile.TemporaryDirectory() as place:
            folders = {build: os.path.join(place, build, "run") for build in builds}
            for folder in folders.values():
                os.makedirs(os.path.dirname(folder))
            running = {build: start(program, JOBS[job], folders[build], cores[k % len(cores)]) for k, (build, program) in enumerate(builds.items())}
            rows = {build: row(job, build, wait(process), folders[build]) for build, process in running.items()}
        found = [text for text, _ in rows.values()]
        if given.against:
            found.append(compared(job, rows["this"][1], rows["other"][1]))
        print("\n".join(found), flush=True)
        lines += found
    if given.write:
        pathlib.Path(given.write).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()

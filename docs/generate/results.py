#!/usr/bin/env python3
"""Writes docs/results/ from the stored studies and the tables beside the tests; --check fails where a page differs.

Each table stands with the command that makes it. What a file's own head says of machine and commit is kept as it stands.
"""
import json
import math
import pathlib
import statistics
import sys
import tomllib
from collections.abc import Iterable
from typing import Any

from write_or_compare import write_or_compare

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEAD = "<!-- Made by docs/generate/results.py; do not edit. -->\n"

# Page, title, and for each table: the file, what it is, the command that makes it.
TABLES = {
    "hard-cases": ("Hard cases", [
        ("tests/hard_cases/reduced/table.txt", "Reduced model", "build/release/bin/hard_cases_reduced --write"),
        ("tests/hard_cases/double_concave/table.txt", "Double concave models", "build/release/bin/hard_cases_double_concave --write"),
        ("tests/hard_cases/solid/table_rim.txt", "Rung rim", "ctest -L slow -R hard_cases_rim"),
        ("tests/hard_cases/solid/table_rim-rate.txt", "Rung rim, steel that knows its rate", "ctest -L slow -R hard_cases_rim-rate"),
        ("tests/hard_cases/solid/table_double-concave.txt", "Rung rim between two dishes", "ctest -L slow -R hard_cases_double-concave$"),
        ("tests/hard_cases/solid/table_rigid-dish.txt", "Rung rigid-dish", "ctest -L slow -R hard_cases_rigid-dish"),
        ("tests/hard_cases/solid/table_double-concave-dish.txt", "Rung rigid-dish between two dishes", "ctest -L slow -R hard_cases_double-concave-dish"),
        ("tests/hard_cases/solid/table_rigid-dish-rate.txt", "Rung rigid-dish, steel that knows its rate", "ctest -L slow -R hard_cases_rigid-dish-rate"),
        ("tests/hard_cases/solid/table_full.txt", "Rung full", "ctest -L slow -R hard_cases_full"),
        ("tests/hard_cases/solid/table_full-rate.txt", "Rung full, steel that knows its rate", "ctest -L slow -R hard_cases_full-rate")]),
    "refinement": ("Refinement and peers", [
        ("tests/verification/rim_window_refinement.txt", "A window, meshes 1 to 3", "tests/verification/rim_window_refinement.py"),
        ("tests/verification/steel_places.txt", "The rim's steel, meshes 0 to 2", "tests/verification/steel_places.py"),
        ("tests/verification/steel_rate.txt", "Steel that knows its rate", "tests/verification/steel_rate.py"),
        ("tests/verification/second_hits.txt", "Second and opposite hits", "tests/verification/second_hits.py"),
        ("tests/verification/fast_curve.txt", "Curves at speed", "tests/verification/fast_curve.py"),
        ("tests/verification/stack_refinement.txt", "The stack", "tests/verification/stack_refinement.py"),
        ("tests/verification/windows_of_rungs.txt", "One window by every rung", "tests/verification/windows_of_rungs.py"),
        ("tests/verification/windows_of_rungs_dcfp.txt", "One window between two dishes by every rung", "ctest -L slow -R windows_of_rungs_dcfp"),
        ("tests/verification/static_loops.txt", "Quasi-static loops", "tests/verification/static_loops.py"),
        ("tests/verification/interface_loop.txt", "A slow loop of an LIR-DCFP into its rims", "tests/verification/interface_loop.py RIMPACT FOLDER 0,1"),
        ("tests/verification/tetrahedra.txt", "Tetrahedra", "tests/verification/tetrahedra.py"),
        ("tests/verification/pad_seat.txt", "The pad's seat, tied and frictional", "tests/verification/pad_seat.py"),
        ("tests/verification/figure_eight.txt", "Figure-eight", "tests/verification/figure_eight.py"),
        ("tests/verification/rim_curve.txt", "Curves of rims", "ctest -L slow -R rim_curve"),
        ("tests/verification/indentation_calculix/baseline.txt", "Indentation against CalculiX", "ctest -L slow -R indentation_calculix"),
        ("tests/verification/stack_push_calculix/baseline.txt", "Push of the bearing against CalculiX", "ctest -L slow -R stack_push_calculix"),
        ("tests/verification/explicit_rim/explicit_rim.txt", "A window by an explicit program of another formulation",
         "tests/verification/explicit_rim/explicit_rim.py build/release/bin/rimpact build/release/bin/explicit_rim FOLDER --mesh 0 --divided --ours 0"),
        ("tests/verification/explicit_rim/rate_pairs.txt", "What the strain rate changes, by an explicit program and ours", "ctest -L slow -R explicit_rate"),
        ("tests/benchmarks/peers/rim_calculix/push.txt", "Push of the rim against CalculiX", "ctest -L slow -R rim_push"),
        ("tests/benchmarks/peers/rim_calculix/window.txt", "An elastic window against CalculiX", "ctest -L slow -R rim_window_calculix")]),
    "peers": ("OpenSees and GetFEM", [
        ("tests/peers/opensees_table.txt", "Exported files", "tests/peers/opensees_table.py --write"),
        ("tests/peers/their_bearings.txt", "Its own bearings and ours", "tests/peers/their_bearings.py --write"),
        ("tests/peers/recorded_motions.txt", "Recorded motions", "tests/peers/recorded_motions.py --write"),
        ("tests/benchmarks/peers/rim_getfem/push.txt", "Push of the rim by GetFEM, and what each program takes",
         "tests/benchmarks/peers/rim_getfem/compare_push.py --writer WRITER --rimpact RIMPACT-FE --folder FOLDER --speed --write FILE"),
        ("tests/benchmarks/peers/rim_getfem/friction.txt", "A push with friction by GetFEM", "ctest -L slow -R rim_friction_getfem"),
        ("tests/benchmarks/peers/rim_getfem/window.txt", "A window by GetFEM", "ctest -L slow -R rim_window_getfem")]),
    "runs": ("Whole runs: work and time", [
        ("tests/benchmarks/runs.txt", "Two builds beside one another", "tests/benchmarks/runs.py RIMPACT --against RIMPACT_BEFORE --rows NAME,... --write FILE"),
        ("tests/benchmarks/runs_alone.txt", "Long runs of one build", "tests/benchmarks/runs.py RIMPACT --rows NAME,... --write FILE"),
        ("tests/benchmarks/waits.txt", "What a user waits for", "tests/benchmarks/waits.py RIMPACT --rows NAME,... --write FILE"),
        ("tests/benchmarks/bounds.txt", "What the counts leave at least", "tests/benchmarks/bounds.py --write FILE"),
        ("tests/benchmarks/work.txt", "One Newton iteration by mesh and by ranks, counted",
         "tests/benchmarks/work.py build/release/bin/bench_work --meshes 0,1,2,3 --ranks 1,2,3,4 --shared-meshes 0,1,2 --write FILE")]),
    "law-against-solids": ("The law against the solids", [
        ("tests/verification/law_against_curves.txt", "Curves of rung rigid-dish and the law fitted to them", "tests/verification/law_against_curves.py build/release/bin/rimpact")]),
    "reduced": ("Reduced models and buildings", [
        ("tests/benchmarks/peers/work_precision/table.txt", "Work against precision", "tests/benchmarks/peers/work_precision/work_precision.py"),
        ("tests/reduced_models/rims_in_turn.txt", "One rim of a DCFP touched after the other", "tests/reduced_models/rims_in_turn.py"),
        ("tests/reduced_models/impact_sensitivity.txt", "Sensitivity to k_i and e, thesis 2.5.3", "tests/reduced_models/impact_sensitivity.py"),
        ("tests/buildings/hard_cases.txt", "Buildings on many bearings: hard cases", "build/release/bin/building_hard_cases"),
        ("tests/buildings/frame_2_5.txt", "The inelastic frame of thesis 2.5 on three isolators", "tests/buildings/frame_study.py build/release/bin/rimpact FOLDER")]),
    "calibration": ("Calibration", [
        ("tests/calibration/coverage.txt", "How often intervals hold the truth", "build/release/bin/calibration_coverage"),
        ("tests/calibration/coverage_default.txt", "The same from default starts", "build/release/bin/calibration_coverage --all --seeds 200 --only CELL")]),
}
# What a page's tables do not say themselves.
REMARKS = {
    "peers": "OpenSees executes the files of `rimpact export --opensees`: the Python one as it is, the Tcl one by tclsh, whose commands OpenSees does; both give the same. "
             "Springs of every law are met by one mass at five speeds, twice, the second time on the dent of the first. The whole bearing carries the law fitted to the kept "
             "finite-element runs, with the terms of pad and socket; windows are thrown from 0.05 mm before the rim with weight and friction. The hardest touch of a pulse is shown, "
             "the first one in two directions. Work is what the rim took and did not give back.\n\n"
             "The second table has no rim. Why the programs differ: `singleFPBearing` and `FPBearingPTV` slide in a plane, so that their normal force misses the acceleration of "
             "the rise, which lifts load off our slider: 4 to 10 % of the force. Against our model with a static normal force 1.6 % remain under a constant load: `singleFPBearing` "
             "adds the push's share, u F / R, to the normal force and projects it without the cosine; `FPBearingPTV` leaves that share out. Where the load varies, the pad's spring "
             "under it swings along; our rigid one does not. Friction by speed is the same law in all three. `TripleFrictionPendulum`, its inner surfaces held to 0.1 mm, is a "
             "double concave bearing whose faces slide about a point. Our `dcfp` has a slider of a height, whose faces need mu 2 R / R_eff (`mu_e`), and it rises.\n\n"
             "Under records of Northridge, Imperial Valley and Kobe the exported bearing travels within 1.5 % of our model and its rim is pushed within 2.3 % as hard. "
             "Two things differ. Friction of the export is built up along a straight line over 0.225 mm, ours along Park and Wen's curve over 0.18 mm; and the export's mass "
             "stands on the pad's spring, ours, as a calibration of runs with a pad asks, on the dish. Made alike in both (*alike*), the travel agrees within 0.4 %. What stays, up to "
             "2.7 % of the rim's force, was not isolated: its springs, straight lines through the law, are as far off in the first table. The speed of touch of Array 7 in "
             "three directions differs most. The cause is the swing on the pad's spring that the vertical motion sets off, and that nothing damps: without that motion (Array 7, x y) "
             "the speeds agree within 0.2 %, with it ours alone goes from 0.80 to 0.86 m/s as its tolerance falls from 1e-6 to 1e-10, and a loss factor of the pad of 0.02 brings it to "
             "0.70 m/s, 1871 kN, within 1.3 % of theirs.\n\n"
             "The last tables are of solids, on our mesh. GetFEM assembles forms and their tangents from text; ours is written for this one problem. The largest difference of "
             "force falls from 3.7 % on mesh 0 to 1.1 % on mesh 1. A window at 0.3 m/s on mesh 1 has a peak force within 0.6 % and a rebound within 0.8 % of theirs. "
             "Seconds to 1 % lie on a straight line of logarithms between the meshes about it, else through the two finest; they were taken beside other work. "
             "CalculiX's is too kind: its control gave up nearly half of the iterations on mesh 0, and its mesh 2, within 0.1 %, once took 1,341 s "
             "([refinement](refinement.md)). The first of our own meshes within 1 % is mesh 2.",
    "runs": "Left of the bar the later build, right of it the one before rungs became values (commit a9d76de), whose summaries hold no counts "
            "of GMRES and factors. Each row's two runs follow one another on one core, one rank, one thread; seconds are of processor time, beside other work on the other core. "
            "Errors are of the later build against the earlier one. `runs.py RIMPACT --list` names all rows, up to a bidirectional pulse and Sylmar; `time ./run main` is the main "
            "job, and the push against CalculiX stands among [the peers](refinement.md).\n\n"
            "The third table was taken alone on a machine, with the ranks and the runs at a time that the program chooses. Asked were 90 s of `main`, 10 s of `calibrate`, 8 s of "
            "`report`, 15 s of the window, 120 and 240 s of the pulses by rigid-dish and full, 360 s of the one in two directions.\n\n"
            "The fourth table has the least time that the iterations, factors and solutions of a run leave at this machine's best rates, beside what was once asked of two cores. "
            "A bidirectional pulse cannot be had in 360 s with these counts; pulses by rigid-dish and full were asked for within 1.4 times their bound, a window within 1.7 times. "
            "`waits.py RIMPACT` times what a user waits for.",
    "refinement": "Seconds are of a machine of two cores, an AMD EPYC at 2.6 GHz, beside other work: a hint. Why peers are compared on the same mesh: "
                  "[decision 17](../decisions/0017-peers-on-the-same-mesh.md).",
    "law-against-solids": "The runs are kept in `data/references/`; the law has the numbers of `elastoplastic.json` there, fitted to all but the bidirectional "
                          "pulse. Windows start at the rim, pulses from rest; the bidirectional one is a prediction. Displacement is the root mean square from first touch to 0.5 s "
                          "after the last release, over L_c. Beyond 1 m/s the rebound is not met: [decision 9](../decisions/0009-how-a-rim-returns.md).\n\n"
                          "`rim.json` is the law that the main job finds by rung rim, which has no pad, with the terms of pad and socket that its calibration brings. None of "
                          "these curves was fitted. "
                          "From 0.1 to 0.5 m/s it meets the peak within 3 % and the rebound within 3.3 %; without the pad's spring ([the stack](../theory/dish.md)) "
                          "it overstates the rebound by 6 to 10 %. "
                          "Beyond, its force and rebound are too large, for an unknown reason.\n\n"
                          "![the 0.78 g pulse by rung rigid-dish](../pictures/ricker-rigid-dish.png)",
    "reduced": "Peers integrate the same Park-Wen equations, written down apart; Octave and SciPy run interpreted right-hand sides.",
}
PICTURES = {"window-0.50": "study-window-0.5.png", "rungs-pulse-0.78g": "study-pulse-0.78g.png", "rungs-pulse-0.38g": "study-pulse-0.38g.png",
            "rungs-window-0.50": "study-rungs-window-0.5.png", "rungs-pulse-bidirectional": "study-pulse-bidirectional.png"}


def texts_page(title: str, tables: Iterable[tuple[str, str, str]], remark: str = "") -> str:
    text = f"# {title}\n" + (f"\n{remark}\n" if remark else "")
    for path, what, command in tables:
        file = ROOT / path
        if not file.is_file():
            raise SystemExit(f"{path} is absent: `{command}` makes it")
        text += f"\n## {what}\n\nFrom `{path}`, made by `{command}`.\n\n```text\n{file.read_text(encoding='utf-8').rstrip()}\n```\n"
    return text


def contact_page(two_bodies: bool) -> str:
    """Baselines of verify_contact: against exact surfaces, or between two deformable bodies."""
    title, other = ("Contact between two bodies", "[against exact surfaces](contact.md)") if two_bodies else ("Contact benchmarks", "[between two bodies](contact-two-bodies.md)")
    text = f"# {title}\n\nErrors by mesh and step with their observed orders, made by `ctest -R contact` (`tests/verification/contact/`). The others: {other}.\n"
    for file in sorted((ROOT / "tests/verification/contact/baselines").glob("*.txt")):
        if ("two-bodies" in file.stem) == two_bodies:
            text += f"\n## {file.stem.replace('-', ' ').capitalize()}\n\n```text\n{file.read_text(encoding='utf-8').rstrip()}\n```\n"
    return text


def percent(value: float | None) -> str:
    return "" if value is None else f"{100 * value:+.2f} %"


def time_of(row: dict[str, Any] | None) -> str:
    """Processor time where it was measured, else wall time in brackets."""
    if row is None:
        return ""
    return f"{row['processor_time_s']:.3g}" if row.get("processor_time_s") else f"({row['wall_time_s']:.3g})"


def growth_of(rows: list[dict[str, Any]]) -> list[str]:
    """Of rungs that ran on several meshes: the power of the unknowns by which their processor time grows."""
    sentences = []
    for rung in dict.fromkeys(row["rung"] for row in rows):
        runs = [row for row in rows if row["rung"] == rung and row.get("processor_time_s")]
        if len({row["n_dofs"] for row in runs}) > 1:
            power = statistics.linear_regression([math.log(row["n_dofs"]) for row in runs], [math.log(row["processor_time_s"]) for row in runs]).slope
            sentences.append(f"Processor time of `{rung}` over {len(runs)} meshes: unknowns^{power:.2f}.")
    return sentences


def studies_page() -> str:
    text = ("# Speed against error\n\nStored studies (`data/studies/`), each made by `rimpact study`; errors against the finest run of the study. "
            "Times are processor times; wall times stand in brackets. Both grow where the machine does other work beside. *Before*: the same run by an "
            "earlier build (`data/studies/before/`).\n")
    for file in sorted((ROOT / "data/studies").glob("*.json")):
        study, earlier = json.loads(file.read_text(encoding="utf-8")), ROOT / "data/studies/before" / file.name
        before = {row["name"]: row for row in json.loads(earlier.read_text(encoding="utf-8"))["rows"]} if earlier.is_file() else {}
        head = ["run", "unknowns", "peak force kN", "peak force", "rebound", "force history (RMS)", "time s", *(["before s"] if before else [])]
        text += f"\n## {file.stem}\n\n| {' | '.join(head)} |\n|{'---|' * len(head)}\n"
        for row in study["rows"]:
            name = row["name"] + (" (reference)" if row.get("reference") else "")
            cells = [name, str(row["n_dofs"]), f"{row['peak_impact_force_N'] / 1e3:.1f}", percent(row.get("peak_force_error")), percent(row.get("rebound_error")),
                     percent(row.get("nrmse_force")), time_of(row), *([time_of(before.get(row["name"]))] if before else [])]
            text += f"| {' | '.join(cells)} |\n"
        if picture := PICTURES.get(file.stem):
            text += f"\n![speed against error, {file.stem}](../pictures/{picture})\n"
        elements = [f"`{row['name']}`: {row['element']}." for row in study["rows"] if row.get("element")]
        made = [f"Made by {study['made_by']}, `{study['command']}`."] if study.get("made_by") else []
        if said := elements + growth_of(study["rows"]) + made:
            text += "\n" + " ".join(said) + "\n"
    return text


def reductions_table(kept: dict[str, Any]) -> str:
    text = ("| systems that differ in | limit | pairs | mean reduction | least | largest | pairs whose band excludes 0 | unknown runs: at least to at most |\n"
            "|---|---|---|---|---|---|---|---|\n")
    for row in kept["differences"]:
        unknown = f"{row['n_unknown']}: {percent(row['reduction_at_least'])} to {percent(row['reduction_at_most'])}" if row.get("n_unknown") else ""
        beyond = row["quantity"] if row["quantity"] == "collapsed" else f"{row['quantity']} > {row['limit']:g}"
        text += (f"| {row['key']} = {row['value']} | {beyond} | {row['n_systems']} | {percent(row['mean_reduction'])} | "
                 f"{percent(row['least_reduction'])} | {percent(row['largest_reduction'])} | {row['n_systems_whose_band_excludes_0']} | {unknown} |\n")
    return text


def reliability_page() -> str:
    text = ("# Reliability\n\nStudies of `data/reliability/` with the records at hand, kept by `docs/generate/keep_reliability.py`. A reduction is of the probability of "
            "exceedance in the study's years, against the reference system; negative: it grows. Unknown runs are those of both systems that stopped short of the "
            "limit because their model holds no longer; the bounds beside them assume that all of them exceed the limit, or none.\n")
    for file in sorted((ROOT / "data/reliability/kept").glob("*.json")):
        kept = json.loads(file.read_text(encoding="utf-8"))
        levels = ", ".join(f"{level['level_g']:.3g} g: {level['n_records']} of {level['n_listed']}" for level in kept["levels"])
        text += (f"\n## {kept['study']}\n\n{kept['what']}\n\n{kept['n_systems']} systems, {kept['n_runs']} runs (samples a motion: {kept['samples']}; "
                 f"without a result: {kept['n_runs_without_result']}). Records at hand a level: {levels}.\n\n{reductions_table(kept)}")
    return text


def measured_page() -> str:
    tests = tomllib.loads((ROOT / "data/measured/tests.toml").read_text(encoding="utf-8"))["test"]
    ours = json.loads((ROOT / "data/thesis/ours.json").read_text(encoding="utf-8"))
    text = ("# Measured bearings\n\nNumbers that laboratories printed (`data/measured/tests.toml`) beside ours. *Open* is half of the last printed digit, where the source "
            "gives no uncertainty. No force of a rim impact over time was found in public as numbers: `data/measured/README.md` says how to give one.\n")
    for test in tests:
        text += f"\n## {test['name']}\n\n{test['source']}. Ours: {test['model']}.\n\n| what | measured | open | ours | difference | remark |\n|---|---|---|---|---|---|\n"
        for value in test["value"]:
            own = ours[value["ours"][0]][value["ours"][1]] if "ours" in value else None
            off = "" if own is None else f"{own - value['measured']:+.4g} {value['unit']}"
            remark = value.get("cause", "an input" if value.get("input") else "")
            text += (f"| {value['what']} | {value['measured']:g} {value['unit']} | {value['open']:g} | {'' if own is None else f'{own:.4g}'} | {off} | {remark} |\n")
    return text


#: The README's table: which row of which study, in plain words.
FIRST_STUDY = "rungs-pulse-0.78g"
FIRST_ROWS = {"reduced": "a constant pair k_i, e as published", "curve": "the rim's curve, pushed once, under a moving mass",
              "rim-mesh1": "rim, plate and slider where they meet (rung `rim`)", "rigid-dish-mesh1": "these and pad and foot on a rigid dish (`rigid-dish`)",
              "full-mesh1": "everything (`full`)"}
BEGIN, END = "<!-- begin: made by docs/generate/results.py -->\n", "<!-- end -->\n"


def first_table() -> str:
    rows = {row["name"]: row for row in json.loads((ROOT / f"data/studies/{FIRST_STUDY}.json").read_text(encoding="utf-8"))["rows"]}
    text = "| what is solved | time | peak force | rebound |\n|---|---|---|---|\n"
    for name, words in FIRST_ROWS.items():
        row = rows[name]
        seconds = row.get("processor_time_s") or row["wall_time_s"]
        cells = [words, f"{1e3 * seconds:.0f} ms" if seconds < 1 else f"{seconds:.0f} s",
                 *(["reference"] * 2 if row.get("reference") else [f"{100 * row[key]:+.1f} %" for key in ("peak_force_error", "rebound_error")])]
        text += f"| {' | '.join(cells)} |\n"
    return text


def readme() -> str:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    return before + BEGIN + first_table() + END + rest.split(END, 1)[1]


def pages() -> dict[str, str]:
    made = {f"{name}.md": texts_page(*parts, REMARKS.get(name, "")) for name, parts in TABLES.items()}
    return {**made, "contact.md": contact_page(False), "contact-two-bodies.md": contact_page(True), "studies.md": studies_page(),
            "reliability.md": reliability_page(), "measured.md": measured_page()}


def main(*options: str) -> int:
    made = {ROOT / "docs" / "results" / name: HEAD + page for name, page in pages().items()}
    made[ROOT / "README.md"] = readme()
    return write_or_compare(made, options, "the tables say; run docs/generate/results.py")


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

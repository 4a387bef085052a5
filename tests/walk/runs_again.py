"""What a main job's runs say, read from their own files: which are fitted, what the steel bore, how far errors go."""
import json
import math
import os
import pathlib
import tomllib
from typing import Any

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
LARGEST_IMBALANCE = 0.02  #: share of the energy beyond which a run is not fitted
Summaries = dict[str, dict[str, Any]]


def read(*path: str) -> Any:
    with open(os.path.join(*path), encoding="utf-8") as file:
        return json.load(file)


def summaries(folder: str) -> Summaries:
    places = os.path.join(folder, "runs")
    names = [name for name in sorted(os.listdir(places)) if os.path.isfile(os.path.join(places, name, "summary.json"))]
    return {name: read(places, name, "summary.json") for name in names}


def scene(folder: str, name: str) -> dict[str, Any]:
    with open(os.path.join(folder, "runs", name, "scene.toml"), "rb") as file:
        return tomllib.load(file)


def why_left_out(run: dict[str, Any]) -> str:
    """Empty: it is fit to be fitted."""
    if run.get("status") != "done":
        return "it is " + str(run.get("status"))
    if run.get("beyond_rim") is True:
        return "it is pressed beyond its rim"
    share = (run.get("energy") or {}).get("imbalance_relative") or 0.0
    return f"{100 * share:.2f} % of its energy" if abs(share) > LARGEST_IMBALANCE else ""


def fitted(folder: str, calibration: dict[str, Any]) -> Summaries:
    """Those that the answer may stand on: done, on the rim, with their energy, and not kept for prediction."""
    predicted = {os.path.basename(path.rstrip("/")) for path in calibration.get("prediction", {})}
    return {name: run for name, run in summaries(folder).items()
            if run.get("impacts") and not why_left_out(run) and name not in predicted}


def approach(run: dict[str, Any]) -> float:
    return float(max(impact["approach_speed_m_s"] for impact in run["impacts"]))


def steel_by_speed(runs: Summaries, speeds: dict[str, float], place: str, *keys: str) -> list[tuple[float, ...]]:
    rows = [(speeds[name], *(run["steel"][place][key] for key in keys)) for name, run in runs.items() if place in (run.get("steel") or {})]
    return sorted(rows, key=lambda row: row[0])


def recorded_speeds(rows: list[dict[str, Any]]) -> dict[str, float]:
    """Of the runs, as the calibration read them off their responses."""
    return {os.path.basename(path.rstrip("/")): run["approach_speed_m_s"] for row in rows for path, run in row["runs"].items()}


def passed(values: list[tuple[float, float]], limit: float) -> str:
    """As a reader would say it of runs by speed."""
    beyond = next((n for n, (_, value) in enumerate(values) if value > limit), None)
    if beyond is None:
        return "not reached"
    if beyond == 0:
        return f"passed by every run, from {values[0][0]:.3g} m/s on"
    (v, a), (w, b) = values[beyond - 1], values[beyond]
    return f"passed at about {v + (limit - a) / (b - a) * (w - v):.2g} m/s (runs at {v:.3g} and {w:.3g})"


def studies() -> list[dict[str, Any]]:
    return [json.loads(path.read_text(encoding="utf-8")) for path in sorted((REPOSITORY / "data" / "studies").glob("*.json"))]


def rung_errors(rung: str) -> dict[str, float]:
    """The largest of a rung against `full`, over kept studies and kept windows."""
    worst = {"peak_force": 0.0, "rebound": 0.0}
    for study in studies():
        rows = {(row["rung"], row["mesh"]): row for row in study["rows"] if row["name"] != "curve"}
        mesh = next((m for m in (2, 1, 0) if (rung, m) in rows and ("full", m) in rows), None)
        if mesh is None:
            continue
        for quantity, key in (("peak_force", "peak_force_error"), ("rebound", "rebound_error")):
            off = abs((1 + rows[rung, mesh][key]) / (1 + rows["full", mesh][key]) - 1)
            worst[quantity] = max(worst[quantity], off)
    table = [line.split() for line in (REPOSITORY / "tests/verification/windows_of_rungs.txt").read_text(encoding="utf-8").splitlines()]
    kept = {(row[1], row[0]): (float(row[7]), float(row[10])) for row in table if row and row[0] in (rung, "full")}
    for speed in {at for at, _ in kept}:
        for quantity, own, full in zip(worst, kept[speed, rung], kept[speed, "full"]):
            worst[quantity] = max(worst[quantity], abs(own / full - 1))
    return worst


def energy_errors(runs: Summaries) -> dict[str, float]:
    """Energy that nothing accounts for, at worst: half of it in the force, all in the depth, or in the rebound."""
    worst = {"peak_force": 0.0, "depth": 0.0, "rebound": 0.0}
    for run in runs.values():
        share, hit = abs(run["energy"]["imbalance_relative"] or 0.0), run["impacts"][0]
        worst["peak_force"], worst["depth"] = max(worst["peak_force"], share / 2), max(worst["depth"], share)
        if hit.get("rebound_speed_m_s"):
            e = hit["rebound_speed_m_s"] / hit["approach_speed_m_s"]
            worst["rebound"] = max(worst["rebound"], share / (2 * e * e))
    return worst


def error_at(speed: float, errors: list[tuple[float, float]]) -> float:
    """Of signed errors by speed: over the logarithm between two of one side, else the larger; of the nearest beyond them."""
    below, above = [e for e in errors if e[0] <= speed], [e for e in errors if e[0] >= speed]
    if not below or not above:
        return abs((errors[0] if not below else errors[-1])[1])
    (v, a), (w, b) = below[-1], above[0]
    if v == w:
        return abs(a)
    if a * b <= 0:
        return max(abs(a), abs(b))
    return abs(a + (b - a) * math.log(speed / v) / math.log(w / v))

"""Every number of page one once more, by code of this file's neighbours, from the runs and the record that the page stands on.

The law is flown by a Runge-Kutta method and fitted anew (law_again.py); sums, worst cases, errors and strains are taken from the runs'
summaries and the kept studies (runs_again.py). Runs that are left out of the fit are told apart by their own summaries.
Usage: page_one.py MAIN_FOLDER (as `rimpact main` leaves it); exit 1 where a number is not met."""
import math
import os
import re
import sys
from collections.abc import Iterator
from typing import Any

import runs_again as again
from law_again import damping, fitted, flown, pair, yielding
from page_text import digit_of, near, sentences_of, three, upwards, whole, words_of
from runs_again import Summaries, read

Check = Iterator[tuple[bool, str]]
LONGEST = 30  #: words of a sentence
CLOSE = 3e-3  #: of an impact flown by another method
REPORTED = (("peak_force_kN", 1), ("penetration_mm", 2), ("contact_time_ms", 3), ("restitution", 4))  #: key of a row, column of the page


def numbers_of(answer: dict[str, Any]) -> dict[str, float]:
    """What the law reads."""
    return {name: entry["value"] for name, entry in answer["law"]["element"].items() if isinstance(entry, dict)}


def said_in(words: str, what: str) -> tuple[bool, str]:
    return what in words, f"page one says {what}"


def of_the_counts(folder: str, words: str) -> Check:
    runs = again.summaries(folder)
    windows = sum(again.scene(folder, name)["excitation"]["kind"] == "window" for name in runs)
    for n, what in ((windows, "single impact"), (len(runs) - windows, "ground motion")):
        if n:
            yield said_in(words, f"{n} {what}{'s' if n > 1 else ''}")
    seconds = sum(run["wall_time_s"] for run in runs.values())
    if seconds >= 120:
        yield said_in(words, f"{int(seconds // 60)} min {int(seconds % 60):02d} s of finite elements")


def of_the_table(answer: dict[str, Any], rows: list[dict[str, Any]], words: str) -> Check:
    """A law that yields is flown again; errors are found again from the runs left out one at a time."""
    numbers = numbers_of(answer)
    shown = re.findall(r"(\d\.\d{3}) (?:! )?(\d+|\d+ \d{3}) (\d+\.\d\d) (\d+\.\d) (\d\.\d{3}) ([\d.]+ %|–) ([\d.]+ %|–) runs (left out|fitted)", words)
    yield len(shown) == len(answer["table"]), f"page one has {len(shown)} of the table's {len(answer['table'])} rows"
    errors = left_out(answer, rows)
    for row, cells in zip(answer["table"], shown):
        speed = f"{row['speed_m_s']:.3f} m/s"
        if cells[7] == "left out" and errors:
            for key, column in (("peak_force_error", 5), ("rebound_error", 6)):
                own = upwards(again.error_at(row["speed_m_s"], [(e["approach_speed_m_s"], e[key]) for e in errors]))
                yield cells[column] == own, f"{speed}, {key}: {cells[column]} for {own}"
        if "yield_force" not in numbers:
            continue
        own_impact = flown(yielding(numbers), answer["mass_kg"], row["speed_m_s"])
        for key, column in REPORTED:
            said = float(cells[column].replace(" ", ""))
            yield near(said, own_impact[key], CLOSE, digit_of(cells[column])), f"{speed}, {key}: {said:g} for {own_impact[key]:.5g}"


def left_out(answer: dict[str, Any], rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Errors of the answer's law on runs left out one at a time, by speed; runs that graze apart."""
    row = next((row for row in rows if row["law"] == answer["law"]["name"]), None)
    alone = [part["runs"][part["left_out"]] for part in (row or {}).get("leave_one_out", []) if list(part["runs"]) == [part["left_out"]]]
    return sorted((e for e in alone if not e["grazing"]), key=lambda e: e["approach_speed_m_s"])


def of_the_law(answer: dict[str, Any], folder: str, runs: Summaries, words: str) -> Check:
    """Its numbers as the page has them, and where a fit of another making ends on the same windows."""
    law, numbers = answer["law"], numbers_of(answer)
    for name, p in law["parameters"].items():
        yield said_in(words, three(p["value"]))
        low, high = p["interval_95"]
        yield low <= p["value"] <= high, f"{name}: {p['value']:.4g} lies in {low:.4g} to {high:.4g}"
    windows = [(run["impacts"][0]["approach_speed_m_s"], {
        "peak_force_kN": run["impacts"][0]["peak_force_N"] / 1e3, "penetration_mm": 1e3 * run["impacts"][0]["peak_penetration_m"],
        "restitution": run["impacts"][0]["restitution"]}) for name, run in runs.items() if again.scene(folder, name)["excitation"]["kind"] == "window"]
    if "yield_force" not in numbers or len(windows) < 3 or min(numbers.values()) <= 0:
        return
    free = [name for name in law["parameters"] if name in ("k_i", "yield_force", "hardening", "unloading_gain")]
    own = fitted(numbers, free, windows, answer["mass_kg"])
    for name in free:
        low, high = law["parameters"][name]["interval_95"]
        value, room = law["parameters"][name]["value"], 0.05 * law["parameters"][name]["value"]
        yield value - 3 * (value - low) - room <= own[name] <= value + 3 * (high - value) + room, \
            f"{name}: {own[name]:.4g} by a fit of another making to {len(windows)} windows, {value:.4g} ({low:.4g} to {high:.4g}) on the page"


def of_the_bars(answer: dict[str, Any], words: str) -> Check:
    names = {"peak_force": "Peak force", "depth": "Depth", "rebound": "Rebound", "k_i": "k i", "e": "e"}
    for quantity, name in names.items():
        parts = [e["value"] for e in answer["errors"] if e["quantity"] == quantity and e["value"]]
        if not parts:
            continue
        total = 100 * math.sqrt(sum(value * value for value in parts))
        found = re.search(rf"\b{name} (?:[a-z]+ [\d.]+ % )*([\d.]+) % (?:not known|[A-Z]|k i|e |95)", words)
        yield found is not None and near(float(found[1]), total, 0.0, 2 * digit_of(found[1])), \
            f"the bar of {quantity} ends at {found[1] if found else 'nothing'} % for {total:.3g} %"


def of_the_parts(answer: dict[str, Any], rows: list[dict[str, Any]], runs: Summaries) -> Check:
    """The known parts of the errors, from summaries, kept studies and the runs left out."""
    recorded = {(e["quantity"], e["source"]): e["value"] for e in answer["errors"]}
    found = {(quantity, "energy"): value for quantity, value in again.energy_errors(runs).items()}
    if answer["rung"] != "full" and isinstance(answer["rung"], str):
        found |= {(quantity, "rung"): value for quantity, value in again.rung_errors(answer["rung"]).items()}
    low, high = answer["law"]["valid_from_m_s"], answer["law"]["valid_to_m_s"]
    errors = [e for e in left_out(answer, rows) if low is None or low <= e["approach_speed_m_s"] <= high]
    for quantity, key in (("peak_force", "peak_force_error"), ("depth", "penetration_error"), ("rebound", "rebound_error")):
        if errors:
            found[quantity, "law"] = max(abs(e[key]) for e in errors)
    for part, value in found.items():
        said = recorded.get(part)
        yield said is not None and near(said, value, 2e-3), f"error of {part[0]} by {part[1]}: {said} for {value:.4g}"
    for quantity in {e["quantity"] for e in answer["errors"]}:
        missing = {"mesh", "step", "rung", "law", "energy", "steel", "geometry"} - {source for of, source in recorded if of == quantity}
        yield not missing, f"{quantity}: every part is in the record" + (f" but {sorted(missing)}" if missing else "")
    for e in answer["errors"]:
        yield e["value"] is not None or bool(e.get("find")) or e["source"] in ("law", "steel"), \
            f"{e['quantity']} by {e['source']}: {'known' if e['value'] is not None else 'not known, with the command that tells it'}"


def of_the_pair(answer: dict[str, Any], folder: str, runs: Summaries, words: str) -> Check:
    given = answer["pair"]
    if not given:
        return
    k, e, mass = 1e3 * given["k_i_kN_per_m"], given["e"], given["mass_kg"]
    yield said_in(words, f"k i = {three(k / 1e3)} kN/m, e = {e:.3f}, c i = {three(damping(k, e, mass) / 1e3)} kN s/m")
    for name, run in runs.items():
        hit = run["impacts"][0]
        if again.scene(folder, name)["excitation"]["kind"] != "window" or not given["from_m_s"] <= hit["approach_speed_m_s"] <= given["to_m_s"]:
            continue
        own = flown(pair(k, e, mass), mass, hit["approach_speed_m_s"])
        off = own["peak_force_kN"] * 1e3 / hit["peak_force_N"] - 1
        yield abs(off) <= given["worst_peak_force_error"] + 1e-3, f"{name}: the pair is off by {100 * off:+.1f} % of the peak"


def of_the_steel(answer: dict[str, Any], rows: list[dict[str, Any]], runs: Summaries, words: str) -> Check:
    """Strain, damage and speeds of every place, from the summaries."""
    strain = answer["strain"]
    judged = {name: max((at["averaged_plastic_strain"] for place, at in run["steel"].items() if place != "slider_edge"), default=0.0)
              for name, run in runs.items() if run.get("steel")}
    if not strain or not judged:
        return
    largest = max(judged.values())
    yield near(strain["largest"], largest, 1e-9), f"the largest strain is {100 * largest:.3g} %"
    yield said_in(words, f"reaches {upwards(largest)}")
    speeds = again.recorded_speeds(rows)
    for name, run in runs.items():
        yield near(speeds[name], again.approach(run), 2e-3), f"{name} arrives at {again.approach(run):.4g} m/s"
    for row in strain["places"]:
        means = again.steel_by_speed(runs, speeds, row["place"], "averaged_damage", "averaged_damage_bao_wierzbicki", "averaged_plastic_strain")
        both, plastic = [(speed, max(d, b), min(d, b), b > d) for speed, d, b, _ in means], [(speed, p) for speed, _, _, p in means]
        v, d, other, by_locus = max(both, key=lambda at: at[1])
        w, p = max(plastic, key=lambda at: at[1])
        by, beside = ("Bao and Wierzbicki", "Johnson and Cook") if by_locus else ("Johnson and Cook", "Bao and Wierzbicki")
        yield said_in(words, f"damage {d:.2f} at {v:.3g} m/s (by {by}; {other:.2f} by {beside}), 1 {again.passed([at[:2] for at in both], 1.0)}; "
                             f"strain {upwards(p)} at {w:.3g} m/s, "
                             f"its limit of {100 * strain['limit']:.3g} % {again.passed(plastic, strain['limit'])}")
    for name, value in judged.items():
        if value > strain["limit"] and re.search(rf"\b{re.escape(name)}:", words):
            yield f"{100 * value:.1f} %" in words, f"{name}: page one says {100 * value:.1f} %"


def of_the_runs(answer: dict[str, Any], folder: str, runs: Summaries, words: str) -> Check:
    """Speeds and count of the runs fitted; that those left out are said; what the law makes of single impacts, flown anew."""
    for name, run in again.summaries(folder).items():
        why = again.why_left_out(run)
        if why and run.get("impacts"):
            doubts = [doubt for doubt in answer["doubts"] if f"{name} is left out of the fit" in doubt]
            yield bool(doubts) and why.split(" ")[-1].rstrip(".") in doubts[0], f"{name} is said to be left out: {why}"
    yield answer["law"]["n_runs"] == len(runs), f"{len(runs)} runs are fitted, the answer says {answer['law']['n_runs']}"
    speeds = [impact["approach_speed_m_s"] for run in runs.values() for impact in run["impacts"]]
    yield answer["law"]["fitted_from_m_s"] >= 0.999 * min(speeds) and near(answer["law"]["fitted_to_m_s"], max(speeds), 1e-3), \
        f"speeds from {min(speeds):.3g} to {max(speeds):.3g} m/s"
    numbers = numbers_of(answer)
    stated = max(e["value"] or 0.0 for e in answer["errors"] if (e["quantity"], e["source"]) == ("peak_force", "law"))
    for name, run in runs.items():
        if not name.startswith("window-") or "yield_force" not in numbers:
            continue
        hit = run["impacts"][0]
        off = flown(yielding(numbers), answer["mass_kg"], hit["approach_speed_m_s"])["peak_force_kN"] * 1e3 / hit["peak_force_N"] - 1
        yield abs(off) <= stated + 0.005, f"{name}: the law is off by {100 * off:+.2f} % of the peak, {100 * stated:.1f} % is stated"


def of_the_band(answer: dict[str, Any], folder: str, words: str) -> Check:
    """Static and fast steel from the summaries of windows and twins, as the page's row of that speed has them."""
    places = os.path.join(folder, "twins")
    for name in sorted(os.listdir(places)) if os.path.isdir(places) else []:
        pair = [read(folder, *where, "summary.json")["impacts"][0] for where in (("runs", name.rpartition("-")[0]), ("twins", name))]
        if any(hit["rebound_speed_m_s"] is None for hit in pair):  # the scene ended on the rim: the pair is no row
            continue
        static, fast = pair if name.endswith("-fast") else reversed(pair)
        cells = [f"{hit['peak_force_N'] / 1e3:.0f}" for hit in (static, fast)] + [f"{1e3 * hit['peak_penetration_m']:.2f}" for hit in (static, fast)]
        cells += [f"{hit['rebound_speed_m_s'] / hit['approach_speed_m_s']:.3f}" for hit in (static, fast)]
        row = " ".join([f"{float(name.split('-')[1]):.3f}", *cells])
        yield row in words, f"page one has the row {row}"
        band = answer["steel_band"]["rows"]
        yield any(near(at["fast"]["peak_force_kN"], fast["peak_force_N"] / 1e3, 1e-9) for at in band), f"{name}: {fast['peak_force_N'] / 1e3:.1f} kN"


def of_the_device(answer: dict[str, Any], folder: str, words: str) -> Check:
    scene = again.scene(folder, sorted(again.summaries(folder))[-1])
    bearing, load = scene["bearing"], scene["load"]
    surface, steel = bearing["surface"], bearing["material"]["steel"]
    capacity = surface["planar_radius_mm"] - bearing["slider"]["diameter_mm"] / 2 + bearing["rim"].get("ledge_mm", 0.0)
    plain = words.replace(" *", "")
    for said in (bearing["name"], f"R 0 {surface['R0_m']:g} m", f"{surface['planar_radius_mm']:g} mm", f"Ø {bearing['slider']['diameter_mm']:g} mm",
                 f"{bearing['rim']['height_mm']:g} mm high, {bearing['rim']['thickness_mm']:g} mm thick", f"L c {capacity:.1f} mm",
                 f"yields at {steel['yield_MPa']:g} MPa", f"{whole(load['vertical_kN'])} kN", f"{whole(load['mass_kg'])} kg"):
        yield said_in(re.sub(r"\b(\d) (\d{3} kN)", r"\1\2", plain), said)
    yield near(answer["mass_kg"], load["mass_kg"], 1e-9), f"the answer is for {load['mass_kg']:g} kg"
    for key, value in re.findall(r"\b([a-z]\w*(?:\.\w+)+) ([\d.]+)[;.]", plain[plain.rfind("Assumed, not given"):] if "Assumed, not given" in plain else ""):
        own: Any = bearing
        for part in key.split("."):
            own = own.get(part, {})
        yield own == float(value.rstrip(".")), f"assumed {key} {value} for {own}"


def checks(folder: str) -> Check:
    calibration = read(folder, "calibration", "calibration.json")
    answer, rows, words = calibration["answer"], calibration["laws"]["rows"], words_of(folder)
    runs = again.fitted(folder, calibration)
    yield from of_the_device(answer, folder, words)
    yield from of_the_counts(folder, words)
    yield from of_the_law(answer, folder, runs, words)
    yield from of_the_table(answer, rows, words)
    yield from of_the_bars(answer, words)
    yield from of_the_parts(answer, rows, runs)
    yield from of_the_pair(answer, folder, runs, words)
    yield from of_the_band(answer, folder, words)
    yield from of_the_steel(answer, rows, runs, words)
    yield from of_the_runs(answer, folder, runs, words)
    for sentence in sentences_of(folder):
        yield len(sentence.split()) <= LONGEST, f"{len(sentence.split())} words: {sentence[:110]}"


def main(folder: str) -> int:
    missed = 0
    for met, said in checks(folder):
        missed += not met
        print(("ok      " if met else "FAILED  ") + said)
    print(f"{missed} number(s) of page one not met")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))

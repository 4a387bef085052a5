"""Every number of page one once more, by code of this file's own, from the runs and the record that the page stands on.

The law is flown by a Runge-Kutta method over formulas typed in here; sums, worst cases and strains are taken from the runs' summaries.
Usage: page_one.py MAIN_FOLDER (as `rimpact main` leaves it); exit 1 where a number is not met."""
import html
import json
import math
import os
import re
import sys
import tomllib
from collections.abc import Callable, Iterator
from typing import Any

Law = Callable[[float, float], float]  #: force [N] at penetration [m], deepest so far [m]
LONGEST = 30  #: words of a sentence
CLOSE = 3e-3  #: of an impact flown by another method
REPORTED = (("peak_force_kN", 1), ("penetration_mm", 2), ("contact_time_ms", 3), ("restitution", 4))  #: key of a row, column of the page


def read(*path: str) -> Any:
    with open(os.path.join(*path), encoding="utf-8") as file:
        return json.load(file)


def yielding(n: dict[str, float]) -> Law:
    """Of laws `elastoplastic` (docs/theory/rim.md) and `bilinear`; n in N and m."""
    k, f_y, h = n["k_i"] * 1e3, n["yield_force"] * 1e3, n["hardening"]

    def loading(d: float) -> float:
        x = k * d / f_y
        if "unloading_gain" not in n:
            return k * d if x <= 1 else f_y * (1 + h * (x - 1))
        p, c = n["hardening_exponent"], (1 - h) * x
        return f_y * (c / math.hypot(1, c) + h * ((1 + x) ** p - 1) / p)

    def force(d: float, deepest: float) -> float:
        if d >= deepest:
            return loading(d)
        top = loading(deepest)
        if "unloading_gain" not in n:
            return top - k * (deepest - d)
        slope = k * (1 + n["unloading_gain"] * (k * deepest / f_y) ** n["unloading_exponent"])
        w = min(0.5, slope * deepest / top - 1)
        s = 1 - (deepest - d) * slope / ((1 + w) * top)
        return top * s * (1 - w + w * max(0.0, s))
    return force


def flown(law: Law, mass: float, speed: float) -> dict[str, float]:
    """A weightless impact, in the units of the record's table."""
    d, v, t, deepest, peak, h = 0.0, speed, 0.0, 0.0, 0.0, 2e-6
    while t < 1.0:
        k1 = -law(d, deepest) / mass
        k2 = -law(d + h * v / 2, max(deepest, d)) / mass
        k3 = -law(d + h * v / 2 + h * h * k1 / 4, max(deepest, d)) / mass
        d, v, t = d + h * v + h * h * (k1 + k2 + k3) / 6, v + h * (k1 + 4 * k3) / 6 + h * k2 / 6, t + h
        deepest = max(deepest, d)
        force = law(d, deepest)
        peak = max(peak, force)
        if v < 0 and force <= 0:
            break
    return {"peak_force_kN": peak / 1e3, "penetration_mm": 1e3 * deepest, "contact_time_ms": 1e3 * t, "restitution": -v / speed}


def first_page(folder: str) -> str:
    with open(os.path.join(folder, "report.html"), encoding="utf-8") as file:
        page = file.read()
    first = page[page.index('<section id="first"'):]
    return re.sub(r"<(script|style|svg)\b.*?</\1>", "", first[:first.index("</section>")], flags=re.DOTALL)


def sentences_of(folder: str) -> list[str]:
    """Of paragraphs and lists, where sentences stand."""
    said = re.findall(r"<(p|li)\b[^>]*>(.*?)</\1>", first_page(folder), flags=re.DOTALL)
    texts = [re.sub(r"\s+", " ", html.unescape(re.sub(r"<[^>]*>", "", text))) for _, text in said]
    return [sentence for text in texts for sentence in re.split(r"(?<=[.!?:;]) ", text) if sentence.strip()]


def words_of(folder: str) -> str:
    first = first_page(folder)
    return re.sub(r"\s+", " ", html.unescape(re.sub(r"<[^>]*>", " ", first))).replace("\u202f", " ").replace("\u00a0", " ")


def near(said: float, truth: float, tolerance: float, digit: float = 0.0) -> bool:
    return abs(said - truth) <= tolerance * abs(truth) + 0.51 * digit


def digit_of(text: str) -> float:
    """What the last digit of a number stands for."""
    return 10.0 ** -len(text.partition(".")[2]) if "." in text else 1.0


def of_the_table(answer: dict[str, Any], words: str) -> Iterator[tuple[bool, str]]:
    numbers = {name: entry["value"] for name, entry in answer["law"]["element"].items() if isinstance(entry, dict)}
    if "yield_force" not in numbers:
        yield True, f"the law {answer['law']['name']} does not yield: its table is not flown again here"
        return
    shown = re.findall(r"(\d\.\d{3}) (?:! )?(\d+) (\d+\.\d\d) (\d+\.\d) (\d\.\d{3}) ", words)
    yield len(shown) == len(answer["table"]), f"page one has {len(shown)} of the table's {len(answer['table'])} rows"
    for row, cells in zip(answer["table"], shown):
        own = flown(yielding(numbers), answer["mass_kg"], row["speed_m_s"])
        for key, column in REPORTED:
            said = float(cells[column])
            yield near(said, own[key], CLOSE, digit_of(cells[column])), f"{row['speed_m_s']:.3f} m/s, {key}: {said:g} for {own[key]:.5g}"


def of_the_bars(answer: dict[str, Any], words: str) -> Iterator[tuple[bool, str]]:
    names = {"peak_force": "Peak force", "depth": "Depth", "rebound": "Rebound", "k_i": "k i", "e": "e"}
    for quantity, name in names.items():
        parts = [e["value"] for e in answer["errors"] if e["quantity"] == quantity and e["value"] is not None]
        if not parts:
            continue
        total = 100 * math.sqrt(sum(value * value for value in parts))
        found = re.search(rf"\b{name} (?:[a-z]+ [\d.]+ % )*([\d.]+) % (?:not known|[A-Z]|k i|e |95)", words)
        yield found is not None and near(float(found[1]), total, 0.0, 2 * digit_of(found[1])), \
            f"the bar of {quantity} ends at {found[1] if found else 'nothing'} % for {total:.3g} %"


def of_the_runs(answer: dict[str, Any], folder: str, words: str) -> Iterator[tuple[bool, str]]:
    """Strain, speeds and load from the summaries; what the law makes of single impacts, flown anew."""
    runs = {name: read(folder, "runs", name, "summary.json") for name in sorted(os.listdir(os.path.join(folder, "runs")))}
    judged = {name: max((at["averaged_plastic_strain"] for place, at in run["steel"].items() if place != "slider_edge"), default=0.0)
              for name, run in runs.items() if run.get("steel")}
    if answer["strain"]:
        largest = max(judged.values())
        yield near(answer["strain"]["largest"], largest, 1e-9), f"the largest strain is {100 * largest:.3g} %"
        yield f"{100 * largest:.0f} %" in words, f"page one says {100 * largest:.0f} %"
    speeds = [impact["approach_speed_m_s"] for run in runs.values() for impact in run["impacts"]]
    yield answer["law"]["fitted_from_m_s"] >= 0.999 * min(speeds) and near(answer["law"]["fitted_to_m_s"], max(speeds), 1e-3), \
        f"speeds from {min(speeds):.3g} to {max(speeds):.3g} m/s"
    numbers = {name: entry["value"] for name, entry in answer["law"]["element"].items() if isinstance(entry, dict)}
    stated = max(e["value"] or 0.0 for e in answer["errors"] if (e["quantity"], e["source"]) == ("peak_force", "law"))
    for name, run in runs.items():
        if not name.startswith("window-") or "yield_force" not in numbers:
            continue
        hit = run["impacts"][0]
        off = flown(yielding(numbers), answer["mass_kg"], hit["approach_speed_m_s"])["peak_force_kN"] * 1e3 / hit["peak_force_N"] - 1
        yield abs(off) <= stated + 0.005, f"{name}: the law is off by {100 * off:+.2f} % of the peak, {100 * stated:.1f} % is stated"


def of_the_band(answer: dict[str, Any], folder: str, words: str) -> Iterator[tuple[bool, str]]:
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


def of_the_device(answer: dict[str, Any], folder: str, words: str) -> Iterator[tuple[bool, str]]:
    name = sorted(os.listdir(os.path.join(folder, "runs")))[-1]
    with open(os.path.join(folder, "runs", name, "scene.toml"), "rb") as file:
        scene = tomllib.load(file)
    bearing, load = scene["bearing"], scene["load"]
    capacity = bearing["surface"]["planar_radius_mm"] - bearing["slider"]["diameter_mm"] / 2 + bearing["rim"].get("ledge_mm", 0.0)
    for said in (bearing["name"], f"{bearing['slider']['diameter_mm']:g} mm", f"{bearing['rim']['height_mm']:g} mm", f"{load['vertical_kN']:.0f} kN"):
        yield said in words.replace("3 200", "3200"), f"page one says {said}"
    yield f"{capacity:.1f} mm" in words, f"page one says L_c = {capacity:.1f} mm"
    yield near(answer["mass_kg"], load["mass_kg"], 1e-9), f"the answer is for {load['mass_kg']:g} kg"


def checks(folder: str) -> Iterator[tuple[bool, str]]:
    answer, words = read(folder, "calibration", "calibration.json")["answer"], words_of(folder)
    yield from of_the_device(answer, folder, words)
    yield from of_the_table(answer, words)
    yield from of_the_bars(answer, words)
    yield from of_the_band(answer, folder, words)
    yield from of_the_runs(answer, folder, words)
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

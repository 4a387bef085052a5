"""What the command does beside this process: finite-element runs, sweeps, geometry questions, exports."""
from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path

from rimpact import program
from rimpact.calibration import Calibration
from rimpact.errors import InputError
from rimpact.results import Fleet, Run, load, load_fleet
from rimpact.scene import Scene, Value, toml_value


def settings_words(settings: Mapping[str, Value] | None) -> list[str]:
    """As --set takes them."""
    return [word for key, value in (settings or {}).items() for word in ("--set", f"{key}={toml_value(value)}")]


def _write(path: Path, text: str) -> str:
    """Writes what is not there already: shards that begin together read the same file."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.is_file() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")
    return os.path.abspath(path)


def on_disk(scene: Scene | str | os.PathLike, place: str | os.PathLike) -> str:
    """What the command reads of a scene: its own file, or the resolved scene in `place`."""
    return _write(Path(place) / "scene.toml", scene.toml()) if isinstance(scene, Scene) else os.fspath(scene)


def run(scene: Scene | str | os.PathLike, folder: str | os.PathLike, *, rung: str | None = None, mesh: int | None = None, resume: bool = False,
        force: bool = False, progress: Callable[[str], object] | None = None) -> Run:
    """Runs a scene by finite elements into a run folder, as `rimpact run` does, and reads it.

    rung: "rim", "rigid-dish" or "full"; mesh: 1, 2 or 3 (0: a draft); resume: goes on from the folder's checkpoint; progress: called with
    each line of progress (simulated time, gap, force, time to go). Raises Stopped where the solver stopped: the folder keeps what is before it.

    >>> rimpact.run("impact-window", "my-solid", rung="rim", mesh=1, progress=print)   # doctest: +SKIP
    """
    with tempfile.TemporaryDirectory() as place:
        words = ["run", on_disk(scene, place), "-o", os.fspath(folder)]
        for name, value in (("--rung", rung), ("--mesh", mesh)):
            words += [name, str(value)] if value is not None else []
        words += [name for name, wanted in (("--resume", resume), ("--force", force)) if wanted]
        program.run(*words, *([] if progress else ["--quiet"]), progress=progress)
    return load(folder)


def sweep(scene: Scene | str | os.PathLike, over: Mapping[str, Sequence[Value]] | str | os.PathLike, folder: str | os.PathLike, *,
          settings: Mapping[str, Value] | None = None, shard: str | None = None) -> Fleet:
    """Runs the reduced model over every combination of values, as `rimpact reduced --sweep` does, and reads the table.

    over: values by key, {"excitation.scale": [0.9, 1.0, 1.1], "reduced.restitution": [0.5, 0.7]}, or a sweep file. What `folder` holds of the
    same sweep is kept; it also gets the scene and the sweep (asked/). shard: "2/4" runs the second of four parts.

    >>> fleet = rimpact.sweep("impact-window", {"excitation.speed_m_per_s": [0.2, 0.4]}, "my-fleet")
    >>> bool(fleet.runs.peak_impact_force_N.is_monotonic_increasing)
    True
    """
    asked = Path(folder) / "asked"  # a sweep goes on where its files lie as they lay
    if isinstance(over, Mapping):
        if not over or not all(len(values) for values in over.values()):
            raise InputError("over: every key needs one value or more")
        lines = [f"{key} = {toml_value(list(values))}" for key, values in over.items()]
        over = _write(asked / "sweep.toml", "\n".join(["[grid]", *lines]) + "\n")
    words = ["reduced", on_disk(scene, asked), "--sweep", os.fspath(over), "-o", os.fspath(folder), "--quiet", *settings_words(settings)]
    program.run(*words, *(["--shard", shard] if shard else []))
    return load_fleet(folder)


def geometry(bearing: Scene | str | os.PathLike, vary: Mapping[str, str | tuple[float, float] | tuple[float, float, int]], speed: float,
             folder: str | os.PathLike, *, targets: Mapping[str, float] | None = None, settings: Mapping[str, Value] | None = None,
             mesh: int | None = None, jobs: int | None = None, proof: bool = True) -> dict:
    """Asks which of a bearing's rims meets its targets at a speed of approach [m/s], as `rimpact geometry --vary` does by finite elements.

    bearing: a bearing, scene or case folder with a load; vary: {"rim.thickness_mm": (20, 80)} or with a number of rims (20, 80, 5); targets:
    {"peak_kN": 4000}, each a most. Returns geometry.json: `points` (a row a rim), `answer` and `sentence`.

    >>> found = rimpact.geometry("my-case", {"rim.thickness_mm": (20, 80)}, 0.8, "my-study", targets={"peak_kN": 4000})   # doctest: +SKIP
    >>> found["sentence"]                                                                                                # doctest: +SKIP
    """
    with tempfile.TemporaryDirectory() as place:
        words = ["geometry", on_disk(bearing, place), "--at", f"speed={float(speed)!r}", "-o", os.fspath(folder), "--quiet", "--json", *settings_words(settings)]
        for key, ends in vary.items():
            words += ["--vary", f"{key}={ends if isinstance(ends, str) else ':'.join(f'{end:.12g}' for end in ends)}"]
        for name, most in (targets or {}).items():
            words += ["--target", f"{name}={float(most)!r}"]
        for name, value in (("--mesh", mesh), ("--jobs", jobs)):
            words += [name, str(value)] if value is not None else []
        return json.loads(program.run(*words, *([] if proof else ["--no-proof"])))


def export(source: Calibration | str | os.PathLike, folder: str | os.PathLike, formats: Iterable[str] = ("opensees", "csv"), *, mass: float | None = None,
           law: str | None = None) -> list[Path]:
    """Writes a calibrated bearing for other programs, as `rimpact export` does, and returns the files of `folder`.

    formats: of "opensees", "sap2000", "etabs", "csv", "dxf"; mass: that the bearing carries [kg]; law: another of the ranked laws, or "pair".

    >>> runs = [rimpact.run_reduced(rimpact.Scene("impact-window", {"excitation.speed_m_per_s": speed})) for speed in (0.1, 0.2, 0.4)]
    >>> made = rimpact.calibrate(runs, "to-hand-over", law="no-tension", laws="none")
    >>> len(rimpact.export(made, "handed-over", ["csv"])) > 0
    True
    """
    place = source.folder if isinstance(source, Calibration) else source
    words = ["export", os.fspath(place), "-o", os.fspath(folder), "--quiet", *(f"--{each}" for each in formats)]
    for name, value in (("--mass", mass), ("--law", law)):
        words += [name, str(value)] if value is not None else []
    program.run(*words)
    return sorted(Path(folder).iterdir())

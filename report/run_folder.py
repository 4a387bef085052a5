"""A run folder as docs/interface.md describes it: response.h5 (or response.csv), summary.json, scene.toml. SI units.

A file that is missing leaves its part empty and is told in `problems`; a file that is there and cannot be read
raises DataError. Signals keep their names (displacement_x, impact_y, energy_plastic ...)."""
import os
import tomllib
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from . import bearing, triple
from .data_files import check_signals, read_csv, read_hdf5, read_json
from .errors import DataError
from .numbers import is_number
from .shapes import SCENE, SUMMARY, check


@dataclass
class Run:
    name: str
    folder: str
    signals: dict[str, np.ndarray] = field(default_factory=dict)
    summary: dict[str, Any] = field(default_factory=dict)
    scene: dict[str, Any] = field(default_factory=dict)
    scene_text: str = ""
    meta: dict[str, Any] = field(default_factory=dict)
    problems: list[str] = field(default_factory=list)

    def has(self, *names: str) -> bool:
        return all(name in self.signals for name in names)

    def get(self, *path: str, default: Any = None) -> Any:
        """Nested look-up in the scene: get("excitation", "kind")."""
        return lookup(self.scene, *path, default=default)

    @property
    def time(self) -> np.ndarray:
        return self.signals["time"]

    @property
    def kind(self) -> str:
        return self.get("excitation", "kind", default="")

    @property
    def time_label(self) -> str:
        """For quasi-static scenes `time` is a load parameter."""
        return "load parameter (–)" if self.kind in ("push", "cyclic", "figure-eight", "path") else "time (s)"

    @property
    def rung(self) -> str:
        return self.summary.get("rung") or ("reduced" if "plastic_strain_max" not in self.signals else "FE")

    @property
    def status(self) -> str:
        return self.summary.get("status", "done" if self.signals else "missing")

    @property
    def impacts(self) -> list[dict[str, Any]]:
        return self.summary.get("impacts", [])

    @property
    def lateral_capacity(self) -> float | None:
        """L_c [m] as the program states it; of a run of an earlier version by its dimensions, else by the stored gap."""
        if is_number(stated := self.summary.get("lateral_capacity_m")):
            return float(stated)
        if self.get("reduced", "model") in ("dcfp", "lir-dcfp"):
            return self.get("isolator", "capacity_m")
        if self.get("reduced", "model") == "tfp":
            return triple.lateral_capacity(self.get("isolator", default={}))
        known = bearing.lateral_capacity(self.get("bearing", default={}))
        if known:
            return known
        if self.has("gap", "displacement_x", "displacement_y"):
            return float(np.median(self.signals["gap"] + self.norm("displacement")))
        return None

    def norm(self, base: str) -> np.ndarray:
        return np.hypot(self.signals[base + "_x"], self.signals[base + "_y"])

    def is_planar(self, tolerance: float = 1e-3) -> bool:
        """Whether the motion stays on one line through the vertex (then one component tells everything)."""
        if not self.has("displacement_x", "displacement_y"):
            return False
        points = np.column_stack([self.signals["displacement_x"], self.signals["displacement_y"]])
        size = np.linalg.svd(points, compute_uv=False)
        return len(size) < 2 or size[1] <= tolerance * max(size[0], 1e-12)

    def direction(self) -> np.ndarray:
        """Unit vector of the motion's line; +x unless the scene or the motion says otherwise."""
        angle = self.get("excitation", "direction_deg")
        if angle is None and self.has("displacement_x", "displacement_y"):
            far = int(np.argmax(self.norm("displacement")))
            x, y = self.signals["displacement_x"][far], self.signals["displacement_y"][far]
            angle = np.degrees(np.arctan2(y, x)) % 180.0 if np.hypot(x, y) > 0 else 0.0
        angle = np.radians(angle or 0.0)
        return np.array([np.cos(angle), np.sin(angle)])

    def along(self, base: str, direction: np.ndarray) -> np.ndarray:
        return direction[0] * self.signals[base + "_x"] + direction[1] * self.signals[base + "_y"]


def lookup(tree: Any, *path: str, default: Any = None) -> Any:
    for key in path:
        if not isinstance(tree, dict) or key not in tree:
            return default
        tree = tree[key]
    return tree


def parse_scene(text: str, path: str) -> dict[str, Any]:
    """Throws DataError naming the file, and the key of a value of the wrong type."""
    try:
        scene = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise DataError(f"{path} is not readable TOML ({error})") from None
    check(scene, SCENE, path)
    return scene


def is_run_folder(folder: str) -> bool:
    return any(os.path.isfile(os.path.join(folder, name)) for name in ("response.h5", "response.csv", "summary.json"))


def load_run(folder: str, name: str | None = None) -> Run:
    """Reads what the folder holds. Throws DataError for a file that is there but unreadable."""
    run = Run(name or os.path.basename(os.path.normpath(folder)), folder)
    h5, csv = os.path.join(folder, "response.h5"), os.path.join(folder, "response.csv")
    if os.path.isfile(h5):
        run.signals, run.meta = read_hdf5(h5)
        check_signals(h5, run.signals)
    elif os.path.isfile(csv):
        run.signals = read_csv(csv)
        check_signals(csv, run.signals)
    else:
        run.problems.append("no response.h5 or response.csv")
    _read_summary(run)
    _read_scene(run)
    return run


def _read_summary(run: Run) -> None:
    path = os.path.join(run.folder, "summary.json")
    if not os.path.isfile(path):
        run.problems.append("no summary.json")
        return
    run.summary = read_json(path, SUMMARY)


def _read_scene(run: Run) -> None:
    path = os.path.join(run.folder, "scene.toml")
    if os.path.isfile(path):
        try:
            with open(path, encoding="utf-8") as file:
                run.scene_text = file.read()
        except (OSError, UnicodeDecodeError) as error:
            raise DataError(f"cannot read {path}: {error}") from None
    else:
        run.scene_text = run.meta.get("scene", "")
    if not run.scene_text:
        run.problems.append("no scene.toml")
        return
    run.scene = parse_scene(run.scene_text, path)

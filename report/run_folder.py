"""A run folder as INTERFACE describes it: response.h5 (or response.csv), summary.json, scene.toml. SI units.

A file that is missing leaves its part empty and is told in `problems`; a file that is there and cannot be read
raises DataError. Signals keep their names (displacement_x, impact_y, energy_plastic ...)."""
import json
import os
import re
import tomllib
from dataclasses import dataclass, field

import h5py
import numpy as np

from .errors import DataError

CSV_NAMES = {"time_s": "time", "ux_m": "displacement_x", "uy_m": "displacement_y", "uz_m": "displacement_z",
             "Fx_N": "force_x", "Fy_N": "force_y", "Fz_N": "force_z", "Ix_N": "impact_x", "Iy_N": "impact_y",
             "gap_m": "gap"}


@dataclass
class Run:
    name: str
    folder: str
    signals: dict = field(default_factory=dict)
    summary: dict = field(default_factory=dict)
    scene: dict = field(default_factory=dict)
    scene_text: str = ""
    meta: dict = field(default_factory=dict)
    problems: list = field(default_factory=list)

    def has(self, *names):
        return all(name in self.signals for name in names)

    def get(self, *path, default=None):
        """Nested look-up in the scene: get("excitation", "kind")."""
        return lookup(self.scene, *path, default=default)

    @property
    def time(self):
        return self.signals["time"]

    @property
    def kind(self):
        return self.get("excitation", "kind", default="")

    @property
    def rung(self):
        return self.summary.get("rung") or ("reduced" if "plastic_strain_max" not in self.signals else "FE")

    @property
    def status(self):
        return self.summary.get("status", "done" if self.signals else "missing")

    @property
    def impacts(self):
        return self.summary.get("impacts") or []

    @property
    def lateral_capacity(self):
        """L_c [m] by (2-5); from the stored gap when the scene does not say."""
        r_p, b_s = self.get("bearing", "surface", "planar_radius_mm"), self.get("bearing", "slider", "diameter_mm")
        if r_p and b_s:
            return (r_p + (self.get("bearing", "rim", "ledge_mm") or 0.0) - b_s / 2) / 1e3
        if self.has("gap", "displacement_x", "displacement_y"):
            return float(np.median(self.signals["gap"] + self.norm("displacement")))
        return None

    def norm(self, base):
        return np.hypot(self.signals[base + "_x"], self.signals[base + "_y"])

    def is_planar(self, tolerance=1e-3):
        """Whether the motion stays on one line through the vertex (then one component tells everything)."""
        if not self.has("displacement_x", "displacement_y"):
            return False
        points = np.column_stack([self.signals["displacement_x"], self.signals["displacement_y"]])
        size = np.linalg.svd(points, compute_uv=False)
        return len(size) < 2 or size[1] <= tolerance * max(size[0], 1e-12)

    def direction(self):
        """Unit vector of the motion's line; +x unless the scene or the motion says otherwise."""
        angle = self.get("excitation", "direction_deg")
        if angle is None and self.has("displacement_x", "displacement_y"):
            far = int(np.argmax(self.norm("displacement")))
            x, y = self.signals["displacement_x"][far], self.signals["displacement_y"][far]
            angle = np.degrees(np.arctan2(y, x)) % 180.0 if np.hypot(x, y) > 0 else 0.0
        angle = np.radians(angle or 0.0)
        return np.array([np.cos(angle), np.sin(angle)])

    def along(self, base, direction):
        return direction[0] * self.signals[base + "_x"] + direction[1] * self.signals[base + "_y"]


def lookup(tree, *path, default=None):
    for key in path:
        if not isinstance(tree, dict) or key not in tree:
            return default
        tree = tree[key]
    return tree


def is_run_folder(folder):
    return any(os.path.isfile(os.path.join(folder, name)) for name in ("response.h5", "response.csv", "summary.json"))


def read_json(path):
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except (ValueError, UnicodeDecodeError) as error:
        raise DataError(f"{path} is not readable JSON ({error})") from None
    except OSError as error:
        raise DataError(f"cannot read {path}: {error.strerror}") from None


def read_hdf5(path):
    """Signals and meta text of a response.h5."""
    try:
        with h5py.File(path, "r") as file:
            if "response" not in file:
                raise DataError(f"{path} holds no group /response")
            signals = {name: np.asarray(data[()], dtype=float) for name, data in file["response"].items()}
            group = file.get("meta")
            meta = {}
            if group is not None:
                meta.update({key: _text(value) for key, value in group.attrs.items()})
                meta.update({key: _text(data[()]) for key, data in group.items() if isinstance(data, h5py.Dataset)})
    except OSError as error:
        raise DataError(f"{path} is not readable HDF5 ({str(error).splitlines()[0]})") from None
    except (ValueError, KeyError, RuntimeError, TypeError) as error:
        raise DataError(f"{path} is damaged ({error})") from None
    return signals, meta


def _text(value):
    value = value.item() if isinstance(value, np.ndarray) and value.size == 1 else value
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def read_csv(path):
    try:
        with open(path, encoding="utf-8") as file:
            header = file.readline().strip().split(",")
            table = np.loadtxt(file, delimiter=",", ndmin=2)
    except (ValueError, UnicodeDecodeError) as error:
        raise DataError(f"{path} is not a readable response table ({error})") from None
    except OSError as error:
        raise DataError(f"cannot read {path}: {error.strerror}") from None
    if table.size == 0 or table.shape[1] != len(header):
        raise DataError(f"{path} has {len(header)} columns in its header and "
                        f"{table.shape[1] if table.size else 0} in its rows")
    return {CSV_NAMES.get(name.strip(), name.strip()): table[:, i] for i, name in enumerate(header)}


def check_signals(path, signals):
    if "time" not in signals:
        raise DataError(f"{path} holds no signal `time`")
    n = len(signals["time"])
    if n < 2:
        raise DataError(f"{path} holds {n} instants; at least 2 are needed")
    for name, values in signals.items():
        if values.shape != (n,):
            raise DataError(f"{path}: signal {name} has {values.size} values, time has {n}")
        if not np.all(np.isfinite(values)):
            raise DataError(f"{path}: signal {name} holds a value that is not a number")


def load_run(folder, name=None):
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


def _read_summary(run):
    path = os.path.join(run.folder, "summary.json")
    if not os.path.isfile(path):
        run.problems.append("no summary.json")
        return
    run.summary = read_json(path)
    if not isinstance(run.summary, dict):
        raise DataError(f"{path} holds no JSON object")


def _read_scene(run):
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
    try:
        run.scene = tomllib.loads(run.scene_text)
    except tomllib.TOMLDecodeError as error:
        raise DataError(f"{path} is not readable TOML ({error})") from None


def assumption_keys(scene_text):
    """Dotted keys whose line, or whose table's header line, carries the word "assumption" as a comment."""
    table, whole_table, keys = "", False, set()
    for line in scene_text.splitlines():
        code, _, comment = line.partition("#")
        said = "assumption" in comment.lower()
        header = re.match(r"\s*\[([^\[\]]+)\]", code)
        entry = re.match(r"\s*([\w.\-]+)\s*=", code)
        if header:
            table, whole_table = header.group(1).strip(), said
        elif entry and (said or whole_table):
            keys.add(f"{table}.{entry.group(1)}" if table else entry.group(1))
    return keys

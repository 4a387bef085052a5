"""Scenes, and reduced runs of them in this process."""
from __future__ import annotations

import difflib
import html
import json
import os
import tomllib
import warnings
from collections.abc import Mapping
from functools import cached_property

from rimpact import _core
from rimpact.errors import InputError
from rimpact.results import Run, run_from_signals

Value = bool | int | float | str | list


def toml_value(value: Value) -> str:
    """A value as TOML writes it. JSON's forms of numbers, strings and lists are TOML's too."""
    if hasattr(value, "item"):  # numpy's scalars
        value = value.item()
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml_value(each) for each in value) + "]"
    if isinstance(value, float):
        return repr(value)  # shortest that reads back; inf and nan are TOML's words too
    return json.dumps(value, ensure_ascii=False)


class Scene:
    """A bearing, its load, a motion and the models' settings, every default filled in.

    `where`: a TOML file, a folder with scene.toml, or a built-in scene's name (`scene_names()`). `settings`: dotted keys over values,
    as --set takes them: {"excitation.scale": 1.05, "bearing.rim.height_mm": 70}. Raises InputError with file, line, value and bound.

    >>> scene = rimpact.Scene("impact-window", {"bearing.rim.thickness_mm": 35})
    >>> scene["bearing.rim.thickness_mm"], "load.mass_kg" in scene
    (35.0, True)
    >>> scene == pickle.loads(pickle.dumps(scene))
    True
    """

    def __init__(self, where: str | os.PathLike, settings: Mapping[str, Value] | None = None) -> None:
        self._where, self._settings = os.fspath(where), dict(settings or {})
        words = [f"{key}={toml_value(value)}" for key, value in self._settings.items()]
        self._core = _core.load_scene(self._where, words)

    @classmethod
    def _restored(cls, where: str, settings: dict[str, Value], toml: str) -> Scene:
        """As it was resolved when it was pickled, whatever its file holds now."""
        scene = cls.__new__(cls)
        scene._where, scene._settings, scene._core = where, settings, _core.parse_scene(toml, [], ".")
        return scene

    def __reduce__(self) -> tuple:
        where = os.path.abspath(self._where) if os.path.exists(self._where) else self._where
        return Scene._restored, (where, self._settings, self.toml())

    def __eq__(self, other: object) -> bool:
        """Whether all that is resolved is the same, wherever it was read from."""
        return self.toml() == other.toml() if isinstance(other, Scene) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.toml())

    def __getitem__(self, key: str) -> Value | dict:
        """The value of a dotted key as resolved, in the unit of its name: scene["bearing.rim.thickness_mm"]; of a table a dict of it."""
        at: Value | dict = self._values
        for depth, part in enumerate(key.split(".")):
            if not isinstance(at, dict) or part not in at:
                known = list(at) if isinstance(at, dict) else []
                near = difflib.get_close_matches(part, known, 1)
                table = ".".join(key.split(".")[:depth])
                raise InputError(f'the scene has no key "{key}"' + (f'; did you mean "{".".join(filter(None, (table, near[0])))}"?' if near else ""))
            at = at[part]
        return at

    def __contains__(self, key: str) -> bool:
        try:
            self[key]
        except InputError:
            return False
        return True

    @cached_property
    def _values(self) -> dict:
        return tomllib.loads(self.toml())

    def _repr_html_(self) -> str:
        rows = {"bearing": self.bearing, "supported mass": f"{self.mass:.6g} kg", "dead load": f"{self.weight / 1e3:.6g} kN",
                "travel to the rim": f"{1e3 * self.lateral_capacity:.4g} mm", "motion": self["excitation.kind"], "duration": f"{self.duration:.4g} s"}
        body = "".join(f"<tr><th>{html.escape(name)}</th><td>{html.escape(str(value))}</td></tr>" for name, value in rows.items())
        doubts = "".join(f"<li>{html.escape(each)}</li>" for each in self.remarks)
        return f"<b>{html.escape(self.name)}</b><table>{body}</table>" + (f"<ul>{doubts}</ul>" if doubts else "")

    def with_settings(self, settings: Mapping[str, Value]) -> Scene:
        """The same scene read again with further keys; values that follow from them follow."""
        return Scene(self._where, {**self._settings, **settings})

    @property
    def name(self) -> str:
        """Its name."""
        return self._core.name

    @property
    def bearing(self) -> str:
        """Its bearing's name."""
        return self._core.bearing

    @property
    def mass(self) -> float:
        """Inertia in all directions [kg]."""
        return self._core.mass

    @property
    def weight(self) -> float:
        """Dead load W [N]."""
        return self._core.weight

    @property
    def duration(self) -> float:
        """Of the motion [s]."""
        return self._core.duration

    @property
    def lateral_capacity(self) -> float:
        """L_c, the displacement at which the rim is touched [m]."""
        return self._core.lateral_capacity

    @property
    def remarks(self) -> list[str]:
        """Sentences: what the file leaves in doubt, and what its reading filled in."""
        return self._core.remarks

    def toml(self) -> str:
        """As resolved, every default written out; a scene file."""
        return self._core.toml()

    def __repr__(self) -> str:
        return f"Scene({self.name!r}, bearing {self.bearing!r}, {self.mass:.0f} kg)"


def scene_names() -> list[str]:
    """The built-in scenes.

    >>> "impact-window" in rimpact.scene_names()
    True
    """
    return _core.scene_names()


def bearing_names() -> list[str]:
    """The built-in bearings.

    >>> "shfps-225" in rimpact.bearing_names()
    True
    """
    return _core.bearing_names()


def run_reduced(scene: Scene | str | os.PathLike, folder: str | os.PathLike | None = None) -> Run:
    """Flies the scene by its reduced model, in about a millisecond, and returns response, summary and impacts.

    The interpreter's lock is released meanwhile: threads run side by side. `folder`: also writes a run folder there, as `rimpact
    reduced` does. A run that stops early (the slider leaves the dish) is returned too: see summary["status"]. A UserWarning says where
    an impact was outside the speeds its law was fitted to.

    >>> run = rimpact.run_reduced(rimpact.Scene("ricker-0.78g-1.0s", {"excitation.scale": 1.05}))
    >>> run.summary["status"], len(run.impacts) > 0
    ('done', True)
    """
    scene = scene if isinstance(scene, Scene) else Scene(scene)
    flown = _core.run(scene._core)
    summary = json.loads(flown.summary_json())
    if summary.get("beyond_fit"):
        said = [each for each in summary.get("warnings") or [] if "outside the speeds" in each]
        warnings.warn((said or ["an impact outside the speeds the impact element was fitted to"])[0], UserWarning, stacklevel=2)
    if folder is not None:
        flown.save(scene._core, os.fspath(folder))
    return run_from_signals(flown.signals(), summary, scene.toml(), folder)


def summarise(scene: Scene | str | os.PathLike) -> dict:
    """Peaks and impacts alone, as summary.json holds them; no response is kept. For samplers and optimisers.

    >>> rimpact.summarise("impact-window")["n_impacts"]
    1
    """
    scene = scene if isinstance(scene, Scene) else Scene(scene)
    return json.loads(_core.summarise(scene._core))

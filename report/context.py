"""What the sections of a report read, and where they put their pictures."""
from typing import Any

from . import calibration_file
from .bearing import assumed_keys, lateral_capacity
from .blocks import Pictures
from .doubts import Doubts
from .numbers import is_number
from .results import load_results
from .run_folder import Run, parse_scene

RIGID_BODIES = {"dcfp": "double concave bearing", "lir-dcfp": "double concave bearing", "tfp": "triple friction pendulum"}  #: models of [isolator]
WHOLE = {"rigid-dish", "full"}  #: rungs in which pad and foot take part


def _listed(rung: Any) -> list[str]:
    return rung if isinstance(rung, list) else [rung] if isinstance(rung, str) else []


def _has_stack(run: Run) -> bool:
    """Whether pad and foot take part: as solids, or as terms of the reduced model."""
    return run.rung in WHOLE or run.rung == "reduced" and any(run.get("reduced", term) is True for term in ("finite_pad", "socket_friction"))


class Context:
    """Everything a section may read, and where it puts its pictures."""

    def __init__(self, folder: str, figures: str, beside: str) -> None:
        """`beside`: the folder the report goes to, for files that stand beside it."""
        self.beside = beside
        self.results = load_results(folder)
        self.calibration = calibration_file.read(self.results.calibration)
        for entry in self.results.entries:  # main.json tells the roles; without it the calibration does
            if entry.role == "history":
                entry.role = self.calibration.role(entry.name) or entry.role
        self.problems = self.results.problems
        self.pictures = Pictures(figures, self.problems)
        self.doubts = Doubts(self.results, self.results.answer)
        self._read_scene()

    def _read_scene(self) -> None:
        """The scene that stands for bearing and load: a run's, else the one the calibration was made of."""
        reference = self.results.reference
        text = reference.scene_text if reference else self.results.curves.get("scene", "")
        self.scene: dict[str, Any] = reference.scene if reference else parse_scene(text, "curves.json: scene") if text else {}
        self.assumed = assumed_keys(text, self.scene)
        self.rigid_bodies = RIGID_BODIES.get(self.scene.get("reduced", {}).get("model"), "")
        if self.rigid_bodies:  # nothing of [bearing] is read
            self.assumed = {key for key in self.assumed if key.split(".")[0] in self.scene}
        runs = [entry.any_run for entry in self.results.entries]
        self.whole_bearing = any(run is not None and _has_stack(run) for run in runs) or bool(WHOLE & set(_listed(self.results.answer.get("rung"))))
        stated = [*(run.lateral_capacity for run in runs if run is not None), self.results.curves.get("lateral_capacity_m"),
                  None if self.rigid_bodies else lateral_capacity(self.scene.get("bearing", {}))]
        self.capacity: float | None = next((found for found in stated if is_number(found)), None)

    @property
    def measured(self) -> bool:
        """Whether the law was fitted to somebody's measured curves and to nothing else."""
        impacts = self.results.impacts
        return self.results.answer.get("source") == "measured" or (
            bool(impacts) and all(impact.source == "measured" for impact in impacts))

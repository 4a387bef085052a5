"""What the tests of `rimpact export` share: a calibration to export, and the exported files run on recorders and stubs."""
import json
import os
import py_compile
import shutil
import subprocess
import unittest
from collections.abc import Callable
from typing import Any

from command import Done, rimpact

ELEMENT = {"lateral_capacity_m": 0.4, "reference_speed_m_per_s": 0.5, "k_i": {"value": 1085500, "unit": "kN/m"}, "yield_force": {"value": 455.24, "unit": "kN"},
           "hardening": {"value": 0.38454, "unit": "-"}, "hardening_exponent": {"value": 0.39266, "unit": "-"},
           "unloading_gain": {"value": 0.2928, "unit": "-"}, "unloading_exponent": {"value": 0.54265, "unit": "-"}}


class Recorder:
    """Takes the place of openseespy.opensees: keeps what it is asked for."""

    def __init__(self) -> None:
        self.calls: list[tuple[Any, ...]] = []

    def nodeCoord(self, node: int) -> list[float]:
        self.calls.append(("nodeCoord", node))
        return [1.0, 2.0, 3.0]

    def __getattr__(self, name: str) -> Callable[..., None]:
        return lambda *arguments: self.calls.append((name, *arguments))


def calibration(text: str = "plain", identity: str = "0" * 16, **law: Any) -> dict[str, Any]:
    """A calibration.json; `text` stands wherever text may stand."""
    parameters = {"k_i": {"value": 1085500, "unit": text, "interval_95": [1.06e6, 1.1e6], "identifiable": True}, text: {"value": 1, "unit": text}}
    return {"answer": {"bearing": text, "rim_identity": identity, "rung": text, "mesh": [2, 1], "mass_kg": 86952.0, "vertical_kN": 853.0, "gravity_m_per_s2": 9.81, "source": text,
                       "law": {"name": "elastoplastic", "chosen_by": text, "remark": text, "belongs_to": "rim", "parameters": parameters, "element": ELEMENT, "fitted_from_m_s": 0.1,
                               "fitted_to_m_s": 0.7, "valid_from_m_s": 0.1, "valid_to_m_s": 0.7, "tolerance": 0.05,
                               "worst_left_out": {"peak_force": 0.02, "rebound": 0.04, "inside_valid_range": True}, "sentence": text, **law},
                       "pair": None, "no_pair": text, "strain": {"sentence": text}, "mesh_error": {"sentence": text}, "assumptions": [{"key": text, "value": text}],
                       "error_sentences": ["Peak force: within about 28 % of the bearing's.", text], "doubts": [text, text], "validity": text}}


def write(folder: str, content: Any) -> None:
    with open(os.path.join(folder, "calibration.json"), "w") as file:
        json.dump(content, file)


def identity(bearing: str = "shfps-225") -> str:
    """Of a built-in bearing, as `check` has it."""
    run = rimpact("check", "ricker-0.78g-1.0s", "--set", f"bearing.name={bearing}", "--json")
    return str(json.loads(run.stdout)["rim_identity"])


class Exported(unittest.TestCase):
    rim: str

    @classmethod
    def setUpClass(cls) -> None:
        cls.rim = identity()

    def exported(self, folder: str, *arguments: str, text: str = "plain", **law: Any) -> Done:
        write(folder, calibration(text, self.rim, **law))
        run = rimpact("export", folder, "--scene", "shfps-225", *arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run

    def python(self, folder: str) -> dict[str, Any]:
        path = os.path.join(folder, "impact.py")
        py_compile.compile(path, doraise=True, cfile=os.path.join(folder, "compiled"))
        values: dict[str, Any] = {}
        with open(path) as file:
            exec(compile(file.read(), path, "exec"), values)
        return values

    def tcl(self, folder: str, script: str) -> list[str]:
        """Lines that the stubs of OpenSees' commands print."""
        if not shutil.which("tclsh"):
            self.skipTest("tclsh is not here: the Tcl file was not run")
        stubs = "".join(f"proc {name} {{args}} {{puts \"{name} $args\"}}\n" for name in ("uniaxialMaterial", "element", "frictionModel", "node", "equalDOF", "fix", "geomTransf"))
        text = stubs + "proc nodeCoord {n} {return {1.0 2.0 3.0}}\n" + f"source {folder}/impact.tcl\n{script}\n"
        run = subprocess.run(["tclsh"], input=text, capture_output=True, text=True, cwd=folder)
        self.assertEqual(run.stderr, "")
        return run.stdout.splitlines()

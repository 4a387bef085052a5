"""No key of --set is swallowed: every verb that takes it reads the key (what it resolves to changes) or names it in a sentence,
as an error with the exit code of an unknown key or, where another choice of the scene would read it, as a warning.
RIMPACT_EVERY_KEY=n asks each verb for every n-th key, another n-th of each verb; without it, for all of them."""
import json
import os
import re
import tempfile
import unittest
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from command import rimpact

Key = dict[str, Any]
# Where half as much again, or a word, is no value of the key's.
VALUES = {
    "bearing.assumed": '["slider.diameter_mm"]', "bearing.file": '"nosuch.toml"', "bearing.name": '"fps-225"', "bearing.surface.file": '"nosuch.csv"',
    "bearing.surface.radius_mm": "[0, 100, 600]", "bearing.surface.height_mm": "[0, 5, 90]",
    "bearing.material.steel.curve": "[[0, 355], [0.1, 500]]", "bearing.material.steel.hardness_HB": "150",
    "excitation.with": '["weight"]', "excitation.displacement_m": "[0.1, 0.0]", "excitation.velocity_m_per_s": "[0.1, 0.0]",
    "excitation.amplitudes_m": "[0.1, 0.2]", "excitation.centre_s": "3", "excitation.duration_s": "3", "excitation.kind": '"cyclic"', "model.rung": '"full"',
    "reduced.model": '"lir-dcfp"', "superstructure.kind": '"bouc-wen"', "isolator.points": "16", "isolator.step_tolerance": "1e-3",
    "superstructure.masses_kg": "[1e4, 1e4, 1e4]", "superstructure.stiffnesses_kN_per_m": "[1e4, 1e4, 1e4]",
    "load.mass_kg": "90000", "load.vertical_kN": "900", "reduced.mu_slow": "0.03", "reduced.mu_fast": "0.08", "reduced.dent_spread": "0.5",
}
VALUES["bearing.material.steel.chaboche"] = "[[1000, 10]]"
for part in ("rim", "dish", "slider"):
    VALUES |= {f"bearing.material.{part}.{key}": VALUES[f"bearing.material.steel.{key}"] for key in ("chaboche", "curve", "hardness_HB")}


def value_of(key: Key) -> str:
    """Another value than the default, as TOML writes it."""
    if key["key"] in VALUES:
        return VALUES[key["key"]]
    if key["kind"] in ("number", "limit"):
        try:
            preset = float(key["default"])
        except ValueError:
            return "1.0"
        return "0.5" if preset in (0, float("inf")) else repr(1.02 * preset)
    if key["kind"] == "integer":
        return str(int(key["default"]) + 1)
    if key["kind"] == "flag":
        return "false" if key["default"] == "true" else "true"
    if key["kind"] == "choice":
        return json.dumps(next(word for word in key["range"].split(", ") if json.dumps(word) != key["default"]))
    return '"nosuch"'


class Verb:
    """How a verb is asked cheaply, and where what it resolved stands."""

    def __init__(self, name: str, words: list[str], resolved: Callable[[str, str], str], **values: str) -> None:
        self.name, self.words, self.resolved = name, words, resolved
        self.values = {key.replace("__", "."): value for key, value in values.items()}

    def ask(self, folder: str, *settings: str) -> tuple[int, str, str]:
        words = [word.format(folder) for word in self.words]
        environment = {"RIMPACT_FE_PROGRAM": "/bin/false"} if self.words[0] in ("study", "geometry") else {}  # the jobs' scenes are what is asked for
        run = rimpact(*words, *(word for setting in settings for word in ("--set", setting)), cwd=folder, **environment)
        return run.returncode, run.stderr, self.resolved(run.stdout, folder)


def identity(stdout: str, _folder: str) -> str:
    """Of the resolved scene, as a hash; of every run of a plan."""
    table = json.loads(stdout) if stdout.startswith("{") else {}
    return str([run["identity"]["scene"] for run in table["runs"]] if "runs" in table else table.get("identity"))


def scene_of_run(_stdout: str, folder: str) -> str:
    return text_of(os.path.join(folder, "out", "scene.toml"))


def scenes_of_jobs(_stdout: str, folder: str) -> str:
    logs = os.path.join(folder, "out", "logs")
    return "".join(text_of(os.path.join(logs, name)) for name in sorted(os.listdir(logs)) if name.endswith(".toml")) if os.path.isdir(logs) else ""


def mesh_file(_stdout: str, folder: str) -> str:
    return text_of(os.path.join(folder, "out.msh"))


def text_of(path: str) -> str:
    if not os.path.exists(path):
        return ""
    with open(path, encoding="utf-8") as file:
        return file.read()


RICKER = "ricker-0.78g-1.0s"
STRIDE = int(os.environ.get("RIMPACT_EVERY_KEY", "1"))
VERBS = [
    Verb("check", ["check", RICKER, "--json"], identity),
    Verb("run", ["run", RICKER, "--dry-run", "--json"], identity),
    Verb("reduced", ["reduced", RICKER, "-o", "out"], scene_of_run),
    Verb("building", ["building", RICKER, "-o", "out"], scene_of_run, reduced__friction='"coulomb"'),  # park-wen without the key
    Verb("main", ["main", "--dry-run", "--json", "--windows-only", "--speeds", "0.2"], identity),
    Verb("geometry", ["geometry", "--samples", "3", "-o", "out"], scenes_of_jobs),
    Verb("study", ["study", RICKER, "--rungs", "rim", "-o", "out"], scenes_of_jobs),
    Verb("mesh BEARING", ["mesh", "shfps-225", "--mesh", "0", "-o", "out.msh"], mesh_file),
    Verb("mesh --scene", ["mesh", "--scene", RICKER, "--mesh", "0", "-o", "out.msh", "--json"], identity),
]
# What a mesh of a bearing alone is not made of, though it is a bearing's: read with it, and judged.
NO_DIMENSION = ("bearing.name", "bearing.assumed", "bearing.plate.", "bearing.pad.", "bearing.foot.", "bearing.material.", "bearing.contact.",
                "bearing.rim.connection.")


def keys() -> list[Key]:
    return list(json.loads(rimpact("list", "keys", "--json").stdout)["keys"])


class SetKeys(unittest.TestCase):
    def outcome(self, verb: Verb, setting: str, untouched: str) -> str:
        """"read", "refused", "warned", or what is wrong."""
        name = setting.split("=")[0]
        with tempfile.TemporaryDirectory() as folder:
            code, said, resolved = verb.ask(folder, setting)
        words = rf"\b{re.escape(name.split('.')[-1])}\b|\[{name.split('.')[0]}\]"  # the key, or the table that is refused
        named = [line for line in said.splitlines() if re.search(words, line)]
        if code in (2, 3):  # without the key the verb runs: so it was read, be it that the sentence names another key it does not go with
            return "refused" if any(line.startswith("error:") for line in named) else "read"
        if any(line.startswith("warning:") and "not read" in line for line in named):
            return "warned"
        if resolved and resolved != untouched:
            return "read"
        return f"swallowed (exit code {code}): {said}"

    def judge(self, verb: Verb, asked: list[Key]) -> dict[str, str]:
        with tempfile.TemporaryDirectory() as folder:
            untouched = verb.ask(folder)[2]
        self.assertTrue(untouched, verb.name)
        with ThreadPoolExecutor(2) as pool:
            outcomes = pool.map(lambda key: self.outcome(verb, f"{key['key']}={verb.values.get(key['key']) or value_of(key)}", untouched), asked)
        return dict(zip([key["key"] for key in asked], outcomes))

    def test_every_verb_reads_a_key_or_names_it(self) -> None:
        every = keys()
        self.assertGreater(len(every), 150)
        for place, verb in enumerate(VERBS):
            asked = every[place % STRIDE::STRIDE]
            if verb.name == "mesh BEARING":
                asked = [key for key in asked if not key["key"].startswith(NO_DIMENSION)]
            if verb.words[0] in ("mesh", "run"):  # these start the finite-element program
                asked = asked[::4 if STRIDE == 1 else 2]
            if "--mesh" in verb.words:  # the option stands over the key
                asked = [key for key in asked if key["key"] != "model.mesh"]
            if verb.resolved is identity:  # a mark, no number: it stands in scene.toml
                asked = [key for key in asked if key["key"] != "bearing.assumed"]
            outcomes = self.judge(verb, asked)
            for key, outcome in outcomes.items():
                with self.subTest(verb=verb.name, key=key):
                    self.assertIn(outcome, ("read", "refused", "warned"))
            with self.subTest(verb=verb.name):
                self.assertIn("read", outcomes.values())

    def test_the_list_of_verbs_is_whole(self) -> None:
        names = re.findall(r"^  ([a-z-]+) ", rimpact("--help").stdout.split("Subcommands:")[1], re.MULTILINE)
        taking = {name for name in names if "--set " in rimpact(name, "--help").stdout}
        self.assertEqual(taking, {verb.words[0] for verb in VERBS})

    def test_an_unknown_key_is_refused_by_every_verb(self) -> None:
        for verb in VERBS:
            for setting in ("bearing.rim.heigth_mm=70", "load.mas_kg=1", "nosuch=1"):
                with self.subTest(verb=verb.name, setting=setting), tempfile.TemporaryDirectory() as folder:
                    code, said, _ = verb.ask(folder, setting)
                    self.assertEqual(code, 2, said)
                    self.assertIn("unknown key", said)


if __name__ == "__main__":
    unittest.main()

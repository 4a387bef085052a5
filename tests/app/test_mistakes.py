"""What a new user gets wrong, each answered by a sentence that holds the cure, with the exit code of docs/interface.md."""
import json
import os
import signal
import subprocess
import tempfile
import time
import unittest
from dataclasses import dataclass

from command import RIMPACT, rimpact

MINE = """name = "acme-r3"
[surface]
kind = "sphere"
R0_m = 3.0
planar_radius_mm = 600.0
[slider]
diameter_mm = 300.0
bottom_mm = 58.0
top_mm = 158.0
[rim]
height_mm = 70.0
thickness_mm = 50.0
[material.steel]
yield_MPa = 355.0
[contact]
rim = 0.0
"""
SCENE = """[bearing]
file = "bearing.toml"
[load]
vertical_kN = 2000.0
[excitation]
kind = "window"
speed_m_per_s = 0.2
"""
HEAD = "PEER NGA STRONG MOTION DATABASE RECORD\nA RECORD\n"
ACCELERATION = "ACCELERATION TIME SERIES IN UNITS OF G\n"
FILES = {
    "bearing.toml": MINE,
    "scene.toml": SCENE,
    "pulse.toml": SCENE.replace('"window"\nspeed_m_per_s = 0.2', '"ricker"'),
    "empty.toml": "",
    "load-only.toml": "[load]\nvertical_kN = 853.0\n",
    "comma.toml": SCENE.replace("2000.0", "2000,5"),
    "string.toml": 'bearing = "bearing.toml"\n[excitation]\nkind = "window"\n',
    "truncated.AT2": HEAD + ACCELERATION + "NPTS=  2000, DT=   .0100 SEC\n .1E-01 .2E-01 .1E-01\n",
    "garbage.AT2": HEAD + ACCELERATION + "four score and seven\n .1E-01\n",
    "velocity.AT2": HEAD + "VELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS=  3, DT=   .0100 SEC\n .1E-01 .2E-01 .1E-01\n",
    "header.csv": "t,a\n0,0\n1,1\n",
    "runs/window-0.05.log": "a log\n",
}
RICKER = "ricker-0.78g-1.0s"
# Made once, by the reduced model: name -> arguments.
RUNS = {
    "runs/window": ["impact-window"],
    "runs/heavier": ["impact-window", "--set", "load.mass_kg=203900"],
    "runs/wider": ["impact-window", "--set", "bearing.rim.thickness_mm=50"],
    "runs/pulse": [RICKER, "--set", "excitation.scale=1.05"],
    "runs/grazing": [RICKER],
    "runs/short": [RICKER, "--set", "excitation.scale=0.5"],
}


@dataclass
class Row:
    mistake: str
    words: str  # after `rimpact`, {0} standing for the folder of the files above
    code: int
    says: tuple  # on stderr, or on stdout where the exit code is 0
    needs_fe: bool = False


def row(mistake, words, code, *says, needs_fe=False):
    return Row(mistake, words, code, says, needs_fe)


def with_set(assignment, scene=RICKER):
    return f"check {scene} --set {assignment}"


ROWS = [
    row("a key misspelt", with_set("excitation.scal=1.05"), 2, "unknown key \"scal\" in [excitation]", "did you mean \"scale\"?"),
    row("a key cut short", with_set("reduced.mu=0.05"), 2, "unknown key \"mu\" in [reduced]", "mu_fast", "mu_slow"),
    row("a unit left out", with_set("bearing.rim.height=70"), 2, "did you mean \"height_mm\"?"),
    row("metres for millimetres", with_set("bearing.rim.height_mm=0.07"), 2, "leaves the rim's top at z =", "below the slider's bottom"),
    row("a negative thickness", with_set("bearing.rim.thickness_mm=-50"), 2, "must be > 0"),
    row("a slider wider than its dish", with_set("bearing.slider.diameter_mm=1300", "{0}/scene.toml"), 2, "leaves no travel in a rim of radius 600 mm", "L_c = -50 mm"),
    row("a stress in Pa", with_set("bearing.material.steel.yield_MPa=355e6"), 0, "yield_MPa = 3.55e+08, where 100 to 2000 MPa is usual", "is its unit MPa?"),
    row("a stress in GPa", with_set("bearing.material.steel.yield_MPa=0.355"), 0, "yield_MPa = 0.355, where 100 to 2000 MPa is usual"),
    row("a modulus in ksi", with_set("bearing.material.steel.E_MPa=29000"), 0, "steel.E_MPa = 29000, where 50000 to 400000 MPa is usual"),
    row("a gravity in ft/s2", with_set("load.gravity_m_per_s2=32.2"), 0, "where it is 9.7 to 9.9 on Earth", "is its unit m/s2?"),
    row("a load in N", with_set("load.vertical_kN=2000000"), 0, "times load.mass_kg", "are the units right?"),
    row("an acceleration in m/s2", "check {0}/pulse.toml --set excitation.amplitude_g=7.65", 0, "reaches 7.65 g, beyond any recorded", "no bearing meets its rim faster than 10 m/s",
        "not in m/s2"),
    row("a weight changed, its mass forgotten", with_set("load.vertical_kN=2000"), 0, "2000 is 2.3 times load.mass_kg = 86952", "was one of the two forgotten?"),
    row("a bearing and a load where a scene is wanted", "check {0}/bearing.toml --set load.vertical_kN=1200", 2, "a bearing file", "a scene is wanted", "rimpact main"),
    row("a bearing where a scene is wanted", "check {0}/bearing.toml", 2, "a bearing file", "a scene is wanted", "file = \"{0}/bearing.toml\"", "rimpact main"),
    row("main with a scene", "main {0}/scene.toml -o {0}/main --set excitation.scal=1.05", 2, "did you mean \"scale\"?"),
    row("a scene where a bearing is wanted", "mesh {0}/scene.toml -o {0}/x.msh", 2, "this is a scene", "a bearing is wanted", "bearing.toml", needs_fe=True),
    row("two things to mesh", "mesh shfps-225 --scene impact-window -o {0}/x.msh", 2, "shfps-225 beside --scene", needs_fe=True),
    row("a rim in metres", with_set("bearing.rim.thickness_mm=0.035"), 0, "rim.thickness_mm = 0.035 is 0.00058 times bearing.rim.height_mm = 60", "is its unit mm?"),
    row("a rim in inches", with_set("bearing.rim.thickness_mm=1.378"), 0, "rim.thickness_mm = 1.378", "is its unit mm?"),
    row("a load in MN", "check {0}/scene.toml --set load.vertical_kN=3.2", 0, "load.vertical_kN = 3.2 presses a slider of 300 mm with 0.045 MPa", "is its unit kN?"),
    row("an axis of a study by --set", f"study {RICKER} -o {{0}}/study --set model.mesh=3", 2, "rimpact study does not read model.mesh", "--meshes"),
    row("values of an axis that does not vary", f"study {RICKER} -o {{0}}/study --steps 1,0.5", 2, "--steps: step is not among --axes rung,mesh"),
    row("a building's load by --set", f"building {RICKER} -o {{0}}/b --set load.mass_kg=1e5", 2, "does not read load.mass_kg", "--frame"),
    row("a building's load by --sweep", f"building {RICKER} -o {{0}}/b --sweep load.mass_kg=1e5:2e5:2", 2, "load.mass_kg is not read", "--frame"),
    row("a speed of geometry by --set", "geometry -o {0}/g --set excitation.speed_m_per_s=0.5", 2, "does not read excitation.speed_m_per_s", "--range speed=LOW:HIGH"),
    row("two dishes without [isolator]", "reduced {0}/pulse.toml -o {0}/dcfp --model dcfp", 0, "no [isolator] is given", "an assumption; nothing of bearing acme-r3 is read",
        "not this isolator's", "(the thesis's pair for shfps-225)"),
    row("calibrate with a scene", "calibrate {0}/scene.toml", 2, "this is a scene, where a run is wanted", "rimpact run {0}/scene.toml -o DIR"),
    row("an empty scene", "check {0}/empty.toml", 0, "has no excitation.kind", "Ricker pulse of 0.78 g", "bearing: shfps-225", "motion: ricker"),
    row("a scene without a motion", "check {0}/load-only.toml", 0, "has no excitation.kind", "Ricker pulse of 0.78 g"),
    row("a file that is not there", "check {0}/nosuch.toml", 2, "no such file"),
    row("half a built-in scene's name", "check ricker", 2, "no such file", "did you mean \"ricker-"),
    row("a rung misspelt", f"check {RICKER} --rung riim", 2, "did you mean \"rim\"?", "rim, rigid-dish, full"),
    row("the reduced model as a rung", f"check {RICKER} --rung reduced", 2, "use rimpact reduced SCENE"),
    row("a mesh that is none", f"check {RICKER} --mesh 9", 2, "9 not in range"),
    row("a verb misspelt", "chek x", 2, "did you mean \"check\"?"),
    row("no scene", "reduced", 2, "SCENE is required"),
    row("a decimal comma", "check {0}/comma.toml", 2, "comma.toml:4:", "decimals follow a point: 2000.5"),
    row("a decimal comma, typed", with_set("load.vertical_kN=2000,5"), 2, "decimals follow a point: 2000.5"),
    row("a bearing as a string", "check {0}/string.toml", 2, "string.toml:1:", "the line [bearing]", "file = \"bearing.toml\""),
    row("a record cut short", "motion {0}/truncated.AT2", 3, "truncated", "3 values", "2000"),
    row("a record without its header", "motion {0}/garbage.AT2", 3, "no line with NPTS and DT"),
    row("a record of velocities", "motion {0}/velocity.AT2", 3, "velocity"),
    row("a motion with other columns", "motion {0}/header.csv", 3, "header must be \"time_s,acceleration_g\""),
    row("a record without a file", with_set("excitation.kind=record"), 2, "excitation.x needs a file"),
    row("--resume where nothing is", "run rim-push --mesh 0 -o {0}/nothing --resume", 3, "nothing to resume", needs_fe=True),
    row("a reduced run into a finite-element folder", "reduced rim-push -o {0}/fe", 2, "--force"),
    row("a run into a finished folder", "run rim-push --mesh 0 -o {0}/fe", 2, "--force", needs_fe=True),
    row("logs among the runs", "calibrate {0}/runs/window {0}/runs/window-0.05.log", 3, "window-0.05.log: not a run folder", "give the folders alone"),
    row("one grazing run", "calibrate {0}/runs/grazing -o {0}/cal-grazing", 0, "NOT IDENTIFIABLE", "only grazes the rim"),
    row("a run that never touches", "calibrate {0}/runs/short -o {0}/cal-short", 3, "the rim is never touched", "travel", "L_c"),
    row("two masses", "calibrate {0}/runs/window {0}/runs/heavier -o {0}/cal-two", 2, "cannot be calibrated together", "203900", "86952"),
    row("two bearings", "calibrate {0}/runs/window {0}/runs/wider -o {0}/cal-two", 2, "cannot be calibrated together", "dimensions"),
    row("compare of different scenes", "compare {0}/runs/window {0}/runs/pulse", 2, "--anyway"),
    row("a report of nothing", "report {0}/nope", 3, "does not exist"),
    row("a report of another folder", "report {0}/foreign", 3, "holds no run folder"),
    row("a folder that cannot be", "reduced impact-window -o /proc/foo", 6, "/proc/foo"),
    row("half a sweep", f"reduced {RICKER} --sweep excitation.scale=1:2", 2, "KEY=a:b:n"),
]


def fe_program():
    return os.environ.get("RIMPACT_FE_PROGRAM") or os.path.join(os.path.dirname(RIMPACT), "rimpact-fe")


class Mistakes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory()
        cls.folder = cls.keeper.name
        os.makedirs(os.path.join(cls.folder, "runs"))
        os.makedirs(os.path.join(cls.folder, "foreign"))
        for name, text in FILES.items():
            with open(os.path.join(cls.folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        for name, arguments in RUNS.items():
            made = rimpact("reduced", *arguments, "-o", os.path.join(cls.folder, name))
            assert made.returncode == 0, made.stderr
        cls.make_finite_element_folder(os.path.join(cls.folder, "fe"))

    @staticmethod
    def make_finite_element_folder(folder):
        """What a run of rung rim leaves, as far as another command can tell."""
        rimpact("reduced", "impact-window", "-o", folder)
        path = os.path.join(folder, "summary.json")
        with open(path, encoding="utf-8") as file:
            summary = json.load(file)
        summary.update(rung="rim", mesh=1)
        with open(path, "w", encoding="utf-8") as file:
            json.dump(summary, file)
        os.makedirs(os.path.join(folder, "fields"))
        open(os.path.join(folder, "fields", "impact-1.vtu"), "w", encoding="utf-8").close()

    @classmethod
    def tearDownClass(cls):
        cls.keeper.cleanup()

    def answer_of(self, mistake):
        """What is wrong with the row's answer; empty where nothing is."""
        if mistake.needs_fe and not os.path.exists(fe_program()):
            self.skipTest("the finite-element program is not here (RIMPACT_FE_PROGRAM)")
        run = rimpact(*mistake.words.format(self.folder).split())
        found = []
        if run.returncode != mistake.code:
            found.append(f"exit code {run.returncode}, not {mistake.code}")
        said = run.stderr + (run.stdout if mistake.code == 0 else "")
        found += [f"\"{words.format(self.folder)}\" is not said" for words in mistake.says if words.format(self.folder) not in said]
        return "; ".join(found) and "; ".join(found) + f"\n{said}"

    def test_every_mistake_is_answered_with_its_cure(self):
        for mistake in ROWS:
            with self.subTest(mistake.mistake):
                self.assertEqual(self.answer_of(mistake), "")

    def test_the_table_is_whole(self):
        names = [mistake.mistake for mistake in ROWS]
        self.assertEqual(len(names), len(set(names)))
        self.assertGreaterEqual(len(names), 40)

    def test_interrupted_goes_on(self):
        words = [RIMPACT, "reduced", RICKER, "--sweep", "excitation.scale=0.5:1.4:3000", "-o", os.path.join(self.folder, "sweep"), "--threads", "1"]
        with subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as run:
            while not os.path.exists(os.path.join(self.folder, "sweep", "fleet.json")):
                time.sleep(0.02)
            time.sleep(0.3)
            run.send_signal(signal.SIGINT)
            said = run.communicate(timeout=60)[1]
        self.assertEqual(run.returncode, 130, said)
        self.assertIn("goes on from there", said)


if __name__ == "__main__":
    unittest.main()

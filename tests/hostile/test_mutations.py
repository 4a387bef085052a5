"""Files that a program wrote, damaged at random and read again by the verbs that take them: the answer is a result or a sentence with
its exit code, never a crash, "a bug", a traceback or a hang (RIMPACT in the environment; RIMPACT_MUTATIONS: so many a file, RIMPACT_SEED)."""
import json
import os
import random
import shutil
import subprocess
import tempfile
import unittest

COUNT, SEED = int(os.environ.get("RIMPACT_MUTATIONS", "40")), int(os.environ.get("RIMPACT_SEED", "1"))
SECONDS = 60
ANSWERS = {0, 2, 3, 4, 5, 6}
ODD = [None, True, -1, 0, 1e308, "", "X", "<b>", [], {}, [None], {"a": 1}]


def command(words, folder, seconds=SECONDS):
    environment = dict(os.environ, RIMPACT_THREADS="1", NO_COLOR="1")
    return subprocess.run([os.environ["RIMPACT"], *words], cwd=folder, capture_output=True, timeout=seconds, env=environment, check=False)


def damage_bytes(content, dice):
    """Cuts, flips, doubles or blanks a stretch."""
    content = bytearray(content)
    for _ in range(dice.choice([1, 1, 1, 2, 5])):
        at, size = dice.randrange(len(content) or 1), dice.choice([1, 1, 4, 16, 200])
        kind = dice.choice("flip cut double blank end".split())
        if kind == "flip" and content:
            content[at] ^= 1 << dice.randrange(8)
        elif kind == "cut":
            del content[at : at + size]
        elif kind == "double":
            content[at:at] = content[at : at + size]
        elif kind == "blank":
            content[at : at + size] = bytes(len(content[at : at + size]))
        else:
            del content[at:]
    return bytes(content)


def places(value, path=()):
    """Paths of all values in a JSON document."""
    found = [path] if path else []
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        found += places(inner, path + (key,))
    return found


def damage_json(content, dice):
    """Another value, of another type, in one place; or a key taken away."""
    document = json.loads(content)
    *way, last = dice.choice(places(document))
    holder = document
    for key in way:
        holder = holder[key]
    if dice.random() < 0.25:
        del holder[last]
    else:
        holder[last] = dice.choice(ODD)
    return json.dumps(document).encode()


class Mutated(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.home = cls.kept.name
        case = '[excitation]\nkind = "window"\nspeed_m_per_s = {}\n'
        for name, speed in (("slow", 0.2), ("fast", 0.4)):
            with open(f"{cls.home}/{name}.toml", "w", encoding="utf-8") as file:
                file.write(case.format(speed))
            assert command(["reduced", f"{name}.toml", "-o", name], cls.home).returncode == 0
        assert command(["calibrate", "slow", "fast", "--laws", "none", "-o", "fit"], cls.home).returncode in (0, 5)
        assert command(["reduced", "slow.toml", "--sweep", "excitation.speed_m_per_s=0.1:0.3:3", "-o", "fleet"], cls.home).returncode == 0
        assert command(["mesh", "shfps-225", "-o", "own.msh"], cls.home).returncode == 0
        assert command(["run", "slow.toml", "--mesh", "0", "-o", "fe"], cls.home, seconds=900).returncode == 0
        for name in ("summary.json", "response.h5", "response.csv"):
            os.remove(f"{cls.home}/fe/{name}")  # killed at the end: its checkpoint is all there is
        with open(f"{cls.home}/q.csv", "w", encoding="utf-8") as file:
            file.write("time_s,acceleration_g\n" + "".join(f"{0.01 * i:.2f},{0.1 * (i % 7 - 3):.3f}\n" for i in range(200)))

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    def attack(self, damaged, verbs, damage=damage_bytes, count=COUNT):
        """Each damaged copy is given to every verb in a fresh copy of the folder."""
        answers = {}
        for index in range(count):
            dice = random.Random(f"{SEED} {damaged} {damage.__name__} {index}")
            with tempfile.TemporaryDirectory() as folder:
                shutil.copytree(self.home, folder, dirs_exist_ok=True)
                with open(os.path.join(folder, damaged), "rb") as file:
                    content = damage(file.read(), dice)
                with open(os.path.join(folder, damaged), "wb") as file:
                    file.write(content)
                for words in verbs:
                    with self.subTest(f"{damaged}, {damage.__name__} {index}, {' '.join(words)}"):
                        try:
                            run = command(words, folder)
                        except subprocess.TimeoutExpired:
                            self.fail(f"still running after {SECONDS} s")
                        said = (run.stdout + run.stderr).decode(errors="replace")
                        answers[run.returncode] = answers.get(run.returncode, 0) + 1
                        self.assertIn(run.returncode, ANSWERS, said[-500:])
                        self.assertNotIn("Traceback", said)
                        if run.returncode:
                            self.assertIn("error: ", said)
        print(f"{damaged} {damage.__name__}: {sum(answers.values())} answers, by exit code {dict(sorted(answers.items()))}")

    def test_scene(self):
        self.attack("slow/scene.toml", [["check", "slow/scene.toml"], ["reduced", "slow", "-o", "again"]])

    def test_summary(self):
        verbs = [["compare", "slow", "fast"], ["calibrate", "slow", "fast", "--laws", "none", "-o", "c"], ["report", "slow"]]
        self.attack("slow/summary.json", verbs, damage_json)
        self.attack("slow/summary.json", verbs[:1])

    def test_response(self):
        self.attack("slow/response.h5", [["compare", "slow", "fast"], ["calibrate", "slow", "fast", "--laws", "none", "-o", "c"]])
        self.attack("slow/response.csv", [["compare", "slow/response.csv", "fast"]])

    def test_calibration(self):
        verbs = [["export", "fit", "--opensees"], ["export", "fit", "--sap2000"], ["reduced", "slow.toml", "--set", 'reduced.calibration="fit"', "-o", "r"], ["report", "fit"]]
        self.attack("fit/calibration.json", verbs, damage_json)
        self.attack("fit/calibration.json", verbs[:1])

    def test_fleet(self):
        go_on = [["reduced", "slow.toml", "--sweep", "excitation.speed_m_per_s=0.1:0.3:3", "-o", "fleet"]]
        self.attack("fleet/fleet.json", go_on, damage_json)
        self.attack("fleet/table.csv", go_on)

    def test_mesh(self):
        self.attack("own.msh", [["check", "slow.toml", "--set", 'model.own_mesh.file="own.msh"']])

    def test_checkpoint(self):
        self.attack("fe/checkpoint.h5", [["run", "slow.toml", "--mesh", "0", "-o", "fe", "--resume"]])

    def test_record(self):
        self.attack("q.csv", [["motion", "q.csv"]])


if __name__ == "__main__":
    unittest.main()

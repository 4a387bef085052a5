"""What the command says of itself is whole: keys, verbs, lists, completion, next steps."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

PROGRAM, SOURCE = os.environ["RIMPACT"], os.environ["RIMPACT_SOURCE"]
FE_VERBS = {"run", "mesh", "curve", "version"}
HAS_FE = os.access(os.path.join(os.path.dirname(PROGRAM), "rimpact-fe"), os.X_OK)


def rimpact(*words, cwd=None):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, cwd=cwd, check=False)


def verbs():
    return re.findall(r"^  ([a-z-]+) ", rimpact("--help").stdout.split("Subcommands:")[1], re.MULTILINE)


def asked():
    return [verb for verb in verbs() if HAS_FE or verb not in FE_VERBS]


class Words(unittest.TestCase):
    def test_every_key_has_meaning_range_and_default(self):
        listed = json.loads(rimpact("list", "keys", "--json").stdout)
        self.assertGreater(len(listed["keys"]), 130)
        groups = [file["keys"] for file in listed["files"]]
        self.assertEqual(groups, ["sweep_keys", "study_keys", "building_keys", "frame_keys", "mapping_keys"])
        for key in (key for group in ["keys", *groups] for key in listed[group]):
            self.assertTrue(key["meaning"] and key["range"], key)
        for key in listed["keys"]:
            if key["kind"] in ("number", "integer"):
                self.assertTrue(key["default"], key)

    def test_every_key_of_the_sources_is_listed(self):
        text = ""
        for name in ("scene/bearing_keys", "scene/scene_keys", "scene/isolator_keys", "scene/measured_friction", "scene/bounds", "scene/superstructure",
                     "laws/impact/kelvin_voigt", "laws/impact/hunt_crossley", "laws/impact/elastoplastic", "laws/impact/pushed_curve"):
            with open(os.path.join(SOURCE, name + ".cc"), encoding="utf-8") as file:
                text += file.read()
        names = set(re.findall(r'v\.\w+\(\s*\{(?:\.name = )?"(\w+)"', text))
        listed = {key["key"].split(".")[-1] for key in json.loads(rimpact("list", "keys", "--json").stdout)["keys"]}
        self.assertGreater(len(names), 90)
        self.assertEqual(names - listed, set())

    def test_every_listed_key_is_taken_by_a_scene(self):
        for key in json.loads(rimpact("list", "keys", "--json").stdout)["keys"]:
            if key["kind"] == "flag":
                done = rimpact("reduced", "impact-window", "--set", f"{key['key']}=7", "-o", "/proc/none")
                self.assertIn("true or false", done.stderr, key["key"])
            elif key["kind"] in ("number", "limit", "integer"):
                done = rimpact("reduced", "impact-window", "--set", f'{key["key"]}="word"', "-o", "/proc/none")
                self.assertEqual(done.returncode, 2, key["key"])
                self.assertNotIn("unknown key", done.stderr, key["key"])

    def test_a_unit_is_that_of_the_name(self):
        listed = json.loads(rimpact("list", "keys", "--json").stdout)
        names = [(key["key"], key["unit"]) for group in ["keys", *(file["keys"] for file in listed["files"])] for key in listed[group]]
        self.assertGreater(sum("_per_" in name for name, _ in names), 30)
        for name, unit in names:
            if part := re.search(r"([A-Za-z0-9]+)_per_(\w+)$", name):
                above = part[1] if part[1] in ("kN", "kg", "mm2", "m", "s", "J", "W") else "1"
                below = part[2] if "_" not in part[2] else f"({part[2].replace('_', ' ')})"
                self.assertEqual(unit, f"{above}/{below}", name)
            elif part := re.search(r"_(mm|m|s|MPa|GPa|kN|kg|deg|ms|K|HB)$|temperature_(C)$", name):
                self.assertEqual(unit.split()[-1], part[1] or part[2], name)

    def test_conditions_name_the_choice(self):
        keys = {key["key"]: key for key in json.loads(rimpact("list", "keys", "--json").stdout)["keys"]}
        self.assertEqual(keys["excitation.travel_mm"]["when"], "excitation.kind = push")
        self.assertEqual(keys["bearing.surface.a_m"]["when"], "bearing.surface.kind = ellipse")
        self.assertEqual(keys["reduced.yield_force_kN"]["when"], "reduced.impact_law = elastoplastic | bilinear")
        self.assertEqual(keys["reduced.unloading_gain"]["when"], "reduced.impact_law = elastoplastic")
        self.assertEqual(keys["load.mass_kg"]["when"], "")
        self.assertEqual(keys["reduced.k_i_kN_per_m"]["unit"], "kN/m")

    def test_every_part_of_a_sweep_file_is_listed(self):
        text = "".join(file.read_text(encoding="utf-8") for file in pathlib.Path(SOURCE, "studies", "fleets").glob("*_reader.cc"))
        known = [name for names in re.findall(r"only\(\*table, \{([^}]*)\}", text) for name in re.findall(r'"(\w+)"', names)]
        self.assertGreater(len(known), 8)
        self.assertEqual(set(known) - self.parts_of("sweep_keys"), set())

    def test_every_part_of_a_study_is_listed(self):
        files = [file.read_text(encoding="utf-8") for file in pathlib.Path(SOURCE, "studies", "risk").glob("*_reader.cc")]
        known = {name for text in files for name in re.findall(r'\w+\.(?:text|numbers?|integer|choice)\(\{"(\w+)"', text)}
        for text in files:
            known.update(name for names in re.findall(r"only\([^{]*\{([^}]*)\}", text) for name in re.findall(r'"(\w+)"', names))
        self.assertGreater(len(known), 20)
        self.assertEqual(known - self.parts_of("study_keys"), set())

    def parts_of(self, group):
        return {part for key in json.loads(rimpact("list", "keys", "--json").stdout)[group] for part in key["key"].split(".")}

    def test_every_key_of_a_study_is_taken(self):
        study = pathlib.Path(SOURCE, "data/reliability/thesis-2.6.toml").read_text(encoding="utf-8")
        for key in json.loads(rimpact("list", "keys", "--json").stdout)["study_keys"]:
            table, _, name = key["key"].rpartition(".")
            if table in ("intensity", "bootstrap") or key["key"] == "years":
                with tempfile.TemporaryDirectory() as folder:
                    file = pathlib.Path(folder, "study.toml")
                    plain = re.sub(rf"(?m)^{name} = .*$", "", study)
                    file.write_text((f'{name} = "word"\n{plain}' if not table else
                                     plain.replace(f"[{table}]", f'[{table}]\n{name} = "word"') if f"[{table}]" in plain else
                                     f'{plain}\n[{table}]\n{name} = "word"\n'), encoding="utf-8")
                    done = rimpact("reliability", str(file), "--dry-run", cwd=folder)
                    self.assertEqual(done.returncode, 2, (key["key"], done.stderr))
                    self.assertIn(f"{key['key']} ", done.stderr)

    def test_every_key_of_a_building_is_taken(self):
        needed = {"building_keys": {"x_m": "[0, 6]", "y_m": "[0, 6]"}, "frame_keys": {"x_m": "[0, 6]", "storeys_m": "[3]", "load_kN_per_m": "40"}}
        for group, lines in needed.items():
            for key in json.loads(rimpact("list", "keys", "--json").stdout)[group]:
                if key["kind"] not in ("number", "limit", "integer", "flag"):
                    continue
                with tempfile.TemporaryDirectory() as folder:
                    text = "".join(f"{name} = {value}\n" for name, value in lines.items() if name != key["key"])
                    pathlib.Path(folder, "own.toml").write_text(f'{text}{key["key"]} = "word"\n', encoding="utf-8")
                    done = rimpact("building", "ricker-0.78g-1.0s", "--frame", "own.toml", "-o", "/proc/none", cwd=folder)
                    self.assertEqual(done.returncode, 2, (key["key"], done.stderr))
                    self.assertIn(key["key"], done.stderr)
                    self.assertNotIn("unknown key", done.stderr)

    def test_every_key_of_a_mapping_is_taken(self):
        for key in json.loads(rimpact("list", "keys", "--json").stdout)["mapping_keys"]:
            if key["kind"] not in ("number", "integer"):
                continue
            with tempfile.TemporaryDirectory() as folder:
                name = key["key"].replace("SIGNAL", "time")
                text = f'scene = "impact-window"\nfile = "none.csv"\n{name} = "word"\ncolumns.time.column = "t"\ncolumns.time.unit = "s"\n'
                pathlib.Path(folder, "own.toml").write_text(text, encoding="utf-8")
                done = rimpact("calibrate", "own.toml", "-o", "out", cwd=folder)
                self.assertEqual(done.returncode, 2, (name, done.stderr))
                self.assertIn(name, done.stderr)
                self.assertNotIn("unknown key", done.stderr)

    def test_every_kind_can_be_listed(self):
        for kind in ("bearings", "scenes", "models", "laws", "materials", "rungs", "steels", "signals", "columns", "files", "exit-codes"):
            listed = json.loads(rimpact("list", kind, "--json").stdout)
            self.assertTrue(all(listed[kind].values()), kind)
            self.assertIn(next(iter(listed[kind])), rimpact("list", kind).stdout)
        self.assertNotIn("exit-codes", json.loads(rimpact("list", "--json").stdout))

    def test_every_help_has_examples_and_exit_codes(self):
        for verb in asked():
            text = rimpact(verb, "--help").stdout
            self.assertIn("Exit codes: 0 done", text, verb)
            self.assertRegex(text, rf"Examples:\n  rimpact {verb}", verb)

    def test_help_verb_is_the_verb_s_help(self):
        for verb in asked():
            if verb != "help":
                self.assertEqual(rimpact("help", verb).stdout, rimpact(verb, "--help").stdout, verb)
        self.assertEqual(rimpact("help").stdout, rimpact("--help").stdout)
        unknown = rimpact("help", "calibrat")
        self.assertEqual(unknown.returncode, 2)
        self.assertIn("calibrat", unknown.stderr)

    def test_the_examples_of_the_help_name_options_that_exist(self):
        for verb in asked():
            text = rimpact(verb, "--help").stdout
            options, examples = text.split("Examples:")
            for option in re.findall(r"(?<= )--[a-zA-Z0-9-]+", examples.split("Exit codes")[0]):
                self.assertIn(option, options, verb)

    def test_a_verb_ends_with_what_may_follow(self):
        with tempfile.TemporaryDirectory() as folder:
            done = rimpact("reduced", "impact-window", "-o", "here", cwd=folder)
            self.assertEqual(done.stderr.splitlines()[-1], "next: rimpact report here")
            self.assertNotIn("next:", rimpact("reduced", "impact-window", "-o", "here", "--quiet", cwd=folder).stderr)
            self.assertNotIn("next:", rimpact("reduced", "impact-window", "-o", "here", "--json", cwd=folder).stderr)
            usual = rimpact("reduced", "impact-window", cwd=folder)
            self.assertEqual(usual.stderr.splitlines()[-1], "next: rimpact report results/impact-window-reduced")
            self.assertEqual(rimpact("report", "here", cwd=folder).returncode, 0)

    def completion(self, shell):
        done = rimpact("completion", shell)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_completion_knows_every_verb_and_option(self):
        tree = json.loads(self.completion("json"))
        self.assertEqual([verb["name"] for verb in tree], verbs())
        for shell in ("bash", "zsh", "fish"):
            script = self.completion(shell)
            for verb in tree:
                for option in verb["options"]:
                    for name in option["names"]:
                        word = name.lstrip("-") if shell == "fish" else name
                        self.assertIn(word, script, f"{shell}: {verb['name']} {name}")

    def test_bash_completes(self):
        def complete(*words):
            line = " ".join(f"'{word}'" for word in words)
            script = self.completion("bash") + f"\nCOMP_WORDS=({line}); COMP_CWORD={len(words) - 1}; _rimpact; printf '%s\\n' \"${{COMPREPLY[@]}}\""
            return subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=True).stdout.split()
        self.assertEqual(complete("rimpact", "redu"), ["reduced"])
        self.assertEqual(complete("rimpact", "reduced", "--swe"), ["--sweep"])
        self.assertEqual(complete("rimpact", "list", "key"), ["keys"])
        self.assertEqual(complete("rimpact", "completion", "z"), ["zsh"])
        self.assertEqual(complete("rimpact", "help", "calib"), ["calibrate"])

    def test_other_shells_can_read_their_scripts(self):
        for shell in ("zsh", "fish"):
            if shutil.which(shell):
                done = subprocess.run([shell, "--no-execute" if shell == "fish" else "-n"], input=self.completion(shell), text=True, capture_output=True,
                                      check=False)
                self.assertEqual(done.returncode, 0, done.stderr)


class Plain(unittest.TestCase):
    """Sentences that readers could not follow were said anew, and do not come back."""
    FRAGMENTS = ("a rim's own law at another mass: at a depth", "an uncertainty given so counts", "not as one a sample", "times are of the processor",
                 "what has a dashpot is refused", "each sample counts by itself", "no source's", "leaves unexplained widens", "flat valley", "fly it",
                 "condition inf", "not given by any source", "lower bound 0")
    SUFFIXES = {".cc", ".h", ".py", ".md", ".j2", ".js", ".toml", ".css", ".in", ""}

    @staticmethod
    def running(text):
        """On one line, in small letters: strings that go on in the next line are whole, marks of comments are gone."""
        text = re.sub(r'"\s*\n\s*[a-z]?"', "", text)
        return re.sub(r"\s+", " ", re.sub(r"\n\s*(///?|#)", "\n", text)).lower()

    def test_no_source_and_no_page_holds_them(self):
        found, read = [], 0
        for folder, names, files in os.walk(SOURCE):
            names[:] = [name for name in names if name not in ("build", ".git", "tests", "__pycache__", "data", "results", "run")
                        or (name == "results" and folder.endswith("docs"))]
            for file in files:
                path = pathlib.Path(folder, file)
                if path.suffix not in self.SUFFIXES:
                    continue
                text, read = self.running(path.read_text(encoding="utf-8", errors="replace")), read + 1
                found += [f"{path}: {fragment}" for fragment in self.FRAGMENTS if fragment in text]
        self.assertEqual(found, [])
        self.assertGreater(read, 700)

    def test_a_fragment_over_two_lines_is_found(self):
        for text in ("times are\n    of the Processor", '"no sou"\n    "rce\'s"', "/// flat\n  /// valley"):
            self.assertTrue(any(fragment in self.running(text) for fragment in self.FRAGMENTS), text)


if __name__ == "__main__":
    unittest.main()

"""Expected times: they know how deep an impact presses, and what runs on this machine took."""
import json
import os
import tempfile
import unittest

from command import rimpact

# Newton iterations of finite-element windows on mesh 1, rung rim: (bearing's keys, mass, speed, iterations).
MEASURED = [([], 86952, 0.05, 140), ([], 86952, 0.2, 235), ([], 86952, 0.6, 409), ([], 86952, 1.0, 618),
            (["bearing.rim.thickness_mm=10"], 86952, 0.2, 442), (["bearing.material.steel.yield_MPa=100"], 86952, 0.2, 403),
            (["bearing.material.steel.yield_MPa=1000"], 86952, 0.2, 166)]


def processor():
    with open("/proc/cpuinfo") as file:
        for line in file:
            if line.startswith("model name"):
                return line.split(": ", 1)[1].rstrip("\n")
    return "unknown processor"


class Times(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.cache = temporary.name

    def plan(self, *settings):
        words = [word for setting in settings for word in ("--set", setting)]
        run = rimpact("check", "impact-window", "--json", *words, XDG_CACHE_HOME=self.cache)
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(run.stdout)

    def keep(self, text):
        os.makedirs(os.path.join(self.cache, "rimpact"), exist_ok=True)
        with open(os.path.join(self.cache, "rimpact", "machine.json"), "w") as file:
            file.write(text)

    def test_iterations_follow_the_depth(self):
        for keys, mass, speed, iterations in MEASURED:
            expected = self.plan(*keys, f"load.mass_kg={mass}", f"excitation.speed_m_per_s={speed}")["expected_iterations"]
            self.assertLess(abs(expected / iterations - 1), 0.35, (keys, speed, expected))

    def test_this_machine_is_known(self):
        fresh = self.plan()
        self.assertFalse(fresh["timed_here"])
        unit = {"seconds_per_iteration_and_unknown": 1e-4, "log_variance": 0.0}
        self.keep(json.dumps({processor(): {"rim-mesh1-half": unit}}))
        known = self.plan()
        self.assertTrue(known["timed_here"])
        self.assertAlmostEqual(known["expected_seconds"], 3 + 1e-4 * known["expected_iterations"] * known["expected_dofs"], places=6)
        low, high = known["expected_seconds_range"]
        self.assertLess(low, known["expected_seconds"])
        self.assertLess(high / low, fresh["expected_seconds_range"][1] / fresh["expected_seconds_range"][0])
        text = rimpact("check", "impact-window", XDG_CACHE_HOME=self.cache).stdout
        self.assertRegex(text, r"about \d+ to \d+ min here")

    def test_a_damaged_cache_is_as_none(self):
        expected = self.plan()["expected_seconds"]
        name = json.dumps(processor())
        for text in ("", "not json", "[1]", f"{{{name}: 3}}", f'{{{name}: {{"rim-mesh1-half": {{"seconds_per_iteration_and_unknown": -1, "log_variance": 0}}}}}}',
                     f'{{{name}: {{"rim-mesh1-half": {{"seconds_per_iteration_and_unknown": "x"}}}}}}'):
            self.keep(text)
            self.assertEqual(self.plan()["expected_seconds"], expected, text)


if __name__ == "__main__":
    unittest.main()

"""The film of a run's stored fields: which instants it takes, what stands between them, the files it leaves. Nothing is solved."""
import json
import os
import re
import shutil
import subprocess
import unittest

import synthetic
import synthetic_mesh
from support import InFolder, command, in_process, unpainted

from report import film, film_frames
from report.build import build
from report.run_folder import load_run


class Instants(unittest.TestCase):
    def test_the_longest_stretch_without_a_gap(self):
        timed = lambda times: [(f"{i}.vtu", t) for i, t in enumerate(times)]  # noqa: E731
        times = lambda files: [t for _, t in film.longest(files)]  # noqa: E731
        self.assertEqual(times(timed([1.0, 1.1, 1.2, 3.0, 3.1, 3.2, 3.3, 3.4, 3.5])), [3.0, 3.1, 3.2, 3.3, 3.4, 3.5])
        self.assertEqual(times(timed([1.0, 1.1, 1.2, 1.3])), [])
        self.assertEqual(times([("a.vtu", None)] * 9), [])
        self.assertEqual(times(timed([1.0] * 9)), [])


class Film(InFolder):
    def run_folder(self, times, dent=lambda i: 0.001 * i, speed=0.5):
        synthetic.run(self.path("run"), "run", f'kind = "window"\nspeed_m_per_s = {speed}', lambda t: 0.0, synthetic.Rim(4.5e8, 0.7), "rim", speed)
        os.makedirs(self.path("run", "fields"))
        rows = []
        for i, t in enumerate(times):
            synthetic_mesh.write_vtu(self.path("run", "fields", f"rim_{i:03d}.vtu"), dent=dent(i), stress=True, push=0.002 * i)
            rows.append(f'<DataSet timestep="{t}" file="fields/rim_{i:03d}.vtu"/>')
        self.write("run/fields.pvd", f'<VTKFile type="Collection"><Collection>{"".join(rows)}</Collection></VTKFile>')
        return self.path("run")

    def test_between_instants_fields_are_linear(self):
        files = film.longest(film.instants(load_run(self.run_folder([0.0, 0.01, 0.02, 0.03, 0.04]))))
        stretch = film_frames.read(files)
        for time, share in ((0.0, 0.0), (0.015, 1.5), (0.04, 4.0)):
            moved, stress = stretch.at(time)
            slider = stretch.grid.points[:, 2] > 0.19
            self.assertAlmostEqual(moved[slider, 0].mean(), 0.002 * share, delta=5e-5)
            self.assertAlmostEqual(stress.max(), share / 4 * stretch.stress[4].max(), delta=1e-3 * stretch.stress[4].max())

    def test_the_page_plays_frames_at_equal_steps(self):
        folder = self.run_folder([0.0, 0.004, 0.01, 0.02, 0.03])
        done = in_process("report.film", folder, "--frames", 4)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.path("run", "film.html"), encoding="utf-8") as file:
            data = json.loads(re.search(r'<script class="frames" type="application/json">(.*?)</script>', file.read()).group(1))
        self.assertEqual(data["labels"], ["time 0 s", "time 0.01 s", "time 0.02 s", "time 0.03 s"])
        self.assertEqual(len(set(data["frames"])), 4)
        self.assertEqual(os.path.exists(self.path("run", "film.mp4")), shutil.which("ffmpeg") is not None)

    @unittest.skipUnless(shutil.which("ffprobe"), "ffmpeg is not installed")
    def test_the_film_holds_every_frame(self):
        film.make(load_run(self.run_folder([0.0, 0.01, 0.02, 0.03, 0.04])), self.path("a.html"), 6)
        said = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames", "-of", "csv=p=0", self.path("a.mp4")],
                              capture_output=True, text=True, check=True)
        self.assertEqual(said.stdout.strip(), "6")

    @unpainted
    def test_fewer_instants_make_none(self):
        folder = self.run_folder([0.0, 0.01, 0.02])
        done = command("report.film", folder)
        self.assertEqual(done.returncode, 3)
        self.assertIn("fewer than 5", done.stderr)
        build(folder)
        self.assertFalse(os.path.exists(self.path("run", "film.html")))

    def test_the_report_writes_it_and_says_so(self):
        frames, film.FRAMES = film.FRAMES, 3
        self.addCleanup(setattr, film, "FRAMES", frames)
        path, problems = build(self.run_folder([0.0, 0.01, 0.02, 0.03, 0.04]))
        self.assertEqual(problems, [])
        with open(path, encoding="utf-8") as file:
            self.assertIn("<code>film.html</code>", file.read())
        self.assertTrue(os.path.isfile(self.path("run", "film.html")))

    @unpainted
    def test_another_mesh_is_said(self):
        folder = self.run_folder([0.0, 0.01, 0.02, 0.03, 0.04])
        synthetic_mesh.write_vtu(self.path("run", "fields", "rim_003.vtu"), curved=True, cell_type=72, stress=True)
        _, problems = build(folder)
        self.assertTrue(any("another mesh" in problem for problem in problems), problems)


if __name__ == "__main__":
    unittest.main()

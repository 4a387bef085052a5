"""What is drawn is what is stored: no line of a figure leaves the samples, none is left out."""
import unittest
from unittest import mock

import numpy as np
import synthetic
from support import InFolder

from report import motion
from report.curves import Curve, ImpactCurve
from report.figures import energy, impacts, measured, response_panels
from report.run_folder import Run
from report.style import plt

N = 8000
PIXEL = 0.3  #: largest distance allowed between what is drawn and what is stored


def record(n=N):
    """A bidirectional record's run: a coarse drift under fast shaking, with spikes of rim force."""
    random = np.random.default_rng(4)
    time = np.linspace(0.0, 0.005 * n, n)
    noise = lambda share: share * np.convolve(random.normal(size=n), np.ones(5) / 5, "same")  # noqa: E731
    ux, uy = 0.35 * np.sin(0.9 * time) * np.sin(0.2 * time) + noise(0.003), 0.3 * np.cos(1.3 * time) * np.sin(0.3 * time) + noise(0.003)
    spikes = np.where(np.convolve(random.random(n) > 0.997, np.ones(3), "same") > 0, 9e5, 0.0)
    fx, fy = -1.2e6 * ux + noise(1e5) - spikes, -1.2e6 * uy + noise(1e5) + spikes
    zero = np.zeros(n)
    return Run("sylmar", "", {"time": time, "displacement_x": ux, "displacement_y": uy, "displacement_z": noise(0.01), "force_x": fx, "force_y": fy,
                              "impact_x": -spikes, "impact_y": zero, "gap": 0.4 - np.hypot(ux, uy), "energy_external": noise(2e4),
                              "energy_kinetic": np.abs(noise(1e4))}, {"rung": "reduced"}, {"excitation": {"kind": "record"}})


def lines_of(draw, *arguments):
    """Every curve of the figure that draw makes: (stored vertices, vertices the renderer gets), in pixels."""
    with mock.patch(f"{draw.__module__}.save", side_effect=lambda fig, path, *_: fig.canvas.draw() or fig):
        fig = draw(*arguments, "unused.png")
    found = []
    for ax in fig.axes:
        for line in ax.get_lines():
            if line.get_linestyle() == "None" or len(line.get_xdata()) < 3:
                continue
            transform, path = line.get_transform(), line.get_path()
            simple = path.should_simplify and plt.rcParams["path.simplify"]
            path.simplify_threshold = plt.rcParams["path.simplify_threshold"]
            drawn = path.cleaned(transform, simplify=simple, curves=False).vertices[:-1]
            found.append((line.get_xydata(), transform.transform(path.vertices), drawn))
    plt.close(fig)
    return found


def distance(points, chain):
    """Of each point to the nearest place of a polyline."""
    px, py = points.T.astype(np.float32)
    (ax, ay), (dx, dy) = chain[:-1].T.astype(np.float32), np.diff(chain, axis=0).T.astype(np.float32)
    size, far = np.maximum(dx * dx + dy * dy, 1e-9), np.empty(len(points))
    for i in range(0, len(points), 8):  # so few at once stay in the processor's cache
        x, y = px[i:i + 8, None] - ax, py[i:i + 8, None] - ay
        along = (x * dx + y * dy) / size
        np.minimum(np.maximum(along, 0, out=along), 1, out=along)
        x -= along * dx
        y -= along * dy
        far[i:i + 8] = np.sqrt(np.min(x * x + y * y, axis=1))
    return far


class Drawn(unittest.TestCase):
    def test_loops_and_paths_of_a_record_follow_every_sample(self):
        lines = lines_of(response_panels.draw, [("fitted", record())], {"fitted": "reduced"}, 0.4)
        self.assertEqual(sum(len(stored) == N for stored, *_ in lines), 6)  # two norms, two loops, the path, the height
        for stored, pixels, drawn in lines:
            if len(stored) != N:
                continue
            between = drawn[:-1] + 0.5 * np.diff(drawn, axis=0)
            self.assertLess(distance(pixels, drawn).max(), PIXEL)
            self.assertLess(distance(between, pixels).max(), PIXEL)

    def test_the_test_finds_a_polygon(self):
        _, pixels, drawn = next(line for line in lines_of(response_panels.draw, [("fitted", record())], {"fitted": "reduced"}, 0.4) if len(line[0]) == N)
        self.assertGreater(distance(pixels, drawn[::20]).max(), 5 * PIXEL)

    def test_no_figure_leaves_samples_out(self):
        run = record()
        for lines in (lines_of(energy.draw, [("run", run)]),
                      lines_of(motion.draw, {"time": run.time, "acceleration": run.signals["force_x"]})):
            self.assertIn(N, [len(stored) for stored, *_ in lines])
        time = np.linspace(0, 0.02, 3000)
        curve = Curve(time, 0.01 * np.sin(150 * time), 1e6 * np.sin(150 * time))
        lines = lines_of(measured.draw, ImpactCurve("a", "measured", 0.2, curve, curve), "signed")
        self.assertEqual([len(stored) for stored, *_ in lines if len(stored) > 2], [3000] * 4)


class Names(InFolder):
    def test_dollars_in_a_name_are_no_formula(self):
        run = record(800)
        for name in (r"$\frac{$", "a$b$c", r"\$x$", "bad\udce9name"):
            self.assertTrue(response_panels.draw([("fe", run)], {"fe": name}, 0.4, self.path("a.png")))
            self.assertTrue(impacts.draw([("fe", run)], {"fe": name}, self.path("b.png")))

    def test_a_formula_for_a_name_reaches_a_report_and_a_quick_picture(self):
        from report.build import build
        from report.quick import draw
        name = r"$\frac{$"
        synthetic.run(self.path(name), name, 'kind = "window"\nspeed_m_per_s = 0.2', lambda t: 0.0, synthetic.Rim(4e8, 0.6), "reduced", 0.2)
        self.assertTrue(draw("reduced", self.path(name)))
        path, problems = build(self.path(name))
        self.assertEqual(problems, [])


if __name__ == "__main__":
    unittest.main()

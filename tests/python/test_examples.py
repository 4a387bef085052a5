"""The examples that need packages of their own: each runs where its package is installed, and is skipped by name where it is not."""
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import rimpact

EXAMPLES = pathlib.Path(os.environ["RIMPACT_SOURCE"]) / "examples"
os.environ["RIMPACT_PROGRAM"] = os.environ["RIMPACT"]


def need(*packages):
    missing = [name for name in packages if importlib.util.find_spec(name) is None]
    return unittest.skipIf(missing, f"needs the Python package{'s' if len(missing) > 1 else ''} {', '.join(missing)}")


class SideBySide(unittest.TestCase):
    def expect_peaks(self, script, *words):
        done = subprocess.run([sys.executable, str(EXAMPLES / "python" / script), *words], capture_output=True, text=True, timeout=200, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        expected = []
        for v in (0.1, 0.2, 0.4):
            for k in (3e5, 9e5):
                own = rimpact.summarise(rimpact.Scene("impact-window", {"excitation.speed_m_per_s": v, "reduced.k_i_kN_per_m": k}))
                expected.append(f"{v} m/s, {k:.0f} kN/m: {own['peak_impact_force_N'] / 1e3:.1f} kN")
        self.assertEqual(done.stdout.splitlines(), expected)

    @need("joblib")
    def test_joblib_gives_what_one_process_gives(self):
        self.expect_peaks("with_joblib.py")

    @need("joblib", "dask")
    def test_dask_gives_what_one_process_gives(self):
        self.expect_peaks("with_dask.py")

    @need("joblib", "dask", "distributed")
    def test_and_so_does_a_cluster(self):
        from dask.distributed import LocalCluster
        with LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as cluster:
            self.expect_peaks("with_dask.py", cluster.scheduler_address)


class Notebook(unittest.TestCase):
    SOURCE = EXAMPLES / "notebook/first-steps.ipynb"

    @need("nbclient", "nbformat", "ipykernel", "matplotlib")
    def test_every_cell_runs_and_shows_what_it_is_about(self):
        import nbformat
        from nbclient import NotebookClient
        notebook = nbformat.read(self.SOURCE, as_version=4)
        nbformat.validate(notebook)
        with tempfile.TemporaryDirectory() as folder:
            NotebookClient(notebook, timeout=200, resources={"metadata": {"path": folder}}).execute()
        shown = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
        tables = [output.data["text/html"] for output in shown if "text/html" in output.get("data", {})]
        self.assertGreaterEqual(len(tables), 4)  # scene, impacts, law, fleet
        self.assertGreaterEqual(sum("image/png" in output.get("data", {}) for output in shown), 2)
        self.assertIn("elastoplastic", "".join(output.get("text", "") for output in shown))
        self.assertFalse([output for output in shown if output.output_type == "error"])

    def test_its_cells_run_without_a_notebook_too(self):
        """Where nbclient is not installed its code still has to hold: in one interpreter, cell after cell."""
        import json
        cells = [cell for cell in json.loads(self.SOURCE.read_text(encoding="utf-8"))["cells"] if cell["cell_type"] == "code"]
        self.assertTrue(all(cell["outputs"] == [] for cell in cells), "stored without what they print")
        code = "import matplotlib\nmatplotlib.use('Agg')\n" + "\n".join("".join(line for line in cell["source"] if not line.startswith("%")) for cell in cells)
        with tempfile.TemporaryDirectory() as folder:
            script = pathlib.Path(folder) / "cells.py"
            script.write_text(code, encoding="utf-8")
            done = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, cwd=folder, timeout=200, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("elastoplastic", done.stdout)


if __name__ == "__main__":
    unittest.main()

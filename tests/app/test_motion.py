"""`rimpact motion` reads records of PEER, and refuses what is none."""
import csv
import json
import math
import os
import tempfile
import unittest
import zipfile

import numpy as np
from command import Refusals, rimpact

AT2 = "PEER\nA RECORD\n{}\nNPTS= {}, DT= .0100 SEC\n"


class Motion(Refusals):
    def correct(self, table, holds, *changes):
        """What a user does to the table that --ask wrote, which has to hold some lines."""
        with open(table) as file:
            text = file.read()
        self.assertIn(holds, text)
        for old, new in changes:
            text = text.replace(old, new)
        with open(table, "w") as file:
            file.write(text)

    def test_records(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.AT2")
            self.refused(3, "a.AT2", arguments=["motion", path])
            for units, npts, needle in (("VELOCITY TIME SERIES IN UNITS OF CM/S", 3, "VELOCITY"),
                                        ("ACCELERATION TIME SERIES IN UNITS OF G", 30, "30")):
                with open(path, "w") as file:
                    file.write(AT2.format(units, npts) + " .1E-01 .2E-01 .1E-01\n")
                run = rimpact("motion", path)
                self.assertEqual(run.returncode, 3)
                self.assertIn(needle.lower(), run.stderr.lower())

    def test_a_record_is_sought_on_the_shelf(self):
        with tempfile.TemporaryDirectory() as shelf, tempfile.TemporaryDirectory() as place:
            with open(os.path.join(shelf, "OWN.AT2"), "w") as file:
                file.write(AT2.format("ACCELERATION TIME SERIES IN UNITS OF G", 3) + " .1E-01 .2E-01 .1E-01\n")
            self.assertEqual(rimpact("motion", "OWN.AT2", cwd=place).returncode, 3)
            run = rimpact("motion", "OWN.AT2", "--json", cwd=place, RIMPACT_RECORDS=shelf)
            self.assertEqual(json.loads(run.stdout)[0]["npts"], 3)

    def test_a_folder_is_a_table_of_stations(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("RSN1_HMC180", "RSN1_HMC270", "RSN1_HMCDWN", "RSN2_BAM-L", "RSN2_BAM-T", "lone"):
                with open(os.path.join(folder, name + ".AT2"), "w") as file:
                    file.write(AT2.format("ACCELERATION TIME SERIES IN UNITS OF G", 3) + " .1E-01 .2E-01 .1E-01\n")
            with open(os.path.join(folder, "broken090.AT2"), "w") as file:
                file.write("nothing")
            run = rimpact("motion", folder, "--json")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn("lone.AT2 is told neither by header nor by name", run.stderr)
            rows = {os.path.basename(row["file"]): row for row in json.loads(run.stdout)}
            self.assertEqual(len(rows), 7)
            self.assertEqual(rows["RSN1_HMC180.AT2"]["pair"], "RSN1_HMC270.AT2")
            self.assertEqual((rows["RSN1_HMC270.AT2"]["station"], rows["RSN1_HMC270.AT2"]["azimuth_deg"]), ("RSN1_HMC", 270))
            self.assertEqual((rows["RSN1_HMCDWN.AT2"]["kind"], rows["RSN1_HMCDWN.AT2"]["pair"]), ("vertical", None))
            self.assertEqual((rows["RSN2_BAM-L.AT2"]["pair"], rows["RSN2_BAM-L.AT2"]["azimuth_deg"]), ("RSN2_BAM-T.AT2", None))
            self.assertAlmostEqual(rows["RSN2_BAM-L.AT2"]["length_s"], 0.02)
            self.assertEqual((rows["lone.AT2"]["kind"], rows["lone.AT2"]["doubts"][0]), ("unknown", "its direction is not known"))
            self.assertIsNone(rows["broken090.AT2"]["pga_g"])
            self.assertIn("NPTS and DT", rows["broken090.AT2"]["doubts"][0])
            self.assertIn("RSN2_BAM-T.AT2", rimpact("motion", folder).stdout)

            self.assertEqual(rimpact("motion", folder, "--ask").returncode, 0)
            table = os.path.join(folder, "records.csv")
            self.correct(table, "lone.AT2,lone,,\n", ("lone.AT2,lone,", "lone.AT2,lone,N35E"))
            rows = {os.path.basename(row["file"]): row for row in json.loads(rimpact("motion", folder, "--json").stdout)}
            self.assertEqual((rows["lone.AT2"]["azimuth_deg"], rows["lone.AT2"]["kind"]), (35, "horizontal"))
            self.assertNotIn("its direction is not known", rows["lone.AT2"]["doubts"])
            self.refused(2, "--ask", arguments=["motion", os.path.join(folder, "lone.AT2"), "--ask"])

    def test_an_offset_is_doubted_and_taken_off_when_asked(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "offset.csv")
            with open(path, "w", encoding="latin-1") as file:
                file.write("Zeit [s];Beschleunigung [m/s\u00b2]\n")
                for k in range(2000):
                    wave = math.sin(0.3 * k) * math.sin(math.pi * k / 2000) ** 2
                    file.write(f"{0.01 * k:.2f};{2 * wave + 0.2:.6f}\n".replace(".", ","))
            row = json.loads(rimpact("motion", path, "--json").stdout)[0]
            self.assertIn("an offset of 0.2", row["doubts"][0])
            done = rimpact("motion", path, "--baseline", os.path.join(folder, "mended"))
            self.assertEqual(done.returncode, 0, done.stderr)
            row = json.loads(rimpact("motion", os.path.join(folder, "mended", "offset.csv"), "--period", "1", "--json").stdout)[0]
            self.assertEqual(row["doubts"], [])
            self.assertGreater(row["sa_g"], 0)
            self.assertIsNone(row["rotd50_g"])

    def test_pairs_have_rotations_and_copies_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, scale in (("A000", 1), ("A090", 1), ("B000", 2)):
                values = " ".join(f"{scale * 0.1 * math.sin(0.3 * k + len(name) * (name == 'A090')) * math.sin(math.pi * k / 900) ** 2:.6e}"
                                  for k in range(900))
                with open(os.path.join(folder, name + ".AT2"), "w") as file:
                    file.write(AT2.format("ACCELERATION TIME SERIES IN UNITS OF G", 900) + values + "\n")
            rows = json.loads(rimpact("motion", folder, "--period", "0.5", "--json").stdout)
            self.assertEqual([bool(row["rotd50_g"]) for row in rows], [True, True, False])
            self.assertLessEqual(rows[0]["rotd50_g"], rows[0]["rotd100_g"])
            self.assertGreaterEqual(rows[0]["rotd100_g"], max(rows[0]["sa_g"], rows[1]["sa_g"]) * (1 - 1e-3))
            self.assertIn("2 times A000.AT2", " ".join(rows[2]["doubts"]))

    def write_pairs(self, folder, n):
        for k in range(1, n + 1):
            for direction, period, phase in (("000", 0.4 + 0.2 * k, 0.3), ("090", 0.5 + 0.15 * k, 0.9)):
                with open(os.path.join(folder, f"RSN{k}_HILL{direction}.AT2"), "w") as file:
                    file.write(AT2.format("ACCELERATION TIME SERIES IN UNITS OF G", 1500))
                    file.writelines(f"{0.1 * k * math.exp(-i / 500) * math.sin(2 * math.pi * 0.01 * i / period + phase):.6e}\n"
                                    for i in range(1500))

    def test_recordings_are_selected_and_scaled_and_flown(self):
        with tempfile.TemporaryDirectory() as place:
            self.write_pairs(place, 5)
            out = os.path.join(place, "out")
            select = ["motion", place, "--select", "3", "--period", "2", "--target"]
            run = rimpact(*select, "asce7,S_DS=1.0,S_D1=0.6,T_L=8", "-o", out, "--largest-scale", "50", "--json")
            self.assertEqual(run.returncode, 0, run.stderr)
            found = json.loads(run.stdout)
            self.assertEqual(len(found["recordings"]), 3)
            self.assertAlmostEqual(found["from_s"], 0.4)
            self.assertAlmostEqual(found["to_s"], 3.0)
            self.assertGreaterEqual(found["least_mean_over_target"], 0.9 - 1e-9)
            self.assertEqual(sorted(os.listdir(out)), ["selection.csv", "spectrum.csv", "spectrum.png", "sweep.toml"])
            sweep = rimpact("reduced", "ricker-0.78g-1.0s", "--sweep", os.path.join(out, "sweep.toml"), "-o",
                            os.path.join(place, "flown"), "--json", "--quiet")
            self.assertEqual(json.loads(sweep.stdout)["n_runs"], 3, sweep.stderr)
            for target, needle in (("asce7,S_DS=1.0", "S_D1"), ("en1998,a_g=0.2,ground=Q", "ground")):
                refused = rimpact(*select, target, "-o", out)
                self.assertEqual(refused.returncode, 2)
                self.assertIn(needle, refused.stderr)

    def test_spectra_of_records_with_a_target(self):
        with tempfile.TemporaryDirectory() as place:
            self.write_pairs(place, 2)
            out = os.path.join(place, "spectra")
            run = rimpact("motion", place, "--spectrum", out, "--target", "asce7,S_DS=1.0,S_D1=0.6", "--period", "1.0", "--json")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual(sorted(os.listdir(out)), ["spectrum.csv", "spectrum.png"])
            with open(f"{out}/spectrum.csv", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            self.assertEqual(len(rows), 4 * 61)
            known = {row["file"].rsplit("/")[-1]: row for row in json.loads(run.stdout)}
            for name, record in known.items():
                of_record = [row for row in rows if row["file"] == name]
                periods = [float(row["period_s"]) for row in of_record]
                for mine, theirs in (("sa_g", "sa_g"), ("rotd50_g", "rotd50_g"), ("rotd100_g", "rotd100_g")):
                    at_one = np.interp(1.0, periods, [float(row[mine]) for row in of_record])
                    self.assertAlmostEqual(at_one / record[theirs], 1, delta=0.05)
            self.assertAlmostEqual(float(rows[30]["target_g"]), min(1.0, 0.6 / float(rows[30]["period_s"])), places=6)
            table = rimpact("motion", place, "--period", "1.0").stdout.splitlines()
            ends = {line.rstrip()[-8:].strip().count(".") for line in table[1:] if line.startswith("RSN")}
            self.assertEqual((table[0].split()[-2:], ends), (["RotD100", "[g]"], {1}))
            for wrong, needle in ((("--target", "asce7,S_DS=1.0,S_D1=0.6"), "--select or --spectrum"),
                                  (("--strike", "30", "--rotated", out, "--spectrum", out), "stand without")):
                refused = rimpact("motion", place, *wrong)
                self.assertEqual(refused.returncode, 2)
                self.assertIn(needle, refused.stderr)

    def test_a_table_beside_an_archive_corrects_it(self):
        with tempfile.TemporaryDirectory() as place:
            archive = os.path.join(place, "portal.zip")
            with zipfile.ZipFile(archive, "w") as file:
                for name in ("in/hill", "in/dale"):
                    file.writestr(name + ".AT2", AT2.format("ACCELERATION TIME SERIES IN UNITS OF G", 3) + " .1E-01 .2E-01 .1E-01\n")
            self.assertEqual(rimpact("motion", archive, "--ask").returncode, 0)
            table = os.path.join(place, "portal.records.csv")
            self.correct(table, "in/dale.AT2,dale,,\nin/hill.AT2,hill,,\n", ("in/dale.AT2,dale,,", "in/dale.AT2,ridge,N,"), ("in/hill.AT2,hill,,", "in/hill.AT2,ridge,E,"))
            for where in ("beside", "inside"):
                rows = json.loads(rimpact("motion", archive, "--json").stdout)
                self.assertEqual({row["station"] for row in rows if row["pair"]}, {"ridge"}, where)
                if where == "beside":
                    with zipfile.ZipFile(archive, "a") as file:
                        file.write(table, "in/records.csv")
                    os.remove(table)

    def test_pairs_are_turned_to_a_fault(self):
        with tempfile.TemporaryDirectory() as place:
            self.write_pairs(place, 2)
            out = os.path.join(place, "turned")
            run = rimpact("motion", place, "--strike", "30", "--rotated", out)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual(sorted(os.listdir(out)), ["RSN1_HILL-FN.csv", "RSN1_HILL-FP.csv", "RSN2_HILL-FN.csv", "RSN2_HILL-FP.csv"])
            turned = json.loads(rimpact("motion", out, "--json").stdout)
            self.assertEqual(len([row for row in turned if row["pair"]]), 4)

    def test_every_station_of_appendix_c_is_a_pair(self):
        records = os.environ.get("RIMPACT_RECORDS", os.path.join(os.path.dirname(__file__), "../../../shared/records"))
        if not os.path.isdir(os.path.join(records, "appendix_c")):
            self.skipTest("the records of appendix C are not here")
        rows = json.loads(rimpact("motion", os.path.join(records, "appendix_c"), "--json").stdout)
        self.assertEqual(len([row for row in rows if row["pair"]]), 2 * 117)
        self.assertEqual({row["kind"] for row in rows}, {"horizontal"})

    def test_motion_of_real_records(self):
        records = os.environ.get("RIMPACT_RECORDS", os.path.join(os.path.dirname(__file__), "../../../shared/records"))
        path = os.path.join(records, "RSN1086_NORTHR_SYL360.AT2")
        if not os.path.exists(path):
            self.skipTest("the ground-motion records are not here (set RIMPACT_RECORDS)")
        table = json.loads(rimpact("motion", path, "--json").stdout)
        self.assertAlmostEqual(table[0]["dt_s"], 0.02)


if __name__ == "__main__":
    unittest.main()

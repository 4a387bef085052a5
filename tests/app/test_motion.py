"""`rimpact motion` reads records of PEER, and refuses what is none."""
import json
import os
import tempfile
import unittest

from command import Refusals, rimpact

AT2 = "PEER\nA RECORD\n{}\nNPTS= {}, DT= .0100 SEC\n"


class Motion(Refusals):
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
            with open(table) as file:
                text = file.read()
            self.assertIn("lone.AT2,lone,\n", text)
            with open(table, "w") as file:
                file.write(text.replace("lone.AT2,lone,", "lone.AT2,lone,N35E"))
            rows = {os.path.basename(row["file"]): row for row in json.loads(rimpact("motion", folder, "--json").stdout)}
            self.assertEqual((rows["lone.AT2"]["azimuth_deg"], rows["lone.AT2"]["doubts"]), (35, []))
            self.refused(2, "--ask", arguments=["motion", os.path.join(folder, "lone.AT2"), "--ask"])

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

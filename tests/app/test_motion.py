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

    def test_motion_of_real_records(self):
        records = os.environ.get("RIMPACT_RECORDS", os.path.join(os.path.dirname(__file__), "../../../shared/records"))
        path = os.path.join(records, "RSN1086_NORTHR_SYL360.AT2")
        if not os.path.exists(path):
            self.skipTest("the ground-motion records are not here (set RIMPACT_RECORDS)")
        table = json.loads(rimpact("motion", path, "--json").stdout)
        self.assertAlmostEqual(table[0]["dt_s"], 0.02)


if __name__ == "__main__":
    unittest.main()

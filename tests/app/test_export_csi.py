"""The text of SAP2000 and ETABS, field by field against files that these programs wrote themselves.

Sources, all in the public repository MarkPThomas/MPT.Net at commit 03dd160cb173a1a0f1c467ae86a1fcade4676534 (names of fields and their order alone are taken):
SAP2000 20.1.0: MPT/CSI/API/MPT.CSI.Serialize.SAP2000/model/test.s2k, with a link of each type;
SAP2000 before 20, which has no field Point: MPT/CSI/API/MPT.CSI.API.EndToEndTests/Resources/Seed/Query.$2k;
ETABS 2015 15.2.0: .../Resources/Seed/Query.$et, of the types MULTILINEAR ELASTIC and PLASTIC, and .../Demo.$et, LINEAR.
Not seen in any file of ETABS, and said so here: the types GAP and FRICTION ISOLATOR, named by the same rule (the dialog's name in capitals), and their words K, OPEN,
CDAMP, CSLOW, CFAST, RATE and RADIUS, which stand among the words of $ LINK PROPERTIES in ETABS itself."""
import os
import re
import tempfile
import unittest

from command import rimpact
from exported import Exported, calibration, write

GENERAL = ["Link", "LinkType", "Mass", "Weight", "RotInert1", "RotInert2", "RotInert3", "DefLength", "DefArea", "PDM2I", "PDM2J", "PDM3I", "PDM3J", "Color", "Notes"]
FIRST = ["Link", "DOF", "Fixed", "NonLinear", "TransKE", "TransCE"]
# By table, then by direction: "U1" axial, "U2" shear (U3 alike). A later row of a multilinear table has POINT alone.
POINT = ["Link", "DOF", "Point", "Force", "Displ"]
SAP2000 = {
    "LINK PROPERTY DEFINITIONS 01 - GENERAL": {"": GENERAL},
    "LINK PROPERTY DEFINITIONS 02 - LINEAR": {"U1": ["Link", "DOF", "Fixed", "TransKE", "TransCE"]},
    "LINK PROPERTY DEFINITIONS 03 - MULTILINEAR": {"U2": [*FIRST, "DJ", *POINT[2:]]},
    "LINK PROPERTY DEFINITIONS 05 - GAP": {"U1": [*FIRST, "TransK", "TransOpen"]},
    "LINK PROPERTY DEFINITIONS 08 - SLIDING ISOLATOR": {"U1": [*FIRST, "TransK", "TransC"], "U2": [*FIRST, "DJ", "TransK", "Slow", "Fast", "Rate", "Radius"]},
    "LINK PROPERTY DEFINITIONS 11 - MULTILINEAR PLASTIC": {"U1": [*FIRST, "HysType", *POINT[2:]]},
}
MULTILINEAR = {table for table in SAP2000 if "MULTILINEAR" in table}
LINK_TYPES = {"Gap", "Linear", "MultiLinear Elastic", "MultiLinear Plastic", "Friction Isolator"}
TABLE_OF = {"Gap": "05 - GAP", "Linear": "02 - LINEAR", "MultiLinear Elastic": "03 - MULTILINEAR", "MultiLinear Plastic": "11 - MULTILINEAR PLASTIC",
            "Friction Isolator": "08 - SLIDING ISOLATOR"}
ETABS = {
    "LINEAR": {"U1": ["KE", "CE"]},
    "GAP": {"U1": ["KE", "CE", "NONLIN", "K", "OPEN"]},
    "MULTILINEAR PLASTIC": {"U1": ["KE", "CE", "NONLIN", "HYSTYPE"]},
    "MULTILINEAR ELASTIC": {"U2": ["KE", "CE", "DJ", "NONLIN"]},
    "FRICTION ISOLATOR": {"U1": ["KE", "CE", "NONLIN", "K", "CDAMP"], "U2": ["KE", "CE", "DJ", "NONLIN", "K", "CSLOW", "CFAST", "RATE", "RADIUS"]},
}


def sap_tables(text):
    """Rows of [field, value] by table; lines that begin with $ are comments."""
    tables, rows = {}, []
    for line in text.splitlines():
        if line.startswith("TABLE:"):
            rows = tables.setdefault(re.fullmatch(r'TABLE:  "([^"]+)"', line)[1], [])
        elif line.startswith("   "):
            rows.append([[key, value.strip('"')] for key, value in re.findall(r'(\w+)=("[^"]*"|\S+)', line)])
    return tables


class ByTheProgramsOwnFiles(Exported):
    LAWS = {"elastoplastic": {}, "signed": {"name": "signed", "belongs_to": "mass"}}

    def written(self, law, program, bearing="shfps-225"):
        """The file's text; the whole bearing, whatever a pulse would make of it."""
        with tempfile.TemporaryDirectory() as folder:
            content = calibration(identity=self.rim)
            if law == "signed":
                content["answer"]["law"] |= {"name": "signed", "element": {"lateral_capacity_m": 0.4, "reference_speed_m_per_s": 0.5,
                                                                          "k_i": {"value": 450000, "unit": "kN/m"}, "e": {"value": 0.5, "unit": "-"}}}
            write(folder, content)
            run = rimpact("export", folder, f"--{program}", "--anyway", "--scene", bearing)
            self.assertEqual(run.returncode, 0, run.stderr)
            with open(os.path.join(folder, "bearing." + {"sap2000": "s2k", "etabs": "e2k"}[program]), encoding="utf-8") as file:
                return file.read()

    def test_every_row_of_sap2000_has_the_fields_that_sap2000_writes(self):
        for law in self.LAWS:
            text = self.written(law, "sap2000")
            self.assertTrue(text.endswith("END TABLE DATA\n"))
            tables = sap_tables(text)
            self.assertEqual(tables["PROGRAM CONTROL"], [[["ProgramName", "SAP2000"], ["CurrUnits", "KN, m, C"]]])
            types = {}
            for name, rows in tables.items():
                if name == "PROGRAM CONTROL":
                    continue
                self.assertIn(name, SAP2000)
                seen = set()
                for row in rows:
                    fields, values = [key for key, _ in row], dict(row)
                    dof = values.get("DOF", "").replace("U3", "U2")
                    known = SAP2000[name][dof]
                    again = name in MULTILINEAR and (values["Link"], values["DOF"]) in seen
                    seen.add((values["Link"], values.get("DOF")))
                    self.assertEqual(fields, POINT if again else [key for key in known if key in fields], f"{name}: {row}")
                    needed = POINT if again else [key for key in known if key not in ("Color", "Notes")]
                    self.assertEqual(set(needed) - set(fields), set(), f"{name}: {row}")
                    if name.endswith("GENERAL"):
                        self.assertIn(values["LinkType"], LINK_TYPES)
                        types[values["Link"]] = values["LinkType"]
                    else:
                        self.assertTrue(name.endswith(TABLE_OF[types[values["Link"]]]), f"{values['Link']} in {name}")
                        self.assertRegex(values["DOF"], "^U[123]$")
            self.assertEqual(types["RIM"], {"elastoplastic": "MultiLinear Plastic", "signed": "Linear"}[law])
            defined = {dict(row)["Link"] for name, rows in tables.items() if "DEFINITIONS 01" not in name and name != "PROGRAM CONTROL" for row in rows}
            self.assertEqual(defined, set(types))

    def test_points_are_counted_and_rise(self):
        rows = [dict(row) for row in sap_tables(self.written("elastoplastic", "sap2000"))["LINK PROPERTY DEFINITIONS 11 - MULTILINEAR PLASTIC"]]
        self.assertEqual([int(row["Point"]) for row in rows], list(range(1, len(rows) + 1)))
        for one, other in zip(rows, rows[1:]):
            self.assertLess(float(one["Displ"]), float(other["Displ"]))
        self.assertIn(0.0, [float(row["Displ"]) for row in rows])  # the program wants the origin among them
        self.assertLess(float(rows[0]["Displ"]), 0)
        self.assertGreater(float(rows[-1]["Displ"]), 0)

    def test_every_line_of_etabs_has_the_words_that_etabs_writes(self):
        for law in self.LAWS:
            text = self.written(law, "etabs")
            self.assertIn('$ CONTROLS\n  UNITS  "KN"  "M"  "C"', text)
            body = text[text.index("$ LINK PROPERTIES"):].splitlines()[1:]
            types, points, last = {}, {}, None
            for line in filter(str.strip, body):
                if found := re.fullmatch(r'  LINKPROP  "(\w+)"  TYPE "([^"]+)"', line):
                    types[found[1]] = found[2]
                    self.assertIn(found[2], ETABS)
                elif found := re.fullmatch(r'  LINKPROP  "(\w+)"  DOF "(U[123])"  (.*)', line):
                    last = found[1], found[2]
                    words = re.findall(r"[A-Z]+(?= )", re.sub(r'"[^"]*"', '" ', found[3]))
                    self.assertEqual(words, ETABS[types[found[1]]][found[2].replace("U3", "U2")], line)
                elif found := re.fullmatch(r'  LINKPROPFORCEDISPL  "(\w+)"  DISPL (\S+) FORCE (\S+)', line):
                    self.assertEqual(found[1], last[0], "points follow the direction that they are of")
                    points.setdefault(last, []).append((float(found[2]), float(found[3])))
                else:
                    self.fail(f"ETABS writes no such line: {line}")
            for key, table in points.items():
                self.assertIn("MULTILINEAR", types[key[0]])
                self.assertEqual([d for d, _ in table], sorted(d for d, _ in table), key)
            self.assertEqual(bool(points.get(("RIM", "U1"))), law == "elastoplastic")

    def test_both_files_say_the_same_numbers(self):
        sap, etabs = (self.written("elastoplastic", program) for program in ("sap2000", "etabs"))
        rows = [dict(row) for row in sap_tables(sap)["LINK PROPERTY DEFINITIONS 11 - MULTILINEAR PLASTIC"]]
        pairs = re.findall(r'LINKPROPFORCEDISPL  "RIM"  DISPL (\S+) FORCE (\S+)', etabs)
        self.assertEqual([(row["Displ"], row["Force"]) for row in rows], pairs)
        gap = dict(sap_tables(sap)["LINK PROPERTY DEFINITIONS 05 - GAP"][0])
        self.assertRegex(etabs, rf'"RIM_GAP"  DOF "U1"  .*K {re.escape(gap["TransK"])} OPEN {re.escape(gap["TransOpen"])}')


if __name__ == "__main__":
    unittest.main()

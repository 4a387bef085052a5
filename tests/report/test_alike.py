"""Doubts of one kind: the report tells them apart as the program does, by one file and held to one table."""
import json
import pathlib
import unittest

from report.plain_words import kind_of, worst_of

CASES = pathlib.Path(__file__).resolve().parents[1] / "alike.json"


class Alike(unittest.TestCase):
    def test_the_shared_table(self):
        for case in json.loads(CASES.read_text(encoding="utf-8")):
            self.assertEqual(len({kind_of(said) for said in case["said"]}), case["kinds"], case["said"][0])
            if case["kinds"] == 1:
                self.assertEqual(worst_of(case["said"]), case["worst"], case["said"][0])

    def test_a_minus_of_typography_is_one(self):
        self.assertEqual(kind_of("off by \u22122.5 %"), kind_of("off by 3 %"))
        self.assertEqual(worst_of(["off by \u22125 %", "off by 3 %"]), 0)


if __name__ == "__main__":
    unittest.main()

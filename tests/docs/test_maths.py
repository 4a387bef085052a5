"""Formulas of the pages as MathML: what TeX means, and that nothing is passed over in silence."""
import os
import pathlib
import sys
import unittest
import xml.etree.ElementTree as tree

SOURCE = pathlib.Path(os.environ["RIMPACT_SOURCE"])
sys.path.insert(0, str(SOURCE / "docs/generate"))
import maths  # noqa: E402


def inside(tex):
    return maths.mathml(tex).removeprefix("<math><mrow>").removesuffix("</mrow></math>")


class Maths(unittest.TestCase):
    def test_scripts_fractions_and_roots(self):
        self.assertEqual(inside("k_i"), "<msub><mi>k</mi><mi>i</mi></msub>")
        self.assertEqual(inside("x^2_0"), "<msubsup><mi>x</mi><mn>0</mn><mrow><mn>2</mn></mrow></msubsup>")
        self.assertEqual(inside("d'"), """<mrow><mi>d</mi><mo lspace="0" rspace="0">′</mo></mrow>""")
        self.assertEqual(inside(r"\frac{a}{b}"), "<mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac>")
        self.assertEqual(inside(r"\sqrt{\pi}"), "<msqrt><mrow><mi>π</mi></mrow></msqrt>")

    def test_words_keep_their_spaces(self):
        self.assertEqual(inside(r"R_{\text{eff}} \text{ if so}"), "<msub><mi>R</mi><mrow><mtext>eff</mtext></mrow></msub><mtext> if so</mtext>")

    def test_a_case_is_a_row(self):
        cases = tree.fromstring(maths.mathml(r"\begin{cases} 1 & x > 0 \\ 0 & \text{else} \end{cases}"))
        self.assertEqual([len(row) for row in cases.iter("mtr")], [2, 2])

    def test_what_is_not_known_is_an_error(self):
        for tex in (r"\frobnicate", r"\begin{matrix} 1 \end{matrix}", "{a", r"\left( a"):
            with self.assertRaises(maths.Unknown, msg=tex):
                maths.mathml(tex)

    def test_code_is_no_formula(self):
        text, made = maths.with_marks("costs `$HOME` and $a$\n```sh\necho $v $w\n```\n$$b$$\n")
        self.assertEqual(len(made), 2)
        self.assertIn("`$HOME`", text)
        self.assertIn("echo $v $w", text)

    def test_a_fence_loses_what_only_tests_read(self):
        self.assertEqual(maths.with_marks("```sh slow\nls\n```\n")[0], "```sh\nls\n```\n")

    def test_every_formula_of_the_pages_is_mathml(self):
        n = 0
        for page in sorted((SOURCE / "docs").rglob("*.md")):
            for formula in maths.with_marks(page.read_text(encoding="utf-8"))[1].values():
                tree.fromstring(formula)
                n += 1
        self.assertGreater(n, 150)


if __name__ == "__main__":
    unittest.main()

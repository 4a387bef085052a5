"""What holds of every public name: a sentence, types, an example that runs, and a test that uses it."""
import doctest
import inspect
import os
import pathlib
import pickle
import re
import tempfile
import unittest
import warnings

import numpy as np
import pandas as pd
import rimpact

os.environ["RIMPACT_PROGRAM"] = os.environ["RIMPACT"]
HERE = pathlib.Path(__file__)
# Examples that are shown and not run: they need finite elements or a study's records; tests run them by stand-ins and small studies.
SHOWN_ONLY = {"run", "geometry", "reliability", "Reliability"}


def public():
    """Name and object of what a user calls; exceptions are raised by what is called."""
    for name in rimpact.__all__:
        each = getattr(rimpact, name)
        if not (inspect.isclass(each) and issubclass(each, BaseException)):
            yield name, each


def callables(name, each):
    """A function itself; of a class its constructor and its public methods, where they are its own."""
    if not inspect.isclass(each):
        yield name, each
        return
    for key, member in vars(each).items():
        function = member.__func__ if isinstance(member, staticmethod | classmethod) else member.fget if isinstance(member, property) else member
        if inspect.isfunction(function) and (not key.startswith("_") or key == "__call__"):
            yield f"{name}.{key}", function
    if "__init__" in vars(each):
        yield f"{name}.__init__", each.__init__


class Public(unittest.TestCase):
    def test_every_name_is_there_and_sorted(self):
        self.assertEqual(list(rimpact.__all__), sorted(rimpact.__all__))
        for name in rimpact.__all__:
            self.assertTrue(hasattr(rimpact, name), name)

    def test_every_argument_and_result_has_a_type(self):
        for name, each in public():
            for place, function in callables(name, each):
                signature = inspect.signature(function)
                for parameter in list(signature.parameters.values())[1 if "." in place and "self" in signature.parameters else 0:]:
                    self.assertIsNot(parameter.annotation, inspect.Parameter.empty, f"{place}: {parameter.name} has no type")
                self.assertIsNot(signature.return_annotation, inspect.Signature.empty, f"{place}: its result has no type")

    def test_every_one_says_what_it_is(self):
        for name, each in public():
            for place, function in [(name, each), *callables(name, each)]:
                if not place.endswith(("__init__", "__call__")):
                    self.assertTrue(re.match(r"\S.{6,}", inspect.getdoc(function) or ""), f"{place} has no sentence")

    def test_every_one_has_a_test(self):
        tests = "".join(file.read_text(encoding="utf-8") for file in HERE.parent.glob("test_*.py") if file != HERE)
        for name, _ in public():
            self.assertTrue(re.search(rf"\brimpact\.{name}\b", tests), f"no file of tests/python uses rimpact.{name}")

    def test_every_one_has_an_example_and_it_holds(self):
        skipped = set()
        for name, each in public():
            examples = [found for found in doctest.DocTestFinder(recurse=False).find(each, name) if found.examples]
            self.assertTrue(examples, f"{name} has no example (>>>)")
            for test in examples:
                if any(example.options.get(doctest.SKIP) for example in test.examples):
                    skipped.add(name)
                test.globs = {"rimpact": rimpact, "np": np, "pd": pd, "pickle": pickle}
                self.expect_holds(name, test)
        self.assertEqual(skipped, SHOWN_ONLY)

    def expect_holds(self, name, test):
        said = []
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)
            os.chdir(folder)
            try:
                result = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE).run(test, out=said.append)
            finally:
                os.chdir(before)
        self.assertEqual(result.failed, 0, f"{name}: {''.join(said)}")

    def test_the_page_names_every_one(self):
        page = (pathlib.Path(os.environ["RIMPACT_SOURCE"]) / "docs/python.md").read_text(encoding="utf-8")
        for name, _ in public():
            self.assertTrue(re.search(rf"rimpact\.{name}\b|`{name}`", page), f"docs/python.md does not name {name}")


if __name__ == "__main__":
    unittest.main()

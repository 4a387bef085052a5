"""The site is built without a warning, and every page is in its menu."""
import os
import re
import shutil
import subprocess
import tempfile
import unittest

SOURCE = os.environ["RIMPACT_SOURCE"]


class Site(unittest.TestCase):
    def test_every_page_is_in_the_menu(self):
        with open(os.path.join(SOURCE, "mkdocs.yml"), encoding="utf-8") as file:
            menu = set(re.findall(r"[\w./-]+\.md", file.read()))
        docs = os.path.join(SOURCE, "docs")
        pages = {os.path.relpath(os.path.join(place, name), docs) for place, _, names in os.walk(docs) for name in names if name.endswith(".md")}
        pages = {page for page in pages if not re.fullmatch(r"changes/.*\.(highlight|breaking|added|fixed)\.md", page)}  # they wait for the changelog
        self.assertEqual(pages - menu, set())
        self.assertEqual(menu - pages, set())

    @unittest.skipUnless(shutil.which("mkdocs"), "mkdocs is not installed")
    def test_it_is_built_without_a_warning(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(["mkdocs", "build", "--strict", "--site-dir", folder], cwd=SOURCE, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertNotIn("WARNING", done.stdout + done.stderr)
            self.assertTrue(os.path.isfile(os.path.join(folder, "tutorial", "index.html")))
            for place, _, names in os.walk(folder):
                for name in names:
                    if name.endswith(".html"):
                        with open(os.path.join(place, name), encoding="utf-8") as file:
                            text = file.read()
                        self.assertNotRegex(text, r"```|\$\$|<code>(sh|text|python|toml) ?\w*\n", name)
                        self.assertNotRegex(text, r'(src|href)="https?://(?!www\.mkdocs\.org)[^"]*\.(js|css)"', name)


if __name__ == "__main__":
    unittest.main()

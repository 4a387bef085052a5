#!/usr/bin/env python3
"""Checks the README and docs/: relative links and named files exist, and every verb shown is one the command has."""
import pathlib
import re
import subprocess
import sys

LINK = re.compile(r"\]\(([^)#]+)\)")
VERB = re.compile(r"^\s*(?:build/release/bin/rimpact|\$rimpact|rimpact)\s+([a-z]+)", re.MULTILINE)
FILE = re.compile(r"`((?:examples|python|files|records|scene|responses|planning|meshes|fe_contact|reduced_models|buildings|fleets|reliability|risk|calibration"
                  r"|data|report|app|tests|docs|cmake)/[\w./]*)`")


def main(folder: str, program: str) -> int:
    root = pathlib.Path(folder)
    pages = [root / "README.md", root / "CONTRIBUTING.md", root / "CHANGELOG.md", *sorted((root / "docs").rglob("*.md")),
             *sorted((root / "examples").rglob("*.md"))]
    listing = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
    verbs = set(re.findall(r"^  ([a-z-]+) ", listing, re.MULTILINE))
    errors, n_checked = list[str](), 0
    for page in pages:
        text = page.read_text(encoding="utf-8")
        links = [(target, page.parent / target) for target in LINK.findall(text) if "://" not in target]
        to_be_made = set(re.findall(r"^New file `([^`]+)`", text, re.MULTILINE))
        links += [(target, root / target) for target in FILE.findall(text) if "NAME" not in target and target not in to_be_made]
        shown = VERB.findall(text)
        errors += [f"{page.name}: {target} does not exist" for target, path in links if not path.exists()]
        errors += [f"{page.name}: rimpact has no verb {verb}" for verb in shown if verb not in verbs]
        n_checked += len(links) + len(shown)
    print("\n".join(errors) or f"{n_checked} links, files and verbs in {len(pages)} pages are there")
    return 1 if errors or n_checked < 20 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

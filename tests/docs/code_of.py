#!/usr/bin/env python3
"""Writes the cpp blocks below a heading of a page into one file: code_of.py PAGE HEADING OUTPUT."""
import pathlib
import re
import sys

page, heading, output = sys.argv[1:]
sections = re.split(r"^#+ +", pathlib.Path(page).read_text(encoding="utf-8"), flags=re.MULTILINE)
found = [section for section in sections if section.startswith(heading + "\n")]
blocks = re.findall(r"^```cpp\n(.*?)^```", found[0] if found else "", re.MULTILINE | re.DOTALL)
if not blocks:
    sys.exit(f"{page} holds no cpp block below {heading}")
pathlib.Path(output).write_text("\n".join(blocks), encoding="utf-8")

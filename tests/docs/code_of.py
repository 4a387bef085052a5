#!/usr/bin/env python3
"""Writes the cpp blocks of a page into one file: code_of.py PAGE OUTPUT."""
import pathlib
import re
import sys

page, output = map(pathlib.Path, sys.argv[1:])
blocks = re.findall(r"^```cpp\n(.*?)^```", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
if len(blocks) < 2:
    sys.exit(f"{page} holds {len(blocks)} cpp blocks")
output.write_text("\n".join(blocks), encoding="utf-8")

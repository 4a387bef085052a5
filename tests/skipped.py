#!/usr/bin/env python3
"""What a run of the tests left out, counted by its reason: the last lines of ./test.

usage: skipped.py JUNIT.xml (CTest's --output-junit)"""
import collections
import re
import sys
import xml.etree.ElementTree as ElementTree

#: How CTest's programs, unittest and GoogleTest say that something is left out.
SAID = re.compile(r"^skipped: (.+)$|\.\.\. skipped ['\"](.+)['\"]$", re.MULTILINE)
GOOGLE_TEST = re.compile(r"(?:Skipped\n|: Skipped\s+)(.+)")


def reasons(case: ElementTree.Element) -> list[str]:
    """Of one CTest entry, which may hold many tests."""
    text = case.findtext("system-out") or ""
    found = [one or other for one, other in SAID.findall(text)]
    if not found and case.find("skipped") is not None:
        said = GOOGLE_TEST.search(text)
        found = [said.group(1).strip() if said else "no reason is printed"]
    return found


def main(path: str) -> int:
    left_out = collections.defaultdict[str, list[str]](list)
    for case in ElementTree.parse(path).iter("testcase"):
        for reason in reasons(case):
            left_out[reason].append(case.get("name", "?"))
    print(f"Skipped: {sum(map(len, left_out.values()))}")
    for reason, names in sorted(left_out.items()):
        shown = ", ".join(dict.fromkeys(names))
        print(f"  {len(names)} x {reason} ({shown})")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))

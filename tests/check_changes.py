#!/usr/bin/env python3
"""Every key, option, signal, column and file that is new or gone since the last release is named by a file of docs/changes/.

usage: check_changes.py ROOT [--release]; --release notes the names of now in docs/changes/interface.txt
"""
import pathlib
import re
import sys

KINDS = ("highlight", "breaking", "added", "fixed")
NOT_A_CHANGE = ("README.md", "interface.txt", "template.jinja")


def names_in_table(page: str) -> list[str]:
    """First cells that are code."""
    return re.findall(r"^\| `([^`]+)` \|", page, re.MULTILINE)


def options(page: str) -> list[str]:
    """`VERB --option` of every verb of a page made from --help."""
    found = []
    for section in re.split(r"^## ", page, flags=re.MULTILINE)[1:]:
        verb = section.split("\n", 1)[0].strip()
        for line in re.findall(r"^ +(?:-\w,)?(--[^\s]+)", section, re.MULTILINE):
            found += [f"{verb} {option}" for option in re.findall(r"--[a-z][a-z-]*", line)]
    return found


def interface(root: pathlib.Path) -> set[str]:
    pages = {path.stem: path.read_text(encoding="utf-8") for path in (root / "docs/reference").glob("*.md")}
    names = {name for page in pages.values() for name in names_in_table(page)}
    return names | {option for stem, page in pages.items() if stem.startswith("verbs") for option in options(page)}


def changes(root: pathlib.Path) -> dict[str, str]:
    return {path.name: path.read_text(encoding="utf-8") for path in sorted((root / "docs/changes").iterdir()) if path.name not in NOT_A_CHANGE}


def is_named(name: str, text: str) -> bool:
    """Whether the text holds the name, the option without its verb, or the last part of a key, as a word of its own."""
    short = name.split()[-1] if "--" in name else name.rsplit(".", 1)[-1]
    return any(re.search(rf"(?<![\w-]){re.escape(word)}(?![\w-])", text) for word in (name, short))


def faults(root: pathlib.Path) -> list[str]:
    released = set((root / "docs/changes/interface.txt").read_text(encoding="utf-8").splitlines())
    now, files = interface(root), changes(root)
    said = [f"docs/changes/{name}: a change is NAME.KIND.md with a KIND of {', '.join(KINDS)}" for name in files
            if not re.fullmatch(rf"[a-z0-9-]+\.({'|'.join(KINDS)})\.md", name)]
    everything = "\n".join(files.values())
    breaking = "\n".join(text for name, text in files.items() if ".breaking." in name)
    said += [f"{name} is new since the release, and no file of docs/changes/ names it" for name in sorted(now - released) if not is_named(name, everything)]
    said += [f"{name} is gone since the release, and no .breaking.md of docs/changes/ names it" for name in sorted(released - now) if not is_named(name, breaking)]
    return said


def main(where: str, *options: str) -> int:
    root = pathlib.Path(where)
    if "--release" in options:
        (root / "docs/changes/interface.txt").write_text("\n".join(sorted(interface(root))) + "\n", encoding="utf-8")
        return 0
    said = faults(root)
    print("\n".join(said) or f"{len(changes(root))} changes name what is new or gone among {len(interface(root))} names of the interface")
    return bool(said)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

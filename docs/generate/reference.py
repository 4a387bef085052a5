#!/usr/bin/env python3
"""Writes docs/reference/ from what the command says of itself.

    python3 docs/generate/reference.py build/release/bin/rimpact            writes the pages
    python3 docs/generate/reference.py build/release/bin/rimpact --check    fails where a page differs
"""
import json
import pathlib
import re
import subprocess
import sys
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from write_or_compare import write_or_compare

HEAD = "<!-- Made by docs/generate/reference.py; do not edit. -->\n"
SECTIONS = (("bearing.", "Bearing", "In a bearing file without `bearing.`; in a scene under `[bearing]`."), ("load.", "Load", ""),
            ("excitation.", "Excitation", ""), ("model.", "Finite-element model", ""), ("reduced.", "Reduced model", ""),
            ("isolator.", "Bearing of rigid bodies", "Read by the reduced models `dcfp`, `lir-dcfp` and `tfp`. A building reads four of them for its dishes too: `points`, "
             "`contact_stiffness_kN_per_m`, `contact_restitution` and `step_tolerance`. "
             "It does so under an inelastic frame, beside bearings of rigid bodies and with friction `coulomb`: "
             "there every dish stands on a spring of `points` times `contact_stiffness_kN_per_m` ([guide](../guide/buildings.md#what-a-dish-stands-on))."),
            ("bounds.", "Bounds of friction", "Read by `--bounds` of `reduced` and `building` ([guide](../guide/friction.md))."),
            ("superstructure.", "Superstructure", ""))


class Command:
    def __init__(self, program: str) -> None:
        self.program = program

    def text(self, *words: str) -> str | None:
        done = subprocess.run([self.program, *words], capture_output=True, text=True, check=False)
        return done.stdout if done.returncode == 0 else None

    def listing(self, what: str) -> Any:
        return json.loads(self.text("list", what, "--json") or "")

    def verbs(self) -> list[str]:
        return re.findall(r"^  ([a-z]+) ", (self.text("--help") or "").split("Subcommands:")[1], re.MULTILINE)


def cell(text: str) -> str:
    return text.replace("|", "\\|").replace("\n", " ")


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(cell(each) for each in row) + " |" for row in rows]) + "\n"


def code(text: str) -> str:
    return f"`{text}`" if text else ""


def key_rows(keys: Iterable[dict[str, Any]]) -> Iterator[tuple[str, ...]]:
    for key in keys:
        preset = key["default"].replace("\n", "")
        meaning = key["meaning"] + (" *(assumption)*" if key["assumption"] else "") + (f"; when {key['when']}" if key["when"] else "")
        is_value = key["kind"] == "text" or not re.search(r"[a-z] [a-z(]", preset)
        yield code(key["key"]), key["unit"], code(preset) if is_value else preset, key["range"], meaning


def keys_page(command: Command) -> str:
    listed = command.listing("keys")
    text = ("# Keys of TOML files\n\nA file's numbers are in the unit that its key's name ends in. An unknown key, a wrong type or a "
            "value out of range is an error with file, line, column and bound. *Assumption*: no source gives the built-in bearing's value; "
            "replace it by yours. `rimpact list keys` prints the same, `--json` for programs.\n")
    head = ("key", "unit", "default", "range", "meaning")
    plain = [key for key in listed["keys"] if not key["key"].startswith(tuple(prefix for prefix, *_ in SECTIONS))]
    text += "\n## Scene\n\n" + table(head, key_rows(plain))
    for prefix, title, note in SECTIONS:
        found = [key for key in listed["keys"] if key["key"].startswith(prefix)]
        text += f"\n## {title}\n\n" + (note + "\n\n" if note else "") + table(head, key_rows(found))
    for file in listed["files"]:
        text += f"\n## {file['title']}\n\n{file['note']}\n\n" + table(head, key_rows(listed[file["keys"]]))
    return text


RESULTS = {"calibrate", "compare", "study", "geometry", "design-page", "report", "export", "list", "references", "thesis", "design", "reliability", "version", "help", "completion"}


def verbs_page(command: Command) -> str:
    others = ", ".join(f"[{verb}](verbs-results.md#{verb})" for verb in command.verbs() if verb in RESULTS)
    return helps(command, "Verbs", f"These lead to runs. Those that make something of runs stand apart: {others}.", [verb for verb in command.verbs() if verb not in RESULTS])


def result_verbs_page(command: Command) -> str:
    return helps(command, "Verbs that make something of runs", "Verbs that lead to runs: [verbs](verbs.md).", [verb for verb in command.verbs() if verb in RESULTS])


def helps(command: Command, title: str, lead: str, verbs: Iterable[str]) -> str:
    text = f"# {title}\n\nWhat `rimpact VERB --help` prints. {lead} Data go to stdout, messages to stderr.\n"
    for verb in verbs:
        help_text = command.text(verb, "--help")
        if help_text is None:
            raise SystemExit(f"rimpact {verb} --help does not work here: the reference needs a build with finite elements")
        text += f"\n## {verb}\n\n```text\n{help_text.strip()}\n```\n"
    return text


def named(command: Command, what: str) -> list[tuple[str, str]]:
    return list(command.listing(what)[what].items())


def results_page(command: Command) -> str:
    signals = [(code(name), *text.split(": ", 1)) for name, text in named(command, "signals")]
    columns = [(code(name), code(text.split()[0]), "read only" if "read only" in text else "written") for name, text in named(command, "columns")]
    return ("# Files, signals and columns\n\n## Files\n\n" + table(("file", "holds"), [(code(name), text) for name, text in named(command, "files")]) +
            "\n## Signals\n\nData sets of `response.h5` under `/response`, and columns of `rimpact.load(folder).response`. Signs: "
            "[interface](../interface.md).\n\n" + table(("signal", "unit", "meaning"), signals) +
            "\n## Columns of response.csv\n\n" + table(("column", "signal", ""), columns))


def choices_page(command: Command) -> str:
    text = "# Laws, models, rungs, scenes, bearings, exit codes\n"
    for what, title in (("laws", "Impact laws"), ("models", "Reduced models"), ("rungs", "Rungs"), ("scenes", "Built-in scenes"),
                        ("bearings", "Built-in bearings"), ("materials", "Materials"), ("exit-codes", "Exit codes")):
        text += f"\n## {title}\n\n" + table(("name", "what it is"), [(code(name), words) for name, words in named(command, what)])
    return text


PAGES = {"keys.md": keys_page, "verbs.md": verbs_page, "verbs-results.md": result_verbs_page, "results.md": results_page, "choices.md": choices_page}


def main(program: str, *options: str) -> int:
    command, folder = Command(program), pathlib.Path(__file__).resolve().parents[1] / "reference"
    light, made = command.text("run", "--help") is None, dict[pathlib.Path, str]()
    for name, page in PAGES.items():
        if light and name.startswith("verbs") and "--check" in options:
            print(f"{name} is not checked: this build has no finite-element side")
            continue
        made[folder / name] = HEAD + page(command)
    return write_or_compare(made, options, "the command says; run docs/generate/reference.py")


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

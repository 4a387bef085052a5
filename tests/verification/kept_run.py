"""A run of the program, made unless its folder holds it already."""
import json
import os
import pathlib
import subprocess
from collections.abc import Sequence
from typing import Any

WINDOW_ON_THE_DISH = ['excitation.with=["weight","friction"]', "excitation.duration_s=0.06"]  # settings of impact-window


def kept_run(program: str, verb: str, scene: str, folder: str | pathlib.Path, settings: Sequence[str] = (), options: Sequence[str] = ()) -> Any:
    """The run's summary. What an older build left behind is made again, unless RIMPACT_KEEP_RUNS is set."""
    summary = pathlib.Path(folder) / "summary.json"
    if not (is_kept(summary, program) and json.loads(summary.read_text())["status"] == "done"):
        subprocess.run(command(program, verb, scene, folder, settings, options), check=True, stdout=subprocess.DEVNULL)
    return json.loads(summary.read_text())


def command(program: str, verb: str, scene: str, folder: str | pathlib.Path, settings: Sequence[str] = (), options: Sequence[str] = ()) -> list[str]:
    return [program, verb, scene, "-o", str(folder), "--quiet", *options, *(word for setting in settings for word in ("--set", setting))]


def is_kept(file: pathlib.Path, program: str) -> bool:
    """Whether the file is there and younger than the program."""
    if not file.exists():
        return False
    built = max(os.path.getmtime(file) for file in pathlib.Path(program).parent.glob("rimpact*"))
    return bool(os.environ.get("RIMPACT_KEEP_RUNS")) or file.stat().st_mtime > built


def gate(failures: list[str], what: str, value: float, bound: float) -> None:
    if not abs(value) < bound:
        failures.append(f"MISSED {what}: {value:.3g} is not below {bound}")


def finish(folder: pathlib.Path, lines: Sequence[str], failures: Sequence[str]) -> int:
    """Prints the table with what was missed, keeps it as FOLDER/baseline.txt; the script's exit code."""
    text = "\n".join([*lines, *failures]) + "\n"
    print(text)
    (folder / "baseline.txt").write_text(text)
    return 1 if failures else 0

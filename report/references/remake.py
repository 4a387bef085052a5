"""Makes references again by rimpact's own verbs, and says what each cost and what moved since it was kept."""
import json
import os
import subprocess
from dataclasses import dataclass
from typing import Any

from ..child import run_child
from ..data_files import read_any_json
from ..errors import DataError
from ..numbers import sig
from .kept import Reference


@dataclass(frozen=True)
class Remade:
    """A reference beside its run of today. Without a run, `problem` says why."""
    reference: Reference
    folder: str
    problem: str = ""
    summary: dict[str, Any] | None = None
    moved: dict[str, Any] | None = None  #: of `rimpact compare`, the kept run first

    def as_json(self) -> dict[str, Any]:
        now, moved = self.summary or {}, self.moved or {}
        return {"name": self.reference.name, "folder": self.folder, "problem": self.problem, "kept_peak_impact_force_N": self.reference.summary["peak_impact_force_N"],
                "kept_wall_time_s": self.reference.wall_time_s, "peak_impact_force_N": now.get("peak_impact_force_N"), "wall_time_s": now.get("wall_time_s"),
                "processor_time_s": now.get("processor_time_s"), "imbalance_relative": now.get("energy", {}).get("imbalance_relative"),
                "peak_force_error": moved.get("peak_force_error"), "rebound_error": moved.get("rebound_error"),
                "touch_time_difference_s": moved.get("touch_time_difference_s")}


def remake(reference: Reference, program: str, output: str, quiet: bool) -> Remade:
    """Goes on from a checkpoint, and leaves a run that has ended as it is."""
    folder = os.path.join(output, reference.name)
    resume = ["--resume"] if os.path.isdir(folder) else []
    words = [program, "run", reference.scene, "-o", folder, "--no-fields", *resume, *(["--quiet"] if quiet else [])]
    done = run_child(words, stdout=subprocess.DEVNULL, stderr=None)
    if done.returncode != 0:
        return Remade(reference, folder, f"its run ended with {done.returncode}")
    compared = run_child([program, "compare", reference.folder, folder, "--json"])
    if compared.returncode != 0:
        raise DataError(f"{folder} cannot be held against {reference.folder}: {compared.stderr.strip()}")
    return Remade(reference, folder, "", read_any_json(os.path.join(folder, "summary.json")), json.loads(compared.stdout))


def list_text(known: list[Reference]) -> str:
    """What is kept, and what making it again costs."""
    lines = [f"{'reference':22} {'rung':11} mesh {'peak':>10} {'when kept':>10}"]
    lines += [f"{r.name:22} {r.summary['rung']:11} {r.summary['mesh']:4} {r.peak_kN:7.1f} kN {_minutes(r.wall_time_s):>10}" for r in known]
    return "\n".join([*lines, "", f"{_minutes(sum(r.wall_time_s for r in known))} in all, on the machines of their days"])


def moved_text(remade: list[Remade]) -> str:
    """What each cost, and how far today's run is from the kept one."""
    lines = [f"{'reference':22} {'peak':>10} {'moved':>8} {'rebound':>8} {'touch':>9} {'imbalance':>9} {'wall time':>9} {'kept':>8}"]
    for each in remade:
        row = each.as_json()
        if each.problem:
            lines.append(f"{row['name']:22} {each.problem}: {each.folder}")
            continue
        percent = lambda key, row=row: "-" if row[key] is None else f"{100 * row[key]:+.2f} %"
        touch = "-" if row["touch_time_difference_s"] is None else f"{1e3 * row['touch_time_difference_s']:+.2f} ms"
        lines.append(f"{row['name']:22} {1e-3 * row['peak_impact_force_N']:7.1f} kN {percent('peak_force_error'):>8} {percent('rebound_error'):>8} {touch:>9} "
                     f"{sig(row['imbalance_relative'], 1):>9} {_minutes(row['wall_time_s']):>9} {_minutes(row['kept_wall_time_s']):>8}")
    return "\n".join(lines)


def _minutes(seconds: float) -> str:
    return f"{seconds / 60:.1f} min" if seconds >= 90 else f"{seconds:.0f} s"

"""Studies of speed against error that are kept with the program (data/studies)."""
import json
import pathlib
from typing import Any

FOLDER = pathlib.Path(__file__).resolve().parents[1] / "data" / "studies"


def cost_of(row: dict[str, Any]) -> float:
    """Processor time of a run [s]; wall time where that was not measured: of the reduced model, which takes a moment, and of former studies."""
    return row.get("processor_time_s") or row["wall_time_s"]


def cost_name(rows: list[dict[str, Any]]) -> str:
    return "processor time" if any(row.get("processor_time_s") for row in rows) else "wall time"


def of_all_rungs(bearing: str) -> dict[str, dict[str, Any]]:
    """Those of a bearing that compare rungs, by the names of their scenes: from the reduced model to the whole bearing."""
    studies = [json.loads(file.read_text()) for file in sorted(FOLDER.glob("*.json"))]
    return {study["scene"]["name"]: study for study in studies
            if study["scene"]["bearing"] == bearing and {"reduced", "full"} <= {row["rung"] for row in study["rows"]}}

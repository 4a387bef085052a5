"""Studies of speed against error that are kept with the program (data/studies)."""
import json
import pathlib
from typing import Any

FOLDER = pathlib.Path(__file__).resolve().parents[1] / "data" / "studies"


def of_all_rungs(bearing: str) -> dict[str, dict[str, Any]]:
    """Those of a bearing that compare rungs, by the names of their scenes: from the reduced model to the whole bearing."""
    studies = [json.loads(file.read_text()) for file in sorted(FOLDER.glob("*.json"))]
    return {study["scene"]["name"]: study for study in studies
            if study["scene"]["bearing"] == bearing and {"reduced", "full"} <= {row["rung"] for row in study["rows"]}}

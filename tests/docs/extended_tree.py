"""What docs/extending.md adds "in a tree of your own" is added to a copy of the tree, which is built and run.

usage: extended_tree.py ON|OFF   with finite elements, or without"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(os.environ["RIMPACT_SOURCE"])
HEADING = "## In a tree of your own\n"
PIECE = re.compile(r"^(?:New file `(?P<new>[^`]+)`|In `(?P<file>[^`]+)` after `(?P<after>[^`]+)`|At the end of `(?P<end>[^`]+)`):\n"
                   r"```\w+\n(?P<text>.*?)^```", re.MULTILINE | re.DOTALL)


def extended(tree: pathlib.Path) -> int:
    """Adds every piece of the page to the tree; their number."""
    text = (SOURCE / "docs/extending.md").read_text(encoding="utf-8").split(HEADING)[1]
    pieces = list(PIECE.finditer(text))
    for piece in pieces:
        name = piece["new"] or piece["file"] or piece["end"]
        path = tree / name
        if piece["new"]:
            path.write_text(piece["text"], encoding="utf-8")
            continue
        old = path.read_text(encoding="utf-8")
        if piece["end"]:
            path.write_text(old + "\n" + piece["text"], encoding="utf-8")
            continue
        if old.count(piece["after"]) < 1:
            sys.exit(f"docs/extending.md: {name} holds no \"{piece['after']}\"")
        path.write_text(old.replace(piece["after"], piece["after"] + piece["text"].rstrip("\n"), 1), encoding="utf-8")
    return len(pieces)


def run(tree: pathlib.Path, *words: str) -> str:
    done = subprocess.run([tree / "built/bin/rimpact", *words], cwd=tree, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"rimpact {' '.join(words)} ended with {done.returncode}:\n{done.stderr}")
    return done.stdout


def peak(tree: pathlib.Path, *settings: str) -> dict:
    words = [word for setting in settings for word in ("--set", setting)]
    return json.loads(run(tree, "reduced", "impact-window", *words, "--json", "-o", "out", "--force"))


def rubbed(tree: pathlib.Path, rung: str) -> float:
    """What friction takes of a pulse on its way up [J]."""
    words = ("--rung", rung, "--mesh", "0", "--set", "excitation.duration_s=0.25", "--set", "excitation.centre_s=0.2", "--no-fields", "--json")
    summary = json.loads(run(tree, "run", "ricker-0.78g-1.0s", *words, "-o", f"out-{rung}"))
    assert (summary["rung"], summary["status"]) == (rung, "done"), summary
    return summary["energy"]["friction_J"]


def main(solids: str) -> None:
    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder) / "tree"
        shutil.copytree(SOURCE, tree, symlinks=True, ignore=shutil.ignore_patterns("build", "results", ".git", "__pycache__", "node_modules"))
        if extended(tree) < 25:
            sys.exit("docs/extending.md adds less than it did")
        off = [f"-DRIMPACT_FE={solids}", *(f"-DRIMPACT_{part}=OFF" for part in ("TESTS", "PYTHON", "BENCHMARKS", "NATIVE"))]
        for command in (["cmake", "-S", tree, "-B", tree / "built", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DRIMPACT_UNITY=ON", *off],
                        ["cmake", "--build", tree / "built", "--target", "rimpact", "--parallel", "2"]):
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                sys.exit(f"{' '.join(map(str, command))}:\n{done.stdout[-6000:]}\n{done.stderr[-3000:]}")
        assert run(tree, "hello", "you") == "hello you\n"
        assert "rimpact hello you" in run(tree, "help", "hello")
        assert "stiffening" in json.loads(run(tree, "list", "laws", "--json"))["laws"]
        keys = {key["key"]: key for key in json.loads(run(tree, "list", "keys", "--json"))["keys"]}
        assert keys["reduced.mu_breakaway"]["meaning"].startswith("b: friction at rest")
        linear, stiff = (peak(tree, f'reduced.impact_law="{law}"')["peak_impact_force_N"] for law in ("no-tension", "stiffening"))
        assert stiff > 0 and abs(stiff / linear - 1) > 0.05, (stiff, linear)
        pulse = [json.loads(run(tree, "reduced", "ricker-0.78g-1.0s", "--set", f"reduced.mu_breakaway={b}", "--json", "-o", "out", "--force")) for b in (0, 3)]
        assert pulse[1]["peak_displacement_m"] != pulse[0]["peak_displacement_m"]
        assert "fig-4-99" in run(tree, "thesis", "list")
        if solids == "ON":
            smooth, rough = (rubbed(tree, rung) for rung in ("smooth", "rigid-dish"))
            assert smooth == 0 < rough, (smooth, rough)
    print("the tree of docs/extending.md: a law, a factor of friction, a rung, a verb and a figure")


if __name__ == "__main__":
    main(sys.argv[1])

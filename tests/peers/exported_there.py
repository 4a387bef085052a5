"""The files of `rimpact export --opensees`, done by OpenSees: the Python one as it is, the Tcl one by tclsh, which hands every command of OpenSees on."""
import pathlib
import runpy
import subprocess
from typing import Any, Protocol

import openseespy.opensees as ops

COMMANDS = ("uniaxialMaterial", "element", "frictionModel", "node", "equalDOF", "fix", "geomTransf", "nodeCoord", "mass")


class Export(Protocol):
    """What a file gives: its numbers by name, and its procedures."""

    def number(self, name: str) -> float: ...
    def make(self, procedure: str, *arguments: int | str) -> None: ...


class PythonFile:
    def __init__(self, file: pathlib.Path) -> None:
        self.values = runpy.run_path(str(file))

    def number(self, name: str) -> float:
        return float(self.values[name])

    def make(self, procedure: str, *arguments: int | str) -> None:
        self.values[procedure](ops, *arguments)


class TclFile:
    """tclsh reads the file and does its procedures; each command of OpenSees is a line that this side does and answers."""

    def __init__(self, file: pathlib.Path) -> None:
        stubs = "".join(f"proc {name} {{args}} {{puts \"{name} $args\"; flush stdout; gets stdin}}\n" for name in COMMANDS)
        loop = stubs + "while {[gets stdin line] >= 0} {if {[catch $line answer]} {puts \"error $answer\"} else {puts \"done $answer\"}; flush stdout}"
        self.process = subprocess.Popen(["tclsh"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.say(loop)
        self.do(f"source {{{file}}}")

    def say(self, line: str) -> None:
        assert self.process.stdin
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def do(self, line: str) -> str:
        assert self.process.stdout
        self.say(line)
        while True:
            kind, _, rest = self.process.stdout.readline().rstrip("\n").partition(" ")
            if kind == "done":
                return rest
            if kind not in COMMANDS:
                raise RuntimeError(f"tclsh: {kind} {rest}")
            answer = getattr(ops, kind)(*(number_or_word(word) for word in rest.split()))
            self.say(" ".join(map(repr, answer)) if isinstance(answer, list) else "")

    def number(self, name: str) -> float:
        return float(self.do(f"set {name}"))

    def make(self, procedure: str, *arguments: int | str) -> None:
        self.do(" ".join(map(str, (procedure, *arguments))))

    def close(self) -> None:
        assert self.process.stdin and self.process.stdout
        self.process.stdin.close(), self.process.stdout.close()
        self.process.wait()


def number_or_word(word: str) -> Any:
    for kind in (int, float):
        try:
            return kind(word)
        except ValueError:
            pass
    return word

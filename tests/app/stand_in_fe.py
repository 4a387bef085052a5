#!/usr/bin/python3
"""Stands in for rimpact-fe in the tests of `main`: the reduced model with a pair the test knows, in no time. Of the
finite elements it says nothing. Environment: STAND_IN_FAIL (a run's name that stops, or *), STAND_IN_SLEEP (seconds a run takes),
STAND_IN_REFUSE (set: no checkpoint is taken), STAND_IN_LOG (a file that lists the command lines, of curves with the threads they may take),
STAND_IN_TRACE (a file that lists begins and ends), STAND_IN_DOUBT (a run's name whose summary warns)."""
import json
import os
import subprocess
import sys
import tempfile
import time
import tomllib

PAIR = {"reduced.k_i_kN_per_m": 2.0e5, "reduced.restitution": 0.4}
STIFFNESS = 6e6  #: of curves [N/m^0.4]
FASTER = 1.21  #: k_i of steel that knows its rate, over that of static steel: the peak force rises by a tenth


def trace(word: str) -> None:
    if "STAND_IN_TRACE" in os.environ:
        with open(os.environ["STAND_IN_TRACE"], "a") as file:
            file.write(word + "\n")


def doubt(folder: str) -> None:
    path = os.path.join(folder, "summary.json")
    with open(path) as file:
        summary = json.load(file)
    with open(path, "w") as file:
        json.dump({**summary, "warnings": summary.get("warnings", []) + ["the test doubts this run"]}, file)


def run(arguments: list[str]) -> int:
    scene, folder = arguments[1], arguments[arguments.index("-o") + 1]
    if "STAND_IN_LOG" in os.environ:
        with open(os.environ["STAND_IN_LOG"], "a") as log:
            log.write(" ".join(arguments) + "\n")
    if "--resume" in arguments and "STAND_IN_REFUSE" in os.environ:
        print(f"error: {folder}/checkpoint.h5 belongs to another run: the test says so; run without --resume to start afresh", file=sys.stderr)
        return 3
    trace("begin")
    time.sleep(float(os.environ.get("STAND_IN_SLEEP", "0")))
    trace("end")
    if os.environ.get("STAND_IN_FAIL") in ("*", os.path.basename(folder)):
        print("error: the solver stopped because the test asked for it", file=sys.stderr)
        return 4
    command = [os.environ["RIMPACT"], "reduced", scene, "-o", folder, "--force"]
    with open(scene) as file:
        stiffer = FASTER if "rate = " in file.read() else 1.0
    for key, value in PAIR.items():
        command += ["--set", f"{key}={value * (stiffer if 'k_i' in key else 1.0)}"]
    code = subprocess.run(command, stdout=subprocess.DEVNULL).returncode
    if code == 0:  # the scene as `main` asked for it, without the pair the reference has of its own
        with open(scene) as source, open(os.path.join(folder, "scene.toml"), "w") as target:
            target.write(source.read())
        note_identity(scene, folder)
        if os.environ.get("STAND_IN_DOUBT") == os.path.basename(folder):
            doubt(folder)
    return code


def curve(arguments: list[str]) -> int:
    """The curve of a rim whose force is STIFFNESS (thickness / 50 mm)^0.5 d^0.4 and whose strain is that depth over ten times its thickness."""
    import h5py
    import numpy as np
    scene, folder = arguments[1], arguments[arguments.index("-o") + 1]
    if "STAND_IN_LOG" in os.environ:
        with open(os.environ["STAND_IN_LOG"], "a") as log:
            log.write(" ".join([*arguments, "threads", os.environ.get("RIMPACT_THREADS", "all")]) + "\n")
    if os.environ.get("STAND_IN_FAIL") == os.path.basename(folder):
        print("error: the curve stopped because the test asked for it", file=sys.stderr)
        return 4
    with open(scene, "rb") as file:
        values = tomllib.load(file)
    thickness, mass = values["bearing"]["rim"]["thickness_mm"], values["load"]["mass_kg"]
    plan = subprocess.run([os.environ["RIMPACT"], "geometry", scene, "--dry-run", "--json"], capture_output=True, text=True, check=True).stdout
    said, speed = json.loads(plan), float(arguments[arguments.index("--speed") + 1])
    scale = STIFFNESS * (thickness / 50) ** 0.5
    depth = (1.4 * mass * speed**2 / 2 / scale) ** (1 / 1.4) * np.linspace(0, 1.01, 200) ** 2
    force = scale * depth**0.4
    os.makedirs(folder, exist_ok=True)
    with h5py.File(os.path.join(folder, "curve.h5"), "w") as file:
        file["held/loading/penetration"], file["held/loading/force"] = depth, force
        tops = [40, 80, 140, 199]
        file["held/unloading/branch"] = np.repeat([1.0, 2.0, 3.0, 4.0], 12)
        file["held/unloading/penetration"] = np.concatenate([np.linspace(depth[k], depth[k] - force[k] / 3e9, 12) for k in tops])
        file["held/unloading/force"] = np.concatenate([np.linspace(force[k], 0, 12) for k in tops])
        file["held/steel/penetration"], file["held/steel/strain"] = depth, depth / (0.01 * thickness)
        mesh = arguments[arguments.index("--mesh") + 1]
        for name, text in {"kind": "rim curve", "bearing": "stand-in", "rim_identity": said["bearing"]["rim_identity"], "rim_values": "",
                           "mesh": f"level {mesh}, 1 unknown", "made_by": said["made_by"], "mesh_force_error": "unknown", "left_out_rebound_error": "0.01"}.items():
            file.create_dataset(f"meta/{name}", data=text, dtype=h5py.string_dtype("utf-8"))
    return 0


def note_identity(scene: str, folder: str) -> None:
    """The identity of the scene as it was asked for, as the finite-element program would note it."""
    with tempfile.TemporaryDirectory() as plain:
        subprocess.run([os.environ["RIMPACT"], "reduced", scene, "-o", plain], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        with open(os.path.join(plain, "summary.json")) as file:
            identity = json.load(file)["identity"]
    with open(os.path.join(folder, "summary.json")) as file:
        summary = json.load(file)
    with open(os.path.join(folder, "summary.json"), "w") as file:
        json.dump({**summary, "identity": identity}, file)


if __name__ == "__main__":
    if sys.argv[1] == "version":
        print(json.dumps({"rimpact": "stand-in", "BLAS": "none"}))
        sys.exit(0)
    sys.exit(curve(sys.argv[1:]) if sys.argv[1] == "curve" else run(sys.argv[1:]))

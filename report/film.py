"""python3 -m report.film DIR [--output FILE.html] [--frames N]: a film of the longest stretch of stored fields of a run.

Frames stand at equal steps of time. Between stored instants displacements and stresses are interpolated linearly. FILE.html holds
the frames and plays them; FILE.mp4 is written beside it where ffmpeg is installed."""
import argparse
import io
import os
import shutil
import subprocess

import numpy as np

from . import page
from .blocks import Section, note
from .errors import DataError, IoError, run_main
from .files import remove, require_folder, write_whole
from .film_frames import Camera, read
from .run_folder import Run, load_run
from .sections.common import title_of
from .stored_fields import instants, said_of
from .style import embedded

LEAST = 5       #: stored instants of which a film is made
FRAMES = 32
FAR = 6.0       #: a gap between instants so many times the median ends a stretch


def longest(files: list[tuple[str, float | None]]) -> list[tuple[str, float]]:
    """The instants of the longest stretch in which times rise without a large gap; empty where there are fewer than LEAST."""
    timed = [(file, time) for file, time in files if time is not None]
    if len(timed) < LEAST:
        return []
    steps = np.diff([time for _, time in timed])
    rising = steps[steps > 0]
    if not len(rising):
        return []
    ends = np.flatnonzero((steps <= 0) | (steps > FAR * np.median(rising))) + 1
    stretches = [timed[a:b] for a, b in zip([0, *ends], [*ends, len(timed)])]
    best = max(stretches, key=len)
    return best if len(best) >= LEAST else []


def make(run: Run, output: str, n_frames: int = FRAMES) -> list[str]:
    """Writes the film; gives the files. Empty where the run holds fewer than LEAST instants in one stretch."""
    files = longest(instants(run))
    if not files:
        return []
    stretch = read(files)
    times = np.linspace(stretch.times[0], stretch.times[-1], n_frames)
    camera = Camera(stretch, run)
    frames = [camera.frame(float(time)) for time in times]
    _write_page(run, output, times, frames, len(files))
    return [output, *_write_mp4(os.path.splitext(output)[0] + ".mp4", frames)]


def _write_page(run: Run, output: str, times: np.ndarray, frames: list[bytes], n_stored: int) -> None:
    apart = f", {1e3 * (times[1] - times[0]):.3g} ms apart," if "time" in run.time_label else ""
    section = Section("film", "Film", lead=f"{len(frames)} frames{apart} of {n_stored} stored instants (ticks below the curve); linear between them.")
    section.add({"kind": "frames", "frames": [embedded(io.BytesIO(frame))[0] for frame in frames],
                 "labels": [said_of(run, float(time)) for time in times]})
    if run.status != "done":
        section.add(note(f"The run is {run.status}: the film shows what is stored.", "warning"))
    page.write(output, "page.html.j2", title=title_of(run.name), subtitle=f"Finite elements, rung {run.rung}", sections=[section], problems=[],
               footer=run.meta.get("version", ""))


def _write_mp4(path: str, frames: list[bytes]) -> list[str]:
    """With ffmpeg, where it is installed; an earlier film goes first."""
    remove(path)
    program = shutil.which("ffmpeg")
    if program is None:
        return []
    command = [program, "-y", "-loglevel", "error", "-f", "image2pipe", "-framerate", "12", "-c:v", "png", "-i", "-", "-vf",
               "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-movflags", "frag_keyframe+empty_moov", "-f", "mp4", "-"]
    try:
        done = subprocess.run(command, input=b"".join(frames), capture_output=True, timeout=300)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise IoError(f"{program} made no film: {error}") from None
    if done.returncode != 0 or not done.stdout:
        raise IoError(f"{program} made no film: {(done.stderr.decode(errors='replace').strip().splitlines() or ['it gave no reason'])[-1]}")
    write_whole(path, lambda file: file.write(done.stdout))
    return [path]


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="report.film", description=__doc__.splitlines()[0])
    parser.add_argument("folder", metavar="DIR")
    parser.add_argument("--output", metavar="FILE.html", help="DIR/film.html when not given")
    parser.add_argument("--frames", type=int, default=FRAMES, choices=range(2, 501), metavar="N", help=f"2..500, {FRAMES} when not given")
    options = parser.parse_args(arguments)
    require_folder(options.folder)
    made = make(load_run(options.folder), options.output or os.path.join(options.folder, "film.html"), options.frames)
    if not made:
        raise DataError(f"{options.folder} holds fewer than {LEAST} fields in one stretch of time; a film needs as many")
    print(*made, sep="\n")


if __name__ == "__main__":
    run_main(main)

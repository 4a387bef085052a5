"""One look for every figure: colour-blind safe (Okabe-Ito), thin axes, units on axes, no chart junk."""
import base64
import contextlib
import io
import os
from collections.abc import Callable, Iterable, Iterator
from typing import IO, Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from PIL import Image

from .errors import IoError
from .files import write_whole

plt.switch_backend("Agg")

INK, MUTED, FAINT, PAPER = "#1c2733", "#66727f", "#dde3e8", "#ffffff"
FE, FITTED, PUBLISHED, RIM = "#0b4f8a", "#d55e00", "#7a8793", "#a3123a"
BLUE, SKY, GREEN, YELLOW, PURPLE = "#0072b2", "#56b4e9", "#009e73", "#e3b505", "#a8568c"
ENERGY = {"kinetic": BLUE, "gravity": SKY, "elastic": YELLOW, "contact": "#b8c1c9", "friction": GREEN,
          "impact": PURPLE, "plastic": FITTED, "damping": MUTED, "integrator": INK}
CYCLE = [FE, FITTED, GREEN, PURPLE, SKY, YELLOW, INK, PUBLISHED]
WIDTH = 7.2  # of a full-width figure [inch], the text block of an A4 page
DPI = 200

plt.rcParams.update({
    "figure.dpi": DPI, "savefig.dpi": DPI, "figure.facecolor": PAPER, "savefig.facecolor": PAPER,
    "font.family": "sans-serif", "font.sans-serif": ["DejaVu Sans"], "font.size": 7.5, "mathtext.fontset": "dejavusans",
    "axes.titlesize": 8, "axes.titleweight": "bold", "axes.titlelocation": "left", "axes.titlecolor": INK,
    "axes.labelsize": 7.5, "axes.labelcolor": INK, "axes.edgecolor": MUTED, "axes.linewidth": 0.6,
    "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "axes.axisbelow": True,
    "axes.prop_cycle": plt.cycler(color=CYCLE), "axes.unicode_minus": True,
    "figure.constrained_layout.w_pad": 0.06, "figure.constrained_layout.h_pad": 0.05,
    "grid.color": FAINT, "grid.linewidth": 0.5,
    "xtick.color": MUTED, "ytick.color": MUTED, "xtick.labelcolor": INK, "ytick.labelcolor": INK,
    "xtick.labelsize": 7, "ytick.labelsize": 7, "xtick.major.width": 0.6, "ytick.major.width": 0.6,
    "xtick.major.size": 2.5, "ytick.major.size": 2.5,
    "legend.frameon": False, "legend.fontsize": 7, "legend.handlelength": 1.8,
    "agg.path.chunksize": 20000,  # long records; lines follow every sample within a ninth of a pixel (path.simplify)
    "lines.linewidth": 1.2, "lines.solid_capstyle": "round", "text.color": INK,
})


def line_of(role: str) -> dict[str, Any]:
    """Line style of a model in overlays: the reference thick below, the fitted pair and the best law thin above, the published pair dashed.
    A capital letter names one of many curves: A is the reference, the others take a colour each, dashed from I on."""
    if len(role) == 1:
        k = ord(role) - ord("A")
        return dict(color=CYCLE[k % len(CYCLE)], lw=1.9 if k == 0 else 1.0, zorder=2 + k,
                    ls="-" if k < len(CYCLE) else (0, (4, 1.6)))
    return {"fe": dict(color=FE, lw=1.9, zorder=2), "fitted": dict(color=FITTED, lw=1.0, zorder=4),
            "law": dict(color=GREEN, lw=1.0, zorder=5),
            "published": dict(color=PUBLISHED, lw=0.9, ls=(0, (4, 1.6)), zorder=3)}[role]


def figure(rows: int, columns: int, height: float, width: float = WIDTH, **options: Any) -> tuple[Figure, np.ndarray]:
    return plt.subplots(rows, columns, figsize=(width, height), layout="constrained", squeeze=False, **options)


def shared_legend(fig: Figure, axes: Iterable[Axes], n_columns: int = 4) -> None:
    """One legend above all panels, with every label of the given axes once."""
    entries: dict[str, Any] = {}
    for ax in axes:
        handles, labels = ax.get_legend_handles_labels()
        entries |= {label: handle for label, handle in zip(labels, handles) if label not in entries}
    if not entries:
        return
    n_rows = -(-len(entries) // n_columns)
    strip = (0.08 + 0.155 * n_rows) / fig.get_figheight()
    fig.get_layout_engine().set(rect=(0, 0, 1, 1 - strip))
    fig.legend(entries.values(), entries.keys(), loc="upper left", bbox_to_anchor=(0.0, 1.0), ncol=n_columns,
               borderaxespad=0.1)


def literal(text: str) -> str:
    """A name as text of a figure: its dollars are no formula, and what is no text is a question mark."""
    return str(text).encode("utf-8", "replace").decode().replace("$", r"\$")


def write_png(fig: Figure, file: IO[bytes], dpi: int = DPI) -> None:
    """The figure as PNG. One drawing finds the layout and paints; Figure.savefig() would go through the figure twice for it."""
    fig.set_dpi(dpi)
    fig.canvas.print_png(file, pil_kwargs={"compress_level": 6})


#: Where save() leaves what paints a figure instead of painting it; None: it paints.
_set_aside: list[Callable[[], str]] | None = None


@contextlib.contextmanager
def set_aside() -> Iterator[list[Callable[[], str]]]:
    """Within it save() paints nothing: the list gets what does."""
    global _set_aside
    before, _set_aside = _set_aside, []
    try:
        yield _set_aside
    finally:
        _set_aside = before


def save(fig: Figure, path: str, dpi: int = DPI) -> str:
    """A PNG, whole or not at all."""
    if _set_aside is None:
        return _paint(fig, path, dpi)
    _set_aside.append(lambda: _paint(fig, path, dpi))
    plt.close(fig)
    return path


def _paint(fig: Figure, path: str, dpi: int) -> str:
    try:
        os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
        write_whole(path, lambda file: write_png(fig, file, dpi))
    except OSError as error:
        raise IoError(f"cannot write {path}: {error.strerror or error}") from None
    finally:
        plt.close(fig)
    return path


def embedded(path: str | io.BytesIO) -> tuple[str, tuple[int, int]]:
    """(a PNG file, or its bytes, as a data address, its width and height in pixels), so that the report needs no other file. As WebP, without
    loss: less than half the bytes. Method 1 takes four fifths of the time of method 4, for as many bytes within a per cent."""
    held = io.BytesIO()
    try:
        with Image.open(path) as picture:
            picture.save(held, "WEBP", lossless=True, method=1, quality=50)
            return "data:image/webp;base64," + base64.b64encode(held.getvalue()).decode(), picture.size
    except OSError as error:
        raise IoError(f"cannot read {path}: {error.strerror or error}") from None

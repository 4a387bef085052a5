"""python3 -m report.rim_picture FILE.vtu OUT.png [--scale S]: rim and slider, deformed, coloured by plastic strain.

Three views: the rim's wall as the slider sees it, the slider's side as the rim sees it, and the cut through the
touched point (the symmetry plane of a half model), in true scale. Cells are drawn as curved as the file has them. What
stands in cells is averaged where the cells of a body meet; the largest value named is a cell's own. On the bodies displacements are drawn S times too
large; S is chosen when not given. The slider's rigid translation is not enlarged."""
import argparse

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize

from . import vtu
from .errors import DataError, run_main
from .hexahedra import outlines, patches, smooth
from .painter import bodies, body_of_points, boundary_faces, merged, paint, turned, view
from .style import MUTED, plt, save

STRAIN = LinearSegmentedColormap.from_list("strain", ["#e6ebf0", "#f7d794", "#ef8f3f", "#bb372f", "#4a0d3a"])
STRAIN_FIELD = "equivalent_plastic_strain"
DRAWN_SHARE = 0.02  # of the model's size the largest drawn deformation should have


class Deformed:
    """Boundary of the model, deformed and enlarged: the nodes of its faces, and the strain at their corners."""

    def __init__(self, grid: vtu.Grid, scale: float | None = None) -> None:
        if "displacement" not in grid.point_data:
            raise DataError("the VTU file holds no field `displacement`")
        place = merged(grid.points)
        body = bodies(grid.hexahedra, place)
        reach = np.array([np.hypot(*grid.points[grid.hexahedra[body == b].ravel(), :2].T).max()
                          for b in range(body.max() + 1)])
        slider = (reach < 0.999 * reach.max())[body]  # plate and rim reach farthest from the axis
        moved = grid.point_data["displacement"].astype(float)
        angle = _direction(grid, body, slider)
        points, moved = turned(grid.points, angle), turned(moved, angle)
        on_slider = np.zeros(len(grid.points), bool)
        on_slider[grid.hexahedra[slider].ravel()] = True
        rigid = np.where(on_slider[:, None], moved[on_slider].mean(axis=0) if on_slider.any() else 0.0, 0.0)
        local = moved - rigid
        self.scale = scale or _nice(DRAWN_SHARE * np.ptp(points, axis=0).max() / max(np.abs(local).max(), 1e-12))
        faces, cell = boundary_faces(grid.hexahedra, place)
        self.nodes = (points + rigid + self.scale * local)[faces]
        self.true_nodes = (points + moved)[faces]
        self.top = largest_strain(grid)
        self.strain = _nodal_strain(grid, place, body)[faces[:, :4]]
        self.on_slider = slider[cell]
        y = points[faces][:, :, 1]
        self.half = points[:, 1].min() > -1e-6
        self.on_cut = self.half & np.all(np.abs(y) < 1e-6, axis=1)


def _direction(grid: vtu.Grid, body: np.ndarray, slider: np.ndarray) -> float:
    """Of the most strained sector of the rim [rad]; a half model's is 0 or pi."""
    strain = _cell_strain(grid)
    sectors = np.unique(body[~slider])
    hardest = max(sectors, key=lambda b: strain[body == b].max()) if len(sectors) else -1
    x, y = grid.points[grid.hexahedra[body == hardest].ravel(), :2].mean(axis=0) if len(sectors) else (1.0, 0.0)
    if min(abs(grid.points[:, 1].min()), abs(grid.points[:, 1].max())) < 1e-6:
        return 0.0 if x > 0 else np.pi
    return float(np.arctan2(y, x))


def largest_strain(grid: vtu.Grid) -> float:
    values = grid.point_data.get(STRAIN_FIELD, grid.cell_data.get(STRAIN_FIELD))
    return float(np.max(values)) if values is not None and len(values) else 0.0


def _cell_strain(grid: vtu.Grid) -> np.ndarray:
    """Largest value of each cell. Throws DataError where the file holds none."""
    if STRAIN_FIELD in grid.point_data:
        return np.asarray(grid.point_data[STRAIN_FIELD], float)[grid.hexahedra].max(axis=1)
    if STRAIN_FIELD in grid.cell_data:
        return np.asarray(grid.cell_data[STRAIN_FIELD], float)
    raise DataError(f"the VTU file holds no field `{STRAIN_FIELD}`")


def _nodal_strain(grid: vtu.Grid, place: np.ndarray, body: np.ndarray) -> np.ndarray:
    """At every point, the same at all copies of a body's node."""
    of_point = body_of_points(grid.hexahedra, body, len(grid.points))
    if STRAIN_FIELD in grid.point_data:
        return smooth(np.asarray(grid.point_data[STRAIN_FIELD], float), place, of_point)
    values = np.zeros(len(grid.points))
    values[grid.hexahedra] = _cell_strain(grid)[:, None]
    return smooth(values, place, of_point)


def _nice(value: float) -> int:
    """1, 2, 5, 10 ... not above value, at least 1 and at most 100."""
    steps = [1, 2, 5, 10, 20, 50, 100]
    return max([s for s in steps if s <= value], default=1)


def draw(grid: vtu.Grid, path: str, scale: float | None = None) -> tuple[float, float]:
    """Writes the picture; gives (largest plastic strain, enlargement)."""
    model = Deformed(grid, scale)
    top = model.top
    norm = Normalize(0.0, top if top > 1e-9 else 1e-3)
    n_panels = 3 if model.on_cut.any() else 2
    fig, grid_axes = plt.subplots(1, n_panels, figsize=(7.2, 2.75), layout="constrained",
                                  gridspec_kw={"width_ratios": [1.55, 1.0, 1.0][:n_panels]})
    _draw_body(grid_axes[0], model, ~model.on_slider, norm, view(180, 26), "Rim, seen from the slider")
    _draw_body(grid_axes[1], model, model.on_slider, norm, view(0, 20), "Slider, seen from the rim")
    if n_panels == 3:
        _draw_cut(grid_axes[2], model, norm)
    bar = fig.colorbar(ScalarMappable(norm, STRAIN), ax=list(grid_axes), orientation="horizontal", shrink=0.42,
                       aspect=38, pad=0.02)
    bar.set_label(f"equivalent plastic strain, largest {top:.2%}".replace("%", " %") if top > 1e-9
                  else "equivalent plastic strain: none, the model stayed elastic")
    bar.ax.xaxis.set_major_formatter(lambda value, _: f"{100 * value:.3g} %")
    bar.outline.set_visible(False)
    fig.text(0.995, 0.02, f"bodies: deformation × {model.scale:g}; cut: × 1", ha="right", fontsize=6.5, color=MUTED)
    save(fig, path)
    return top, model.scale


def _draw_body(ax: Axes, model: Deformed, chosen: np.ndarray, norm: Normalize, axes: np.ndarray, title: str) -> None:
    chosen = chosen & ~model.on_cut
    nodes, strain = model.nodes[chosen], model.strain[chosen]
    if not len(nodes):
        ax.axis("off")
        return
    quads, values = patches(nodes, strain)
    rings = outlines(nodes)
    if model.half:  # the other half is its mirror image
        quads, rings = _with_mirror(quads), _with_mirror(rings)
        values = np.concatenate([values, values])
    paint(ax, quads, STRAIN(norm(values)), axes, outlines=rings, edge=(0.1, 0.15, 0.2, 0.22), line_width=0.3)
    ax.set_title(title, loc="center", fontsize=7.5)


def _with_mirror(rings: np.ndarray) -> np.ndarray:
    """Turned over, so that the mirrored faces look outward too; the first corner stays the first."""
    return np.concatenate([rings, np.roll((rings * [1, -1, 1])[:, ::-1], 1, axis=1)])


def _draw_cut(ax: Axes, model: Deformed, norm: Normalize) -> None:
    """In true scale: what touches, touches."""
    nodes = 1e3 * model.true_nodes[model.on_cut][:, :, [0, 2]]
    quads, values = patches(nodes, model.strain[model.on_cut])
    ax.add_collection(PolyCollection(quads, facecolors=STRAIN(norm(values)), edgecolors="face", linewidths=0.3))
    ax.add_collection(PolyCollection(outlines(nodes), facecolors="none", edgecolors=(0.1, 0.15, 0.2, 0.35), linewidths=0.3))
    rim = 1e3 * model.true_nodes[model.on_cut & ~model.on_slider][:, :, [0, 2]].reshape(-1, 2)
    right, top = rim.max(axis=0)
    ax.set_xlim(right - 110, right + 6)
    ax.set_ylim(top - 85, top + 45)
    ax.set_aspect("equal", adjustable="box")
    ax.grid(False)
    ax.set_title("Cut through the contact", loc="center", fontsize=7.5)
    ax.set_xlabel("x (mm)")
    ax.set_ylabel("z (mm)")


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="report.rim_picture", description=__doc__.splitlines()[0])
    parser.add_argument("vtu")
    parser.add_argument("png")
    parser.add_argument("--scale", type=float, help="enlargement of the deformation; chosen when not given")
    options = parser.parse_args(arguments)
    draw(vtu.read(options.vtu), options.png, options.scale)


if __name__ == "__main__":
    run_main(main)

"""What a section is made of. Each block is a small dictionary that the template knows how to draw."""
import contextlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

from markupsafe import Markup

from .errors import IoError, ReportError
from .figure_processes import FigureProcesses
from .interactive import Panel, data
from .side_by_side import cores_to_use
from .style import DPI, WIDTH, embedded, plt, set_aside


@dataclass
class Section:
    id: str
    title: str
    blocks: list[Any] = field(default_factory=list)
    lead: str = ""
    number: str = ""  #: given when the page is written
    appendix: bool = False  #: lettered, behind the numbered chapters: what is kept for comparison and is not the answer

    def add(self, block: dict[str, Any] | None) -> None:
        if block is not None:
            self.blocks.append(block)


def text(sentence: str) -> dict[str, str]:
    return {"kind": "text", "text": sentence}


def heading(title: str, tag: str = "") -> dict[str, str]:
    return {"kind": "heading", "title": title, "tag": tag}


def note(sentence: str, level: str = "info") -> dict[str, str]:
    """level: info | warning | missing."""
    return {"kind": "note", "text": sentence, "level": level}


def table(header: list[str], rows: list[Any], caption: str = "", left: int | tuple[int, ...] = 1, compact: bool = False,
          prose: bool = False, record: str = "") -> dict[str, Any] | None:
    """`left`: how many columns, or which (numbered from 0), are text, set flush left; figures are set flush right.
    A row is a list of cells, or {"span", "tag"}: a heading across the table. `compact`: no wider than it needs; `prose`: long cells wrap.
    `record`: where the errors of laws and pairs in it are taken from, one place a table; the page carries it, to be checked."""
    columns = set(range(left)) if isinstance(left, int) else set(left)
    return {"kind": "table", "header": header, "rows": rows, "caption": caption, "left": columns, "record": record,
            "style": "compact" if compact else "prose" if prose else "many" if len(header) > 10 else ""} if rows else None


def bullets(items: Sequence[str | tuple[str, str]]) -> dict[str, Any] | None:
    """items: sentences, or (lead, sentence) pairs."""
    pairs = [item if isinstance(item, tuple) else ("", item) for item in items if item]
    return {"kind": "bullets", "items": pairs} if pairs else None


def details(title: str, content: str) -> dict[str, Any] | None:
    return {"kind": "details", "title": title, "content": content} if content else None


def turning(model: Markup, caption: str) -> dict[str, Any]:
    """A model to be turned, as view3d.data() has it. It shows nothing in print or without WebGL: a picture stands beside it."""
    return {"kind": "turning", "model": model, "caption": caption}


class Pictures:
    """Draws figures into one folder and embeds them. A figure that cannot be drawn becomes a sentence.

    After begin() they are painted side by side, and a block has its picture after finish() only."""

    def __init__(self, folder: str, problems: list[str]) -> None:
        self.folder, self.problems = folder, problems
        self._processes: FigureProcesses | None = None
        self._waiting: list[tuple[dict[str, Any], str, Any]] = []  #: block, name, its painting

    def path(self, name: str) -> str:
        safe = "".join(c if c.isalnum() or c in "-._" else "-" for c in name)
        return f"{self.folder}/{safe}.png"

    def begin(self) -> None:
        at_once = cores_to_use()
        self._processes = FigureProcesses(at_once) if at_once > 1 else None

    def finish(self) -> None:
        """What could not be painted is a problem, and its block empty: pages leave it out."""
        for block, name, painting in self._waiting:
            try:
                assert self._processes
                block |= self._processes.result(painting)
            except ValueError as error:
                self._fail(name, error)
                block.clear()
        self._waiting, self._processes = [], None

    def figure(self, name: str, caption: str, draw: Callable[..., str | None], *arguments: Any,
               curves: Callable[..., list[Panel]] | None = None, **options: Any) -> dict[str, Any] | None:
        """draw(*arguments, path, **options) gives the path, or None when there is nothing to draw. `curves`(*arguments): the same
        for the page's script, to be zoomed."""
        path = self.path(name)
        try:
            with set_aside() if self._processes else contextlib.nullcontext([]) as paints:
                drawn = draw(*arguments, path, **options)
            zoomed = data(curves(*arguments)) if drawn and curves else None
        except IoError:
            raise
        except (ReportError, KeyError, ValueError, IndexError, TypeError, ZeroDivisionError) as error:
            plt.close("all")
            self._fail(name, error)
            return None
        if not drawn:
            return None
        block = {"kind": "figure", "caption": caption, "file": drawn.rsplit("/", 1)[-1], "curves": zoomed}
        if self._processes:
            self._waiting.append((block, name, self._processes.start(lambda: [paint() for paint in paints] and _embedded(drawn))))
            return block
        return block | _embedded(drawn)

    def _fail(self, name: str, error: Exception) -> None:
        self.problems.append(f"figure {name} could not be drawn: {error}")


def _embedded(path: str) -> dict[str, Any]:
    """Of a figure's block: the picture and how it stands on the page."""
    source, (width, height) = embedded(path)
    return {"source": source, "share": min(100, round(100 * width / (WIDTH * DPI))), "tall": height > 0.85 * width}

"""Fonts that have a language's letters: those of pictures, and those a browser prints with."""
import functools

from matplotlib import font_manager
from matplotlib.ft2font import FT2Font

LETTER = {"ja": "衝"}  #: one that fonts without the language lack; DejaVu Sans has all of the others
NEEDED = {"ja": "fonts-noto-cjk"}  #: Debian's package
BEST = ("Noto Sans CJK JP", "Noto Sans JP", "IPAexGothic", "IPAGothic", "TakaoPGothic", "VL PGothic")  #: first


@functools.cache
def family_for(language: str) -> str | None:
    """The name of an installed font with the language's letters; "" where any will do; None where none is installed."""
    if language not in LETTER:
        return ""
    able = {font.name for font in font_manager.fontManager.ttflist if _has(font.fname, LETTER[language])}
    return next((name for name in BEST if name in able), min(able, default=None))


@functools.cache
def _has(path: str, letter: str) -> bool:
    try:
        return ord(letter) in FT2Font(path).get_charmap()
    except (OSError, RuntimeError):
        return False


def missing(language: str) -> str:
    """What to do where no font has its letters; empty: there is one."""
    if family_for(language) is not None:
        return ""
    return (f"no installed font has the letters of language {language}: pictures are labelled in English, and no PDF is printed, for it would show boxes. "
            f"apt-get install {NEEDED[language]} (or put a font of yours into ~/.local/share/fonts), delete matplotlib's list of fonts (~/.cache/matplotlib) and ask again")

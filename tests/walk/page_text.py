"""Page one as a reader sees it: its words, its sentences, its numbers."""
import html
import math
import os
import re


def first_page(folder: str) -> str:
    with open(os.path.join(folder, "report.html"), encoding="utf-8") as file:
        page = file.read()
    first = page[page.index('<section id="first"'):]
    return re.sub(r"<(script|style|svg)\b.*?</\1>", "", first[:first.index("</section>")], flags=re.DOTALL)


def sentences_of(folder: str) -> list[str]:
    """Of paragraphs and lists, where sentences stand."""
    said = re.findall(r"<(p|li)\b[^>]*>(.*?)</\1>", first_page(folder), flags=re.DOTALL)
    texts = [re.sub(r"\s+", " ", html.unescape(re.sub(r"<[^>]*>", "", text))) for _, text in said]
    return [sentence for text in texts for sentence in re.split(r"(?<=[.!?:;]) ", text) if sentence.strip()]


def words_of(folder: str) -> str:
    first = first_page(folder)
    return re.sub(r"\s+", " ", html.unescape(re.sub(r"<[^>]*>", " ", first))).replace("\u202f", " ").replace("\u00a0", " ")


def near(said: float, truth: float, tolerance: float, digit: float = 0.0) -> bool:
    return abs(said - truth) <= tolerance * abs(truth) + 0.51 * digit


def digit_of(text: str) -> float:
    """What the last digit of a number stands for."""
    return 10.0 ** -len(text.partition(".")[2]) if "." in text else 1.0


def three(value: float) -> str:
    """Three figures, thousands set apart."""
    digits = max(0, 2 - math.floor(math.log10(abs(value)))) if value else 0
    rounded = float(f"{value:.3g}")
    return f"{rounded:,.{digits}f}".replace(",", " ") if abs(rounded) >= 1e4 else f"{rounded:.{digits}f}"


def whole(value: float) -> str:
    return f"{value:,.0f}".replace(",", " ") if abs(value) >= 1e4 else f"{value:.0f}"


def upwards(share: float) -> str:
    """In per cent, never less than it is: tenths below ten."""
    per_cent = 100 * share
    step = 0.1 if per_cent < 10 else 1.0
    return f"{max(0.1, step * math.ceil(per_cent / step - 1e-9)):.10g} %"

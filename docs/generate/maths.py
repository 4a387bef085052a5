"""Formulas of the pages as MathML, made while mkdocs builds the site: no script, no network, no font to fetch.

Pages hold TeX, `$...$` in a line and `$$ ... $$` as a paragraph, which GitHub shows by itself. What is taken of TeX stands in the tables below;
anything else is an error that names page and command, so that a site is never built with half a formula.
"""
import html
import re
from typing import Any

LETTERS = dict(zip(
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau phi chi psi omega Gamma Delta Theta Lambda Sigma Phi Psi Omega".split(),
    "αβγδεζηθικλμνξπρστφχψωΓΔΘΛΣΦΨΩ"))
LETTERS |= {"varepsilon": "ε", "varphi": "φ", "ell": "ℓ", "infty": "∞", "nabla": "∇", "partial": "∂"}
OPERATORS = {"le": "≤", "ge": "≥", "ne": "≠", "approx": "≈", "to": "→", "pm": "±", "mp": "∓", "cdot": "·", "times": "×", "in": "∈", "sum": "∑", "int": "∫", "prime": "′",
             "ldots": "…", "quad": None, "qquad": None, "lvert": "|", "rvert": "|", "lVert": "‖", "rVert": "‖", "langle": "⟨", "rangle": "⟩", ",": None, ";": None, " ": None,
             "{": "{", "}": "}", "propto": "∝", "perp": "⊥", "ll": "≪", "gg": "≫", "colon": ":"}
SPACES = {"quad": "1em", "qquad": "2em", ",": "0.17em", ";": "0.28em", " ": "0.28em"}
FUNCTIONS = "sin cos tan asin atan ln exp max min sign sinh tanh arctan arcsin det dev tr".split()
ACCENTS = {"dot": "˙", "ddot": "¨", "bar": "¯", "hat": "^", "tilde": "~"}
TOKEN = re.compile(r"\\[a-zA-Z]+|\\\\|\\.|\d+(?:\.\d+)?|\S|\s+")
UNSTRETCHED = "()[]|‖"


class Unknown(ValueError):
    pass


class Formula:
    """One formula, read from left to right; every method returns MathML."""

    def __init__(self, tex: str) -> None:
        self.tokens = [token for token in TOKEN.findall(tex) if not token.isspace()]
        self.spaced = tex
        self.at = 0

    def peek(self) -> str | None:
        return self.tokens[self.at] if self.at < len(self.tokens) else None

    def take(self, wanted: str | None = None) -> str:
        token = self.peek()
        if token is None or (wanted and token != wanted):
            raise Unknown(f"{wanted or 'more'} is missing in {self.spaced!r}")
        self.at += 1
        return token

    def row(self, *ends: str) -> str:
        parts = []
        while self.peek() is not None and self.peek() not in ends:
            parts.append(self.scripted())
        return "".join(parts)

    def group(self) -> str:
        """What stands in braces, or the next token."""
        if self.peek() != "{":
            return self.atom()
        self.take("{")
        inside = self.row("}")
        self.take("}")
        return f"<mrow>{inside}</mrow>"

    def scripted(self) -> str:
        large = self.peek() in (r"\sum", r"\int", r"\max", r"\min")
        base, below, raised = self.atom(), "", ""
        while self.peek() == "'":
            self.take()
            base = f'<mrow>{base}<mo lspace="0" rspace="0">′</mo></mrow>'
        while self.peek() in ("_", "^"):
            if self.take() == "_":
                below = self.group()
            else:
                raised += self.group()
        above = f"<mrow>{raised}</mrow>" if raised else ""
        both, under, over = ("munderover", "munder", "mover") if large and "∫" not in base else ("msubsup", "msub", "msup")
        if below and above:
            return f"<{both}>{base}{below}{above}</{both}>"
        if below:
            return f"<{under}>{base}{below}</{under}>"
        return f"<{over}>{base}{above}</{over}>" if above else base

    def text(self) -> str:
        """The letters in braces as they stand, spaces kept."""
        start = sum(1 for token in self.tokens[:self.at] if token == r"\text")
        self.take("{")
        words = re.findall(r"\\text\{([^}]*)\}", self.spaced)[start - 1]
        while self.take() != "}":
            pass
        return html.escape(words)

    def atom(self) -> str:
        token = self.take()
        if token.startswith("\\") and len(token) > 1:
            return self.command(token[1:])
        if token == "{":
            self.at -= 1
            return self.group()
        if token[0].isdigit():
            return f"<mn>{token}</mn>"
        if token.isalpha():
            return f"<mi>{token}</mi>"
        sign = {"-": "−", "*": "∗"}.get(token, token)
        fixed = ' stretchy="false"' if sign in UNSTRETCHED else ' lspace="0" rspace="0"' if sign == "/" else ""
        if sign in "−+" and self.begins():
            fixed = ' form="prefix"'
        return f"<mo{fixed}>{html.escape(sign)}</mo>"

    def begins(self) -> bool:
        """Whether the token just taken begins a row or follows what opens one: a sign there has no left side."""
        return self.at < 2 or self.tokens[self.at - 2] in ("{", "(", "[", "=", ",", "&", r"\left")

    def function(self, name: str) -> str:
        """Upright, set off from its neighbours as TeX does."""
        left = "0" if self.begins() or self.tokens[self.at - 2] in ("+", "-") else "0.17em"
        right = "0" if self.peek() in ("(", "_", "^", r"\left", None) else "0.17em"
        return f'<mo lspace="{left}" rspace="{right}" form="prefix">{name}</mo>'

    def command(self, name: str) -> str:
        if name in LETTERS:
            return f"<mi>{LETTERS[name]}</mi>"
        if name in FUNCTIONS:
            return self.function(name)
        if name in SPACES:
            return f'<mspace width="{SPACES[name]}"/>'
        if name in OPERATORS:
            fixed = ' stretchy="false" lspace="0" rspace="0"' if name[1:] in ("vert", "Vert") else ""
            return f"<mo{fixed}>{OPERATORS[name]}</mo>"
        if name in ACCENTS:
            return f"<mover accent=\"true\">{self.group()}<mo>{ACCENTS[name]}</mo></mover>"
        if name == "frac":
            return f"<mfrac>{self.group()}{self.group()}</mfrac>"
        if name == "sqrt":
            return f"<msqrt>{self.group()}</msqrt>"
        if name == "text":
            return f"<mtext>{self.text()}</mtext>"
        if name in ("mathbf", "mathrm", "mathsf"):
            return self.upright(name)
        if name in ("left", "right"):
            return self.fence(name)
        if name == "begin":
            return self.table()
        raise Unknown(f"\\{name} is not known to docs/generate/maths.py ({self.spaced!r})")

    def upright(self, name: str) -> str:
        self.take("{")
        letters = ""
        while self.peek() != "}":
            letters += self.take()
        self.take("}")
        kind = "bold" if name == "mathbf" else "normal"
        return f'<mi mathvariant="{kind}">{html.escape(letters)}</mi>'

    def fence(self, side: str) -> str:
        """\\left and \\right: a fence as high as what it holds; a dot is none."""
        if side == "right":
            raise Unknown(f"\\right without \\left in {self.spaced!r}")
        opening = self.take()
        inside = self.row(r"\right")
        self.take(r"\right")
        closing = self.take()
        fences = [OPERATORS.get(each.lstrip("\\"), each) if each != "." else "" for each in (opening, closing)]
        return f'<mrow><mo fence="true">{fences[0]}</mo>{inside}<mo fence="true">{fences[1]}</mo></mrow>'

    def table(self) -> str:
        kind = self.braced()
        if kind not in ("cases", "aligned"):
            raise Unknown(f"\\begin{{{kind}}} is not known to docs/generate/maths.py")
        rows, cells = [], []
        while self.peek() != r"\end":
            cells.append(f"<mtd>{self.row('&', chr(92) * 2, chr(92) + 'end')}</mtd>")
            if self.peek() != "&":
                rows.append(f"<mtr>{''.join(cells)}</mtr>")
                cells = []
            if self.peek() != r"\end":
                self.take()
        self.take()
        self.braced()
        inside = f'<mtable displaystyle="true" class="{kind}">{"".join(rows)}</mtable>'
        return f'<mrow><mo fence="true">{{</mo>{inside}</mrow>' if kind == "cases" else inside

    def braced(self) -> str:
        self.take("{")
        word = ""
        while (token := self.take()) != "}":
            word += token
        return word


def mathml(tex: str, display: bool = False) -> str:
    """One formula. Raises Unknown for what is not in the tables."""
    formula = Formula(tex)
    inside = formula.row()
    block = ' display="block"' if display else ""
    return f"<math{block}><mrow>{inside}</mrow></math>"


CODE = re.compile(r"^```.*?^```|`[^`\n]+`", re.MULTILINE | re.DOTALL)
MATHS = re.compile(r"\$\$(.+?)\$\$|\$([^$\n]+?)\$", re.DOTALL)
_made: dict[str, dict[str, str]] = {}


def with_marks(text: str) -> tuple[str, dict[str, str]]:
    """The page with a mark in each formula's place, and what the marks stand for."""
    made, kept = dict[str, str](), list[str]()

    def keep(match: re.Match[str]) -> str:
        kept.append(match.group(0))
        return f"\0{len(kept) - 1}\0"

    def mark(match: re.Match[str]) -> str:
        display = match.group(1) is not None
        name = f"formula{len(made)}x"
        if display:  # several in a line come one below the other on a narrow screen
            made[name] = '<span class="formula">' + "".join(mathml(part, True) for part in match.group(1).split(r"\qquad")) + "</span>"
        else:
            made[name] = mathml(match.group(2))
        return name

    text = MATHS.sub(mark, CODE.sub(keep, text))
    kept = [re.sub(r"^```(\w+) .*", r"```\1", code) for code in kept]  # ```sh slow: what a test reads is not the site's to know
    return re.sub("\0(\\d+)\0", lambda match: kept[int(match.group(1))], text), made


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """mkdocs: before Markdown is read."""
    try:
        text, _made[page.file.src_path] = with_marks(markdown)
    except Unknown as error:
        raise SystemExit(f"{page.file.src_path}: {error}") from error
    return text


def on_page_content(content: str, page: Any, **_: Any) -> str:
    """mkdocs: when the page is HTML."""
    return re.sub(r"formula\d+x", lambda match: _made[page.file.src_path][match.group(0)], content)

"""Numbers as an engineer reads them: sensible digits, a thin space between thousands, a true minus sign."""
import math
from typing import Any, TypeGuard

DASH = "–"
NARROW = "\u202f"
SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def is_number(value: Any) -> TypeGuard[float]:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < 1e300  # nor NaN


def _grouped(text: str) -> str:
    sign, text = ("−", text[1:]) if text.startswith("-") else ("", text)
    whole, _, fraction = text.partition(".")
    if len(whole) > 4:
        whole = f"{int(whole):,}".replace(",", NARROW)
    return sign + whole + ("." + fraction if fraction else "")


def sig(value: Any, digits: int = 3) -> str:
    """`digits` significant figures; powers of ten outside 1e-3 .. 1e6; a dash for what is not there."""
    if not is_number(value):
        return DASH
    if value == 0:
        return "0"
    exponent = math.floor(math.log10(abs(float(f"{value:.{digits - 1}e}"))))
    if exponent < -3 or exponent > 6:
        return power(value, digits)
    return _grouped(f"{round(value, digits - 1 - exponent):.{max(0, digits - 1 - exponent)}f}")


def power(value: Any, digits: int = 3) -> str:
    """4.50 × 10⁵."""
    if not is_number(value):
        return DASH
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    return f"{mantissa.replace('-', '−')} × 10{str(int(exponent)).translate(SUPERSCRIPT)}"


def interval(low: Any, high: Any, digits: int = 3) -> str:
    """3.98 to 4.22 × 10⁵: the power of ten is said once."""
    if not is_number(low) or not is_number(high):
        return DASH
    a, b = power(low, digits), power(high, digits)
    if max(abs(low), abs(high)) < 1e4:
        return f"{sig(low, digits)} to {sig(high, digits)}"
    return f"{a.split(' ')[0]} to {b}" if a.split(" ")[2] == b.split(" ")[2] else f"{a} to {b}"


def fixed(value: Any, decimals: int = 1) -> str:
    return _grouped(f"{round(value, decimals) + 0.0:.{decimals}f}") if is_number(value) else DASH


def integer(value: Any) -> str:
    return _grouped(f"{value:.0f}") if is_number(value) else DASH


def percent(ratio: Any, decimals: int = 1, signed: bool = True) -> str:
    """A ratio as signed per cent: 0.034 -> +3.4 %."""
    if not is_number(ratio):
        return DASH
    rounded = round(100 * ratio, decimals)
    text = f"{rounded:+.{decimals}f}" if signed and rounded != 0 else f"{rounded + 0.0:.{decimals}f}"
    return text.replace("-", "−") + NARROW + "%"


def percent_up(ratio: Any) -> str:
    """The size of an error as a bound, rounded up to two figures as the program's sentences have it: 0.0312 is 3.2 %, 0.243 is 25 %."""
    if not is_number(ratio):
        return DASH
    per_cent = 100 * abs(ratio)
    step = 0.1 if per_cent < 10 else 1.0
    return f"{max(0.1, step * math.ceil(per_cent / step - 1e-9)):.10g}{NARROW}%"


def scaled(value: Any, factor: float, decimals: int = 1) -> str:
    """value * factor with a fixed number of decimals; a dash for None."""
    return fixed(value * factor, decimals) if is_number(value) else DASH


def duration(seconds: Any) -> str:
    if not is_number(seconds):
        return DASH
    if seconds < 0.1:
        return f"{sig(1e3 * seconds, 2)} ms"
    if seconds < 120:
        return f"{sig(seconds, 3)} s"
    return f"{int(seconds // 60)} min {int(seconds % 60):02d} s"


def memory(n_bytes: Any) -> str:
    if not is_number(n_bytes) or n_bytes <= 0:
        return DASH
    return f"{n_bytes / 1e9:.2f} GB" if n_bytes >= 1e9 else f"{n_bytes / 1e6:.0f} MB"


def plain(value: Any) -> str:
    """A value of any JSON or TOML type as text."""
    if value is None:
        return DASH
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int):
        return integer(value)
    if isinstance(value, float) and math.isinf(value):
        return "∞" if value > 0 else "−∞"
    if isinstance(value, float):
        return _grouped(f"{value:.6g}") if value == 0 or 1e-4 <= abs(value) < 1e6 else power(value, 3)
    if isinstance(value, (list, tuple)):
        return ("; " if value and isinstance(value[0], (list, tuple)) else ", ").join(plain(item) for item in value)
    return str(value)

"""Lines of a table beside those stored."""


def differ(now: str, stored: str, share: float, small: float) -> bool:
    """Words must be equal, numbers alike within `share` of the stored one, or within `small`."""
    a, b = now.split(), stored.split()
    if len(a) != len(b):
        return True
    for p, q in zip(a, b):
        try:
            if abs(float(p) - float(q)) > max(small, share * abs(float(q))):
                return True
        except ValueError:
            if p != q:
                return True
    return False

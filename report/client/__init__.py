"""Two pages for the client, in the client's language: the isolator, the law of its rim, how far both may be trusted. Words stand in
words.csv, one column a language; numbers are those of the report's first page."""
from .page import build
from .words import LANGUAGES

__all__ = ["LANGUAGES", "build"]

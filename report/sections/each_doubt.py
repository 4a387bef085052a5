"""The appendix of the doubts, each by itself, where the first page says those of one kind once."""
from ..blocks import Section, bullets
from ..context import Context
from ..plain_words import for_page


def make(context: Context) -> Section | None:
    doubts = context.doubts
    if len(doubts.lines) == len(doubts.all):
        return None
    section = Section("each-doubt", "Appendix: every doubt by itself", appendix=True)
    section.lead = "The first page says doubts of one kind once, by the worst of them."
    section.add(bullets([(", ".join(doubt.runs) + ":" if doubt.runs else "", for_page(doubt.sentence)) for doubt in doubts.all]))
    return section

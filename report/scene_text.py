"""What only the text of a TOML file tells: which keys carry the comment "assumption"."""
import re


def commented_keys(text: str) -> set:
    """Dotted keys whose line, or whose table's header line, carries the word "assumption" as a comment."""
    table, whole_table, keys = "", False, set()
    for line in text.splitlines():
        code, _, comment = line.partition("#")
        said = "assumption" in comment.lower()
        header = re.match(r"\s*\[([^\[\]]+)\]", code)
        entry = re.match(r"\s*([\w.\-]+)\s*=", code)
        if header:
            table, whole_table = header.group(1).strip(), said
        elif entry and (said or whole_table):
            keys.add(f"{table}.{entry.group(1)}" if table else entry.group(1))
    return keys

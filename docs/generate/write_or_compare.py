"""What every generator does with what it has made: write it, or with --check say where a file differs."""
import pathlib
from collections.abc import Mapping, Sequence


def write_or_compare(files: Mapping[pathlib.Path, str], options: Sequence[str], source: str) -> int:
    """`files`: contents by path, of one folder. Exit code 1 where --check is among the options and one differs from them; `source` ends the sentence."""
    if "--check" not in options:
        for path, text in files.items():
            path.parent.mkdir(exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return 0
    different = [path for path, text in files.items() if not path.is_file() or path.read_text(encoding="utf-8") != text]
    if different:
        root = different[0].parents[2]
        print(f"{different[0].parent.relative_to(root)}/{', '.join(path.name for path in different)} is not what {source}")
    return 1 if different else 0

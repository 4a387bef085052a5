"""Runs words by the Python of an environment that ./test makes from PyPI (build/peers, build/python). Where it could not be made:
by another Python, or exit code 77 (skipped) with a word.

usage: in_environment.py PYTHON [--else OTHER_PYTHON] WORD..."""
import os
import sys


def main(python: str, *words: str) -> int:
    other = ""
    if words[0] == "--else":
        other, words = words[1], words[2:]
    if not os.access(python, os.X_OK):
        name = os.path.basename(os.path.dirname(os.path.dirname(python)))
        if not other:
            print(f"skipped: what tests/{name}/requirements.txt names is not installed ({python} is missing); ./test installs it where PyPI answers")
            return 77
        python = other
    sys.stdout.flush()
    os.execv(python, [python, *words])


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

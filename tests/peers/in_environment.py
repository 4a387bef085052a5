"""Runs words by the Python of build/peers; exit code 77 (skipped), with a word, where ./test could not make it.

usage: in_environment.py PYTHON WORD..."""
import os
import sys


def main(python: str, *words: str) -> int:
    if not os.access(python, os.X_OK):
        print(f"skipped: the peers of tests/peers/requirements.txt are not installed ({python} is missing); ./test installs them where PyPI answers")
        return 77
    sys.stdout.flush()
    os.execv(python, [python, *words])


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

"""Runs the command and keeps what it printed."""
import os
import subprocess

RIMPACT = os.environ["RIMPACT"]


def rimpact(*arguments, cwd=None, **environment):
    return subprocess.run([RIMPACT, *arguments], capture_output=True, text=True, cwd=cwd, timeout=900,
                          env={**os.environ, **environment})

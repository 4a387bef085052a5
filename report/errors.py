"""Errors a user can meet, each with the exit code of the `rimpact` command and one clear sentence."""
import io
import sys
from collections.abc import Callable


class ReportError(Exception):
    code = 1


class InputError(ReportError):
    """The command line, or a TOML file named there."""
    code = 2


class DataError(ReportError):
    """A data file cannot be read or makes no sense."""
    code = 3


class IoError(ReportError):
    """Reading or writing failed: disk full, permission."""
    code = 6


def run_main(main: Callable[[list[str]], None], verb: str = "report") -> None:
    """Runs main(argv) and turns errors into one sentence on stderr, in the name of the command's verb, and an exit code."""
    for stream in (sys.stdout, sys.stderr):  # a folder's name may be no text
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")
    try:
        main(sys.argv[1:])
    except ReportError as error:
        print(f"rimpact {verb}: {error}", file=sys.stderr)
        sys.exit(error.code)
    except BrokenPipeError:  # nobody reads on
        sys.exit(0)
    except OSError as error:
        place = f"{error.filename}: " if error.filename else ""
        print(f"rimpact {verb}: {place}{error.strerror or error}", file=sys.stderr)
        sys.exit(IoError.code)
    except KeyboardInterrupt:
        sys.exit(130)

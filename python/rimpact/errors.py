"""One exception for each kind of failure. Its text is the sentence that the command would print; `code` is the command's exit code."""


class Error(Exception):
    """Base of all; a bare one is a bug."""
    code = 1


class InputError(Error, ValueError):
    """A scene, a key, a value or an argument: names file, line, value and bound."""
    code = 2


class DataError(Error, ValueError):
    """A data file: a record, a response, a mesh, a calibration."""
    code = 3


class Stopped(Error, RuntimeError):
    """The solver stopped; a run folder keeps what is before it."""
    code = 4


class GateError(Error, RuntimeError):
    """A gate was not met: the fit did not converge."""
    code = 5


class OutputError(Error, OSError):
    """Reading or writing failed."""
    code = 6


def of_code(code: int) -> type[Error]:
    """The class for an exit code."""
    return {kind.code: kind for kind in (InputError, DataError, Stopped, GateError, OutputError)}.get(code, Error)

"""Writing files: whole or not at all, and never a device node replaced by a file. Folders that must be there."""
import os
from collections.abc import Callable

from .errors import DataError, IoError


def require_folder(path: str) -> None:
    if not os.path.isdir(path):
        raise DataError(f"{path} is not a folder" if os.path.exists(path) else f"{path} does not exist")


def write_whole(path: str, write: Callable) -> None:
    """`write(file)` fills a binary file beside `path`, which is flushed and renamed: a full disk or a killed program
    leaves an earlier file as it was and nothing beside it. What is there and is no ordinary file (a device, a pipe) is
    written into. Throws IoError."""
    path = os.path.realpath(path)
    try:
        if os.path.exists(path) and not os.path.isfile(path):
            with open(path, "wb") as file:
                write(file)
            return
        part = path + ".part"
        try:
            with open(part, "wb") as file:
                write(file)
                file.flush()
                os.fsync(file.fileno())
            os.replace(part, path)
        except BaseException:
            remove(part)
            raise
    except OSError as error:
        raise IoError(f"cannot write {path}: {error.strerror or error}") from None


def remove(path: str) -> None:
    """Gone, or never there."""
    try:
        os.unlink(path)
    except OSError:
        pass

"""Which TOML files say what the columns of a laboratory's table are."""
import tomllib


def parts_of(path: str) -> tuple[str, str]:
    """The file, and the test that is named behind it: campaign.toml#7."""
    file, _, test = path.rpartition("#")
    return (file, test) if file.endswith(".toml") else (path, "")


def is_mapping(path: str) -> bool:
    """A TOML file that names a table and what its columns are; a test may be named behind it."""
    try:
        with open(parts_of(path)[0], "rb") as file:
            return isinstance(tomllib.load(file).get("columns"), dict)
    except (OSError, tomllib.TOMLDecodeError, UnicodeDecodeError):
        return False

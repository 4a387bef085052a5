"""Which TOML files say what the columns of a laboratory's table are."""
import tomllib


def is_mapping(path: str) -> bool:
    """A TOML file that names a table and what its columns are."""
    try:
        with open(path, "rb") as file:
            return isinstance(tomllib.load(file).get("columns"), dict)
    except (OSError, tomllib.TOMLDecodeError, UnicodeDecodeError):
        return False

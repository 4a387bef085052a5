"""calibration.json as the report needs it: parameters, window rows, validity, grazing; absent parts are empty.

Extra keys of the file are read under the names the calibration module writes; a unit suffix may follow a name."""
from dataclasses import dataclass, field

from .numbers import is_number

PUBLISHED = {"k_i": 4.5e5, "e": 0.65}  # thesis 2.5.3, in kN/m and -


def pick(tree, *names):
    """The first of the names that is there, with or without a unit suffix (speed, speed_m_s, speed_m_per_s ...)."""
    if not isinstance(tree, dict):
        return None
    for name in names:
        if tree.get(name) is not None:
            return tree[name]
        for key, value in tree.items():
            suffix = key.removeprefix(name)
            if suffix != key and suffix.startswith("_") and value is not None and suffix[1:] in SUFFIXES:
                return value
    return None


SUFFIXES = {"m_s", "m_per_s", "kN_per_m", "N_per_m", "kN_m", "N", "kN", "s", "ms", "m", "mm", "g"}


@dataclass
class Parameter:
    name: str
    value: float
    unit: str = ""
    standard_error: float = None
    interval: tuple = None
    identifiable: bool = None
    reason: str = ""
    published: float = None


@dataclass
class WindowRow:
    """What one isolated impact says. k_i in kN/m, speeds in m/s."""
    speed: float
    k_i: Parameter = None
    e: Parameter = None
    peak_force_N: float = None
    contact_time_s: float = None
    restitution: float = None
    pair_force_error: float = None
    pair_holds: bool = None


@dataclass
class Calibration:
    parameters: list = field(default_factory=list)
    correlation: dict = field(default_factory=dict)
    condition: float = None
    derived: dict = field(default_factory=dict)
    fit: dict = field(default_factory=dict)
    prediction: dict = field(default_factory=dict)
    windows: list = field(default_factory=list)
    validity: str = ""
    valid_from: float = None
    valid_to: float = None
    tolerance: float = None
    grazing: list = field(default_factory=list)
    notes: list = field(default_factory=list)
    fitted_on: str = ""

    def parameter(self, name):
        return next((p for p in self.parameters if p.name == name), None)

    def metrics(self, run_name):
        """The metrics of a run, whose key is its folder: matched by the folder's last part."""
        for table in (self.fit, self.prediction):
            for key, value in table.items():
                if key.rstrip("/").split("/")[-1] == run_name and isinstance(value, dict):
                    return value
        return {}


def parameter_of(name, data):
    if is_number(data):
        data = {"value": data}
    if not isinstance(data, dict) or not is_number(data.get("value")):
        return None
    interval = data.get("interval_95")
    interval = tuple(interval) if isinstance(interval, list) and len(interval) == 2 else None
    return Parameter(name, data["value"], data.get("unit") or "", data.get("standard_error"),
                     interval if interval and all(is_number(x) for x in interval) else None, data.get("identifiable"),
                     data.get("reason") or "")


def _window_row(data):
    own = pick(data, "own", "fit", "parameters") or data
    own = own.get("parameters", own) if isinstance(own, dict) else data
    row = WindowRow(pick(data, "speed", "approach_speed"))
    row.k_i = parameter_of("k_i", pick(own, "k_i"))
    row.e = parameter_of("e", pick(own, "e"))
    row.peak_force_N = pick(data, "peak_force")
    row.contact_time_s = pick(data, "contact_time")
    row.restitution = pick(data, "restitution")
    row.pair_force_error = pick(data, "pair_force_error", "pair_peak_force_error")
    row.pair_holds = pick(data, "pair_holds", "holds")
    return row


def read(data):
    """From the JSON object; an empty object gives an empty calibration."""
    parameters = [parameter_of(name, item) for name, item in (data.get("parameters") or {}).items()]
    published = data.get("published") if isinstance(data.get("published"), dict) else {}
    found = Calibration(parameters=[p for p in parameters if p])
    for parameter in found.parameters:
        value = pick(published, parameter.name)
        value = value.get("value") if isinstance(value, dict) else value
        parameter.published = value if is_number(value) else PUBLISHED.get(parameter.name)
    for name in ("correlation", "derived", "fit", "prediction"):
        if isinstance(data.get(name), dict):
            setattr(found, name, data[name])
    found.condition = data.get("condition")
    found.notes = [str(note) for note in data.get("notes") or []]
    found.fitted_on = data.get("fitted_on") or ""
    _read_windows(found, data)
    grazing = data.get("grazing") or data.get("critical_amplitudes") or data.get("critical") or []
    found.grazing = [item for item in grazing if isinstance(item, dict)] if isinstance(grazing, list) else [
        {"scene": key, **value} for key, value in grazing.items() if isinstance(value, dict)]
    return found


def _read_windows(found, data):
    windows = data.get("windows") or {}
    table = windows if isinstance(windows, dict) else {"rows": windows}
    rows = [_window_row(row) for row in table.get("rows") or [] if isinstance(row, dict)]
    found.windows = sorted((row for row in rows if is_number(row.speed)), key=lambda row: row.speed)
    said = data.get("validity") or data.get("range_of_validity") or table
    if isinstance(said, str):
        found.validity = said
        said = table
    found.validity = found.validity or said.get("sentence") or table.get("sentence") or ""
    found.valid_from, found.valid_to = pick(said, "valid_from", "from"), pick(said, "valid_to", "to")
    found.tolerance = pick(said, "tolerance") or table.get("tolerance")

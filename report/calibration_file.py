"""calibration.json as the chapters behind the first page need it, its types checked before; absent parts are empty.

Extra keys of the file are read under the names the calibration module writes; a unit suffix may follow a name."""
from dataclasses import dataclass, field
from typing import Any

from .numbers import is_number

PAIR_LAWS = ("signed", "no-tension", "printed")  # whose k_i and e are a constant pair
UNITS = ("", "_m_s", "_kN_per_m", "_N", "_s", "_m", "_g")


def pick(tree: dict[str, Any], name: str) -> Any:
    """The value of a key that may carry its SI unit: speed or speed_m_s. None when it is not there."""
    return next((tree[name + unit] for unit in UNITS if tree.get(name + unit) is not None), None)


@dataclass
class Parameter:
    name: str
    value: float
    unit: str = ""
    standard_error: float | None = None
    interval: tuple[float, float] | None = None
    identifiable: bool | None = None
    reason: str = ""
    published: float | None = None


@dataclass
class WindowRow:
    """What one isolated impact says. k_i in kN/m, speeds in m/s."""
    speed: float
    folder: str = ""
    k_i: Parameter | None = None
    e: Parameter | None = None
    peak_force_N: float | None = None
    contact_time_s: float | None = None
    restitution: float | None = None
    pair_force_error: float | None = None
    pair_holds: bool | None = None


@dataclass
class Calibration:
    parameters: list[Parameter] = field(default_factory=list)
    correlation: dict[str, Any] = field(default_factory=dict)
    condition: float | None = None
    derived: dict[str, Any] = field(default_factory=dict)
    fit: dict[str, Any] = field(default_factory=dict)
    prediction: dict[str, Any] = field(default_factory=dict)
    windows: list[WindowRow] = field(default_factory=list)
    validity: str = ""
    valid_from: float | None = None
    valid_to: float | None = None
    tolerance: float | None = None
    grazing: list[dict[str, Any]] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    fitted_on: str = ""
    search: dict[str, Any] = field(default_factory=dict)
    answer: dict[str, Any] = field(default_factory=dict)
    laws: list[dict[str, Any]] = field(default_factory=list)  # the rows of calibration.json, the best first
    laws_sentence: str = ""
    constant_pair: dict[str, Any] = field(default_factory=dict)
    speed_laws: dict[str, Any] = field(default_factory=dict)
    profiles: dict[str, Any] = field(default_factory=dict)
    published_applies: bool = False  # the thesis's pair may be named: it is the thesis's bearing

    @property
    def law(self) -> str:
        """The answer's law."""
        return self.answer.get("law", {}).get("name") or ""

    @property
    def answer_row(self) -> dict[str, Any]:
        """The row of `laws` that is the answer's very fit, the same numbers; empty where the answer was fitted apart."""
        answered = {name: p.get("value") for name, p in self.answer.get("law", {}).get("parameters", {}).items()}
        return next((row for row in self.laws if self.law and row.get("law") == self.law
                     and {name: p.get("value") for name, p in row.get("parameters", {}).items()} == answered), {})

    @property
    def other_rows(self) -> list[dict[str, Any]]:
        """The rows of `laws` that are not the answer."""
        answer = self.answer_row
        return [row for row in self.laws if row is not answer]

    @property
    def mass_kg(self) -> float | None:
        """Supported mass of the runs fitted."""
        mass = self.derived.get("masses", {}).get("m1_kg") if isinstance(self.derived.get("masses"), dict) else None
        return next((m for m in (self.answer.get("mass_kg"), mass) if is_number(m)), None)

    @property
    def is_pair(self) -> bool:
        """Whether `parameters` are a constant pair; other laws' k_i is only where their curve begins."""
        return self.derived.get("law") in PAIR_LAWS

    def pair(self, name: str) -> Parameter | None:
        return self.parameter(name) if self.is_pair else None

    def parameter(self, name: str) -> Parameter | None:
        return next((p for p in self.parameters if p.name == name), None)

    def role(self, run_name: str) -> str | None:
        """fit | predict, or None for a run the calibration did not use."""
        for role, table in (("fit", self.fit), ("predict", self.prediction)):
            if any(last_part(key) == run_name for key in table):
                return role
        return None


def last_part(folder: str) -> str:
    return folder.rstrip("/").split("/")[-1]


def parameter_of(name: str, data: dict[str, Any] | None) -> Parameter | None:
    if not data or not is_number(data.get("value")):
        return None
    limits = data.get("interval_95", [])
    return Parameter(name, data["value"], data.get("unit", ""), data.get("standard_error"),
                     (limits[0], limits[1]) if len(limits) == 2 else None, data.get("identifiable"), data.get("reason", ""))


def _window_row(data: dict[str, Any]) -> WindowRow:
    own = data.get("parameters", {})
    row = WindowRow(pick(data, "speed"), data.get("folder", ""))
    row.k_i = parameter_of("k_i", own.get("k_i"))
    row.e = parameter_of("e", own.get("e"))
    row.peak_force_N = pick(data, "peak_force")
    row.contact_time_s = pick(data, "contact_time")
    row.restitution = pick(data, "restitution")
    row.pair_force_error = data.get("pair_force_error")
    row.pair_holds = data.get("pair_holds")
    return row


def read(data: dict[str, Any]) -> Calibration:
    """From the JSON object; an empty object gives an empty calibration."""
    parameters = [parameter_of(name, item) for name, item in data.get("parameters", {}).items()]
    order = {"k_i": 0, "e": 1}
    found = Calibration(parameters=sorted((p for p in parameters if p), key=lambda p: order.get(p.name, 2)))
    found.published_applies = data.get("answer", {}).get("published_applies", False)
    if found.published_applies:
        for parameter in found.parameters:
            parameter.published = data.get("published", {}).get(parameter.name, {}).get("value")
    found.answer = data.get("answer", {})
    found.correlation, found.derived, found.search = (data.get(name, {}) for name in ("correlation", "derived", "search"))
    found.fit, found.prediction = data.get("fit", {}), data.get("prediction", {})
    found.condition = data.get("condition")
    found.notes = data.get("notes", [])
    found.fitted_on = data.get("fitted_on", "")
    _read_windows(found, data)
    _read_laws(found, data)
    found.grazing = data.get("critical_amplitudes", [])
    return found


def _read_windows(found: Calibration, data: dict[str, Any]) -> None:
    table = data.get("windows", {})
    rows = [_window_row(row) for row in table.get("rows", [])]
    found.windows = sorted((row for row in rows if is_number(row.speed)), key=lambda row: row.speed)
    found.tolerance = table.get("tolerance")
    if found.is_pair:  # they speak of a constant pair
        found.validity = table.get("sentence", "")
        found.valid_from, found.valid_to = pick(table, "valid_from"), pick(table, "valid_to")


def _read_laws(found: Calibration, data: dict[str, Any]) -> None:
    laws = data.get("laws", {})
    found.laws, found.laws_sentence = laws.get("rows", []), laws.get("sentence", "")
    found.constant_pair = data.get("constant_pair", {})
    found.speed_laws, found.profiles = data.get("speed_laws", {}), data.get("profiles", {})

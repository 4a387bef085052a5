"""What was done to get the answer: runs, rung, mesh, machine time."""
from ..context import Context
from ..numbers import duration, is_number, plain
from ..results import Results
from ..run_folder import Run


def done(context: Context) -> list[str]:
    """Sentences."""
    results = context.results
    if results.single:
        return [_single(results.only)]
    runs = [entry.fe for entry in results.entries if entry.fe is not None]
    return [part for part in (_finite(runs) if runs else _fitted(results), _time(results, runs)) if part]


def _single(run: Run) -> str:
    s = run.summary
    time = f", {duration(s['wall_time_s'])}" if is_number(s.get("wall_time_s")) else ""
    if run.rung == "reduced":
        return f"Reduced model {run.get('reduced', 'model', default='')}{time}."
    mesh = f", mesh {plain(s['mesh'])}" if is_number(s.get("mesh")) else ""
    return f"Finite elements, rung {run.rung}{mesh}, {plain(s.get('n_dofs'))} unknowns{time}."


def _finite(runs: list[Run]) -> str:
    kinds: dict[str, list[Run]] = {}
    for run in runs:
        mesh = f", mesh {plain(run.summary['mesh'])}" if is_number(run.summary.get("mesh")) else ""
        kinds.setdefault(f"rung {run.rung}{mesh}", []).append(run)
    parts = []
    for kind, those in kinds.items():
        windows = sum(run.kind == "window" for run in those)
        said = [_count(windows, "single impact"), _count(len(those) - windows, "ground motion")]
        parts.append(f"{' and '.join(s for s in said if s)} by finite elements ({kind})")
    return "; ".join(parts)[:1].upper() + "; ".join(parts)[1:] + "."


def _count(n: int, what: str) -> str:
    return f"{n} {what}{'s' if n > 1 else ''}" if n else ""


def _fitted(results: Results) -> str:
    answer, law = results.answer, results.answer.get("law", {})
    if not answer:
        return ""
    n = law.get("n_runs")
    said = f"Law fitted to {plain(n)} {'runs' if n != 1 else 'run'}" if is_number(n) else "Law fitted"
    source = {"measured": "measured curves", "finite elements": "finite-element runs"}.get(answer.get("source", ""), answer.get("source", ""))
    rung = answer.get("rung")
    rung = ", ".join(rung) if isinstance(rung, list) else rung
    detail = f", rung {rung}, mesh {plain(answer.get('mesh'))}" if answer.get("source") == "finite elements" and rung else ""
    return f"{said} ({source}{detail})."


def _time(results: Results, runs: list[Run]) -> str:
    seconds = sum(run.summary.get("wall_time_s", 0.0) for run in runs)
    total = results.main.get("totals", {}).get("wall_time_s")
    parts = [f"{duration(seconds)} of finite elements, added up" if runs and seconds else "", f"{duration(total)} from start to end" if is_number(total) else ""]
    said = "; ".join(part for part in parts if part)
    processor = results.main.get("machine", {}).get("processor")
    return f"Machine time: {said}" + (f", on {processor}." if processor else ".") if said else ""

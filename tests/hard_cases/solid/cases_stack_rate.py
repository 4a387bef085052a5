"""Hard cases of rungs rigid-dish and full once more, with steel that knows its rate (Cowper and Symonds, mild steel)."""
import cases_stack
from cases_rim_rate import with_rate


def cases(program, folder):
    return with_rate(cases_stack.cases(program, folder))


MESH = cases_stack.MESH
NOTES = ""

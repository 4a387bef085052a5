"""Hard cases of rung rim once more, with steel that knows its rate (Cowper and Symonds, mild steel)."""
import cases_rim

CLOSE = 0.003  #: a step's rate is that of its end: the peak force moves by 0.2 % with the steps
RATE = ['bearing.material.steel.rate="cowper-symonds"']


def with_rate(of_static):
    return [(name, starred, (scene, [*settings, *RATE]), expected, check) for name, starred, (scene, settings), expected, check in of_static]


def cases(program, folder):
    return with_rate(cases_rim.cases(program, folder, CLOSE))


MESH = cases_rim.MESH
NOTES = ""

"""Hard cases of rung rim once more, with steel that knows its rate (Cowper and Symonds, mild steel)."""
import cases_rim

RATE = ['bearing.material.steel.rate="cowper-symonds"']


def cases(program, folder):
    return [(name, starred, (scene, [*settings, *RATE]), expected, check) for name, starred, (scene, settings), expected, check in cases_rim.cases(program, folder)]


MESH = cases_rim.MESH
NOTES = ""

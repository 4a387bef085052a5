"""Signs and words, so that nobody has to guess."""
from ..blocks import Section, table
from ..context import Context

ROWS = [
    ["Displacement u", "of the upper slider relative to the plate, which is fixed. u_z is positive upwards, zero at the "
     "dish's vertex."],
    ["Force F", "what the bearing does to the supported mass; the sum of pendular, friction and impact parts. It is drawn "
     "as −F, so that a positive displacement meets a positive force. Peaks are of the horizontal norm."],
    ["Ground acceleration", "positive along +axis; the load on the mass is −m a_g."],
    ["Gap, penetration", "gap = L_c − |u|, u less the slip of a slider of two halves, negative while the rim is pressed; penetration = −gap. Finite elements also "
     "know the smallest distance of the walls: a yielded rim is touched later than L_c."],
    ["Touch, release", "first instant of non-zero rim force, and where the force, falling as at its last samples, is gone."],
    ["Rebound over approach", "radial speed at release over that at touch. It is not e: ground motion, slope and friction "
     "act during contact. Only an impact window isolates the impact."],
    ["k_i, e, c_i", "stiffness, restitution and dashpot of the reduced model's impact element; c_i = 2 ξ √(k_i m) with "
     "ξ = −ln e / √(π² + ln² e), m the supported mass, the rim fixed."],
    ["Errors", "signed and relative to the reference: finite elements, or measured curves."],
    ["Rung", "what is solid: `rim` means rim sector and upper slider as elastoplastic solids, the rest reduced; "
     "`rigid-dish` and `full` are finer, `reduced` has no solid at all."],
]


def make(_context: Context) -> Section:
    section = Section("conventions", "Signs and terms")
    section.add(table(["term", "meaning"], ROWS, left=2, prose=True))
    return section

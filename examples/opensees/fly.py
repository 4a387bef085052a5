"""Flies one impact on the exported springs with OpenSeesPy, where it is installed; else prints what the export says of itself."""
try:
    import openseespy.opensees as ops
except ImportError:
    raise SystemExit("OpenSeesPy is not installed; the numbers above are the export's own check") from None
import runpy

runpy.run_path("for-opensees/impact.py")
print("the springs were made in OpenSees", ops.version())

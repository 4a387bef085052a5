"""Figures and the HTML report of rimpact, made from stored run folders only (no solver is called from here).

Entry points (each `python3 -m report...` with the source directory on PYTHONPATH, or from it):
  report DIR [--output FILE]         one self-contained HTML file of a run folder, a `main` results folder, a calibration, a sweep
  report.quick KIND DIR              DIR/response.png, four panels of one run; DIR/fleet.png of a sweep
  report.film DIR                    DIR/film.html, a film of a run's stored fields
  report.motion CSV PNG              a ground motion: acceleration, velocity, displacement
  report.rim_picture FILE.vtu PNG    the deformed rim and slider coloured by plastic strain
  report.mesh_picture FILE.msh PNG   a hexahedral mesh with its named groups
Exit codes are those of the `rimpact` command: 2 command line, 3 unreadable data, 6 reading or writing failed.
"""

"""The report of a reliability study: `python3 -m report.reliability DIR` writes DIR/report.html from the study's tables."""

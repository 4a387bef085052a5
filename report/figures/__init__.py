"""One file a figure family. Each `draw...(…, path)` writes one PNG and returns its path; nothing is computed here
beyond what is drawn."""

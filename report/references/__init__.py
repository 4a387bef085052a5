"""The finite-element references that are kept with the program: listed, made again, held against what is kept."""

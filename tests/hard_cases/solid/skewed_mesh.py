"""The built-in mesh with its inner nodes shifted at random, as a mesh of one's own."""
import collections
import itertools
import random
import subprocess

HEXAHEDRON = 12  # gmsh's type of 27 nodes: corners first, then the middles of these edges and faces
EDGES = ((0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 7), (5, 6), (6, 7))
FACES = ((0, 1, 2, 3), (0, 1, 4, 5), (0, 3, 4, 7), (1, 2, 5, 6), (2, 3, 6, 7), (4, 5, 6, 7))


def skewed(program, file, share):
    """Writes `file`: every corner inside a body moved by up to `share` of its shortest edge, the middles of edges, faces and
    cells with their corners; returns the settings that use it."""
    subprocess.run([program, "mesh", "--scene", "impact-window", "--curved", "-o", str(file), "--quiet"], check=True, stdout=subprocess.DEVNULL)
    lines = file.read_text().splitlines()
    start, end = lines.index("$Nodes") + 2, lines.index("$EndNodes")
    nodes = {int(words[0]): [float(x) for x in words[1:]] for words in map(str.split, lines[start:end])}
    elements = [[int(word) for word in line.split()] for line in lines[lines.index("$Elements") + 2:lines.index("$EndElements")]]
    cells = [words[3 + words[2]:] for words in elements if words[1] == HEXAHEDRON]
    sides = [(frozenset(cell[k] for k in face), cell, face, n) for cell in cells for n, face in enumerate(FACES)]
    shared = collections.Counter(side for side, *_ in sides)
    held = set()  # on a body's boundary
    for side, cell, face, n in sides:
        if shared[side] == 1:
            held.update(side, (cell[20 + n],), (cell[8 + e] for e, edge in enumerate(EDGES) if set(edge) <= set(face)))

    shortest, shifts, generator = {}, {}, random.Random(1)
    for a, b in (pair for cell in cells for pair in itertools.permutations(cell[:8], 2)):
        length = sum((x - y) ** 2 for x, y in zip(nodes[a], nodes[b])) ** 0.5
        shortest[a] = min(shortest.get(a, length), length)
    for node, length in shortest.items():
        shifts[node] = [0.0] * 3 if node in held else [share * length * generator.uniform(-1, 1) for _ in range(3)]
    for cell in cells:
        for node, around in zip(cell[8:], (*EDGES, *FACES, range(8))):
            if node not in held:
                shifts[node] = [sum(shift) / len(shift) for shift in zip(*(shifts[cell[k]] for k in around))]
    for node, shift in shifts.items():
        nodes[node] = [x + dx for x, dx in zip(nodes[node], shift)]
    lines[start:end] = [f"{node} {' '.join(map(repr, x))}" for node, x in nodes.items()]
    file.write_text("\n".join(lines) + "\n")
    return [f'model.own_mesh.file="{file.resolve()}"', 'model.own_mesh.unit="m"']

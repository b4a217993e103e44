"""Compares VTK, VTU, PLY, STL, Gmsh, TetGen and Abaqus files with meshio: it has to read from our files what we wrote, and we have to read from its files what it wrote.

    second_opinion.py EXCHANGE FOLDER     EXCHANGE: the program built from exchange.cpp; FOLDER: for the files

Not compared, because meshio cannot: polyhedra (its legacy VTK reader refuses cell type 42, and its VTU reader takes them for other cells), for which
tests/io/detail/vtk/read_vtk_test.cpp has files that follow VTK's documentation; and POLYDATA, which it does not read and we do not write.
"""

import os
import subprocess
import sys

import meshio
import numpy as np

FACES = {"triangle": 1, "quad": 1, "polygon": 1, "tetra": 4, "hexahedron": 6, "wedge": 5, "pyramid": 5}


def descriptions(text):
    """The meshes that the program describes, by name."""
    meshes = {}
    for line in text.splitlines():
        word, *rest = line.split()
        if word == "file":
            mesh = meshes[rest[0]] = {"points": [], "cells": [], "vert": {}, "poly": {}, "names": {}}
        elif word == "point":
            mesh["points"].append([float(x) for x in rest])
        elif word == "cell":
            mesh["cells"].append((int(rest[0]), frozenset(int(v) for v in rest[1:])))
        elif word == "name":
            mesh["names"][rest[0]] = [int(x) for x in rest[1:]]
        else:
            mesh[word][rest[0]] = [float(x) for x in rest[1:]]
    return meshes


def description_of(mesh):
    """The same of a mesh of meshio. The cells of one type are a block."""
    cells = []
    for block in mesh.cells:
        kind = "polygon" if block.type.startswith("polygon") else block.type
        cells += [(FACES[kind], frozenset(int(v) for v in cell)) for cell in block.data]
    return {
        "points": np.asarray(mesh.points).tolist(),
        "cells": cells,
        "vert": {name: np.asarray(values, dtype=float).ravel().tolist() for name, values in mesh.point_data.items()},
        "poly": {name: np.concatenate([np.asarray(v, dtype=float).ravel() for v in blocks]).tolist() for name, blocks in mesh.cell_data.items()},
        "names": {name: np.asarray(values).tolist() for name, values in mesh.field_data.items()},
    }


def equal(ours, theirs, digits):
    if digits is None or ours is None or theirs is None:
        return ours == theirs
    return np.shape(ours) == np.shape(theirs) and np.allclose(ours, theirs, rtol=10.0**-digits, atol=0)


def compare(name, ours, theirs, digits=None):
    """The differences, one line each. Numbers have to be equal to the last bit, or to a number of digits."""
    wrong = []
    for what in ("points", "cells", "names"):
        if not equal(ours[what], theirs[what], digits if what == "points" else None):
            wrong.append(f"{name}: {what}: ours {ours[what]}, meshio's {theirs[what]}")
    for kind in ("vert", "poly"):
        for key in sorted(set(ours[kind]) | set(theirs[kind])):
            if not equal(ours[kind].get(key), theirs[kind].get(key), digits):
                wrong.append(f"{name}: {kind} {key}: ours {ours[kind].get(key)}, meshio's {theirs[kind].get(key)}")
    return wrong


def joined(mesh):
    """A description of a PLY file, with the components of a vector in three columns made one."""
    parts = [mesh["vert"].pop(f"velocity_{x}") for x in "xyz" if f"velocity_{x}" in mesh["vert"]]
    if parts:
        mesh["vert"]["velocity"] = np.stack(parts, axis=1).ravel().tolist()
    return mesh


def triangles(mesh, binary):
    """The triangles of an STL file, by the points of their corners, which binary files round to floats."""
    points = np.asarray(mesh["points"], dtype=np.float32 if binary else float).tolist()
    return [frozenset(tuple(points[v]) for v in verts) for _, verts in mesh["cells"]]


def compare_stl(name, ours, theirs):
    a, b = triangles(ours, "binary" in name), triangles(theirs, "binary" in name)
    return [] if a == b else [f"{name}: ours {a}, meshio's {b}"]


def compare_surfaces(program, folder):
    """PLY and STL files that meshio writes. Result: the differences, and how many files there are."""
    wrong, compared = [], 0
    name, points, cells = [m for m in meshes_of_meshio() if m[0] == "surface"][0]
    blocks = [(kind, np.array(block)) for kind, block in cells]
    for kind in ("ply", "stl"):
        mesh = meshio.Mesh(points, blocks if kind == "ply" else blocks[:1], point_data={"heat": np.linspace(0, 1, len(points)) / 3} if kind == "ply" else {})
        for binary in (False, True):
            path = os.path.join(folder, f"meshio_{name}_{'binary' if binary else 'text'}.{kind}")
            meshio.write(path, mesh, file_format=kind, binary=binary)
            read = subprocess.run([program, "read", path], capture_output=True, text=True)
            compared += 1
            if read.returncode != 0:
                wrong.append(f"{path}: {read.stderr}")
            elif kind == "ply":
                wrong += compare(path, descriptions(read.stdout)[path], description_of(mesh))
            else:
                wrong += compare_stl(path, descriptions(read.stdout)[path], description_of(mesh))
    return wrong, compared


def without_entities_of_points(mesh):
    """A description without what version 4.1 has for points, and a mesh of ours does not keep."""
    mesh["vert"].pop("gmsh:dim_tags", None)
    return mesh


def compare_gmsh(program, folder):
    """Gmsh files of versions 2.2 and 4.1 that meshio writes, of which the blocks are entities with groups."""
    wrong, compared = [], 0
    for name, points, cells in meshes_of_meshio():
        dimension = 2 if name == "surface" else 3
        blocks = [(kind, np.array(block)) for kind, block in cells]
        number = [np.arange(len(block), dtype=float) / 3 for _, block in blocks]
        for kind in ("gmsh22", "gmsh"):
            tags = {"gmsh:physical": [np.full(len(b), 5 + i, dtype=np.int32) for i, (_, b) in enumerate(blocks)],
                    "gmsh:geometrical": [np.full(len(b), 30 + i, dtype=np.int32) for i, (_, b) in enumerate(blocks)]}
            values = {"heat": np.linspace(0, 1, len(points)) / 3, "velocity": np.linspace(-1, 1, 3 * len(points)).reshape(-1, 3) / 7}
            entities = {"gmsh:dim_tags": np.array([[dimension, 30 + v * len(blocks) // len(points)] for v in range(len(points))])} if kind == "gmsh" else {}
            mesh = meshio.Mesh(points, blocks, point_data={**values, **entities}, cell_data={**tags, "pressure": number},
                               field_data={"steel": np.array([5, dimension]), "wood": np.array([6, dimension])})
            for binary in (False, True):
                path = os.path.join(folder, f"meshio_{name}_{kind}_{'binary' if binary else 'text'}.msh")
                meshio.write(path, mesh, file_format=kind, binary=binary)
                read = subprocess.run([program, "read", path], capture_output=True, text=True)
                compared += 1
                if read.returncode != 0:
                    wrong.append(f"{path}: {read.stderr}")
                    continue
                wrong += compare(path, descriptions(read.stdout)[path], without_entities_of_points(description_of(mesh)))
    return wrong, compared


def compare_tetgen_and_abaqus(program, folder):
    """TetGen and Abaqus files that meshio writes. Result: the differences, and how many files there are."""
    wrong, compared = [], 0
    for name, points, cells in meshes_of_meshio():
        for kind in ("ele", "inp"):
            blocks = [(shape, np.array(block)) for shape, block in cells if shape != "pyramid"]  # it has no such type of Abaqus
            if kind == "ele" and name != "tets":
                continue
            path = os.path.join(folder, f"meshio_{name}.{kind}")
            mesh = meshio.Mesh(points, blocks)
            meshio.write(path, mesh)
            read = subprocess.run([program, "read", path], capture_output=True, text=True)
            compared += 1
            if read.returncode != 0:
                wrong.append(f"{path}: {read.stderr}")
            else:
                wrong += compare(path, descriptions(read.stdout)[path], description_of(mesh))
    return wrong, compared


def meshes_of_meshio():
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1.25], [1, 0, 1], [1, 1, 1], [0, 1, 1], [0.5, 0.5, 2], [2, 0, 1 / 3], [2, 1, 0.5]])
    yield "tets", points, [("tetra", [[0, 1, 2, 5], [0, 2, 3, 7]])]
    yield "mixed", points, [("hexahedron", [[0, 1, 2, 3, 4, 5, 6, 7]]), ("pyramid", [[4, 5, 6, 7, 8]]), ("tetra", [[1, 9, 5, 8]]), ("wedge", [[1, 5, 9, 2, 6, 10]])]
    yield "surface", points, [("triangle", [[0, 1, 4], [1, 5, 4]]), ("quad", [[0, 1, 2, 3], [1, 9, 10, 2]])]


def main(program, folder):
    wrong, compared = [], 0
    os.makedirs(folder, exist_ok=True)
    written = subprocess.run([program, "write", folder], check=True, capture_output=True, text=True).stdout
    for name, ours in descriptions(written).items():
        theirs = description_of(meshio.read(os.path.join(folder, name)))
        wrong += compare_stl(name, ours, theirs) if name.endswith(".stl") else compare(name, ours, joined(theirs))
        compared += 1

    for name, points, cells in meshes_of_meshio():
        number = [np.arange(len(block), dtype=np.int64) + 10 * i for i, (_, block) in enumerate(cells)]
        mesh = meshio.Mesh(
            points,
            [(kind, np.array(block)) for kind, block in cells],
            point_data={"heat": np.linspace(0, 1, len(points)) / 3, "velocity": np.linspace(-1, 1, 3 * len(points)).reshape(-1, 3) / 7},
            cell_data={"number": number, "pressure": [n / 7 for n in number]},
        )
        for kind, options in (
            ("vtk", {"binary": False}), ("vtk", {"binary": True}), ("vtk42", {"binary": False}), ("vtk42", {"binary": True}),
            ("vtu", {"binary": False, "compression": None}), ("vtu", {"binary": True, "compression": None}), ("vtu", {"binary": True, "compression": "zlib"}),
        ):
            path = os.path.join(folder, f"meshio_{name}_{kind}_{'_'.join(str(v) for v in options.values())}.{kind[:3]}")
            meshio.write(path, mesh, file_format=kind, **options)
            read = subprocess.run([program, "read", path], capture_output=True, text=True)
            if read.returncode != 0:
                wrong.append(f"{path}: {read.stderr}")
                continue
            digits = 11 if kind == "vtu" and not options["binary"] else None  # meshio writes no more
            wrong += compare(path, descriptions(read.stdout)[path], description_of(mesh), digits)
            compared += 1
    for compare_others in (compare_surfaces, compare_gmsh, compare_tetgen_and_abaqus):
        others, num_others = compare_others(program, folder)
        wrong += others
        compared += num_others
    print(f"{compared} files compared, {len(wrong)} differences")
    print("\n".join(wrong))
    return 1 if wrong or compared != 84 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2]))

"""Compares the orders of cells with VTK: what VTK writes has to be read without a remark, and what we write has to be valid for VTK, with the same volumes.

    compare.py EXCHANGE FOLDER     EXCHANGE: the program built from exchange.cpp; FOLDER: for the files

Volumes and areas are those of vtkCellSizeFilter, and vtkCellValidator checks every cell before and after. Polygons have to look up.
"""

import os
import subprocess
import sys

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdList, vtkOutputWindow, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersGeneral import vtkCellValidator
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter, vtkUnstructuredGridReader, vtkUnstructuredGridWriter
from vtkmodules.vtkIOParallelXML import vtkXMLPUnstructuredGridWriter
from vtkmodules.vtkIOXML import (vtkXMLPolyDataReader, vtkXMLPolyDataWriter, vtkXMLPUnstructuredGridReader, vtkXMLUnstructuredGridReader,
                                 vtkXMLUnstructuredGridWriter)


# convex polygons with their areas
RINGS = {
    5: ([(0, 0), (2, 0), (3, 1), (1, 2), (-1, 1)], 5),
    6: ([(0, 0), (2, 0), (3, 1), (2, 2), (0, 2), (-1, 1)], 6),
    7: ([(0, 0), (2, 0), (3, 1), (3, 2), (2, 3), (0, 3), (-1, 1)], 9.5),
}


def prism(n):
    return [(x, y, z) for z in (0, 1) for x, y in RINGS[n][0]]


CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
WRONG_FACES = 0x20  # a state of vtkCellValidator
# type: points, measure of each poly that it becomes, types of these when we write them, and the faces of a polyhedron
CELLS = {
    10: ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [1 / 6], [10], None),
    11: ([CUBE[i] for i in (0, 1, 3, 2, 4, 5, 7, 6)], [1], [12], None),
    12: (CUBE, [1], [12], None),
    13: ([(0, 0, 0), (0, 1, 0), (1, 0, 0), (0, 0, 1), (0, 1, 1), (1, 0, 1)], [0.5], [13], None),
    14: (CUBE[:4] + [(0.5, 0.5, 1)], [1 / 3], [14], None),
    15: (prism(5), [RINGS[5][1]], [42], None),
    16: (prism(6), [RINGS[6][1]], [42], None),
    42: (prism(7), [RINGS[7][1]], [42], [list(range(6, -1, -1)), list(range(7, 14))] + [[i, (i + 1) % 7, 7 + (i + 1) % 7, 7 + i] for i in range(7)]),
    5: ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [0.5], [5], None),
    6: ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 2, 0)], [0.5, 0.5, 0.5], [5, 5, 5], None),
    7: ([(x, y, 0) for x, y in RINGS[7][0]], [RINGS[7][1]], [7], None),
    8: ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)], [1], [9], None),
    9: (CUBE[:4], [1], [9], None),
}


def add_numbers(data, numbers):
    values = vtkDoubleArray()
    values.SetName("number")
    for x in numbers:
        values.InsertNextValue(x)
    data.GetCellData().AddArray(values)
    return data


def grid_of(types, mirrored=False):
    grid, points = vtkUnstructuredGrid(), vtkPoints()
    points.SetDataTypeToDouble()
    grid.SetPoints(points)
    for k, t in enumerate(types):
        corners, _, _, faces = CELLS[t]
        first = points.GetNumberOfPoints()
        for x, y, z in corners:
            points.InsertNextPoint(x + 8 * k, y, -z if mirrored else z)
        if faces is None:
            grid.InsertNextCell(t, len(corners), [first + i for i in range(len(corners))])
            continue
        stream = vtkIdList()
        stream.InsertNextId(len(faces))
        for face in faces:
            stream.InsertNextId(len(face))
            for v in face:
                stream.InsertNextId(first + v)
        grid.InsertNextCell(t, stream)
    return add_numbers(grid, [100 + k for k in range(len(types))])


def polydata():
    """Verts, lines, polygons and strips, with a number for each in this order."""
    data, points = vtkPolyData(), vtkPoints()
    points.SetDataTypeToDouble()
    data.SetPoints(points)

    def cells(lists):
        array = vtkCellArray()
        for corners in lists:
            first = points.GetNumberOfPoints()
            for p in corners:
                points.InsertNextPoint(p)
            array.InsertNextCell(len(corners), [first + i for i in range(len(corners))])
        return array

    data.SetStrips(cells([CELLS[6][0]]))
    data.SetPolys(cells([CELLS[9][0], CELLS[5][0]]))
    data.SetLines(cells([CELLS[5][0]]))
    data.SetVerts(cells([CELLS[5][0][:1], CELLS[5][0][:2]]))
    return add_numbers(data, [100, 101, 102, 103, 104, 105])


def write(data, folder, name):
    """Writes data in all forms that VTK has. Returns the paths."""
    is_grid, paths = isinstance(data, vtkUnstructuredGrid), []
    for version in (42, 51):
        for binary in (False, True):
            w = vtkUnstructuredGridWriter() if is_grid else vtkPolyDataWriter()
            w.SetFileVersion(version)
            w.SetFileTypeToBinary() if binary else w.SetFileTypeToASCII()
            paths.append((w, f"{name}_{version}_{'binary' if binary else 'text'}.vtk"))
    for mode in ("Ascii", "Binary", "Appended"):
        w = vtkXMLUnstructuredGridWriter() if is_grid else vtkXMLPolyDataWriter()
        getattr(w, f"SetDataModeTo{mode}")()
        w.SetCompressorTypeToNone()
        paths.append((w, f"{name}_{mode}.{'vtu' if is_grid else 'vtp'}"))
    if is_grid:
        w = vtkXMLPUnstructuredGridWriter()
        w.SetCompressorTypeToNone()
        paths.append((w, f"{name}_in_pieces.pvtu"))
    for w, file in paths:
        w.SetInputData(data)
        w.SetFileName(os.path.join(folder, file))
        if not w.Write():
            raise RuntimeError(f"VTK cannot write {file}")
    return [file for _, file in paths]


def read(path):
    reader = {".vtk": vtkUnstructuredGridReader, ".vtu": vtkXMLUnstructuredGridReader, ".vtp": vtkXMLPolyDataReader,
              ".pvtu": vtkXMLPUnstructuredGridReader}[os.path.splitext(path)[1]]()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def described(data):
    """Type, measure, number, validity, and whether it looks up, of each cell."""
    sizes, validator, cells = vtkCellSizeFilter(), vtkCellValidator(), []
    for f in (sizes, validator):
        f.SetInputData(data)
        f.Update()
    measured, states = sizes.GetOutput().GetCellData(), validator.GetOutput().GetCellData().GetArray("ValidityState")
    number = data.GetCellData().GetArray("number")
    for i in range(data.GetNumberOfCells()):
        cell = data.GetCell(i)
        looks_up = True
        if cell.GetCellDimension() == 2:
            p = [cell.GetPoints().GetPoint(k) for k in range(cell.GetNumberOfPoints())]
            looks_up = sum(p[k - 1][0] * p[k][1] - p[k - 1][1] * p[k][0] for k in range(len(p))) > 0
        size = measured.GetArray("Volume" if cell.GetCellDimension() == 3 else "Area").GetValue(i)
        cells.append((data.GetCellType(i), size, number.GetValue(i), states.GetValue(i), looks_up))
    return cells


def pieces_agree(path):
    """Whether the pieces of a .pvtu file are, by the numbers of points and cells, the mesh of the .vtu file of that name; and what is wrong if not."""
    whole, parts = read(path[:-5] + ".vtu"), read(path)
    point_ids, cell_ids = parts.GetPointData().GetGlobalIds(), parts.GetCellData().GetGlobalIds()
    if not point_ids or not cell_ids:
        return "no global ids"
    for i in range(parts.GetNumberOfPoints()):
        if parts.GetPoint(i) != whole.GetPoint(int(point_ids.GetTuple1(i))):
            return f"another place of point {i}"
    if {int(point_ids.GetTuple1(i)) for i in range(parts.GetNumberOfPoints())} != set(range(whole.GetNumberOfPoints())):
        return "not all points"
    cells = described(parts)
    order = sorted(range(len(cells)), key=lambda i: cell_ids.GetTuple1(i))
    return "" if [cells[i] for i in order] == described(whole) else "other cells"


def near(a, b):
    return len(a) == len(b) and all(abs(x - y) < 1e-9 for x, y in zip(a, b))


def expected_of(types):
    """The polys that a grid becomes: type, measure, number."""
    return [(t, m, 100 + k) for k, c in enumerate(types) for m, t in zip(CELLS[c][1], CELLS[c][2])]


def main(program, folder):
    os.makedirs(folder, exist_ok=True)
    vtkOutputWindow.SetGlobalWarningDisplay(0)
    wrong, compared, wanted = [], 0, {}
    volumes, surfaces = [t for t in CELLS if t >= 10], [t for t in CELLS if t < 10]
    lists = [[t] for t in CELLS] + [[t, t] for t in CELLS] + [volumes, surfaces, [13, 10], [13, 42], [11, 13], [10, 12, 13, 14, 42]]
    for types in lists:
        grid = grid_of(types)
        for k, (t, size, _, state, _) in enumerate(described(grid)):
            if state & WRONG_FACES or (t not in (6, 8) and abs(size - sum(CELLS[t][1])) > 1e-12):
                wrong.append(f"VTK does not accept cell {k} of types {types}: measure {size}, state {state:#x}")
        for file in write(grid, folder, "_".join(map(str, types))):
            wanted[file] = (expected_of(types), 0)
    for t in (10, 12, 13, 14, 15, 16, 42):
        for file in write(grid_of([t], mirrored=True), folder, f"mirrored_{t}"):
            wanted[file] = (expected_of([t]), 1)
    for file in write(polydata(), folder, "polydata"):
        wanted[file] = ([(9, 1, 103), (5, 0.5, 104)] + 3 * [(5, 0.5, 105)], 1)  # one remark: verts and lines are skipped

    ours = os.path.join(folder, "ours")
    os.makedirs(ours, exist_ok=True)
    printed = subprocess.run([program, ours] + [os.path.join(folder, file) for file in wanted], check=True, capture_output=True, text=True).stdout
    remarks, measures, numbers, file = {}, {}, {}, None
    for line in printed.splitlines():
        word, _, rest = line.partition(" ")
        if word == "file":
            file = rest
            remarks[file], measures[file], numbers[file] = [], [], []
        elif word == "note":
            remarks[file].append(rest)
        else:
            measures[file].append(float(rest.split()[0]))
            numbers[file].append(float(rest.split()[2]))
    for file, (polys, num_remarks) in wanted.items():
        compared += 1
        if len(remarks[file]) != num_remarks:
            wrong.append(f"{file}: {num_remarks} remarks expected, read with {remarks[file]}")
        if not near(measures[file], [m for _, m, _ in polys]) or numbers[file] != [n for _, _, n in polys]:
            wrong.append(f"{file}: {polys} expected, read as {measures[file]} {numbers[file]}")
        for form in ("_text", "_binary"):
            for extension in (".vtk", ".vtu") + ((".vtp",) if polys[0][0] < 10 else ()):
                cells = described(read(os.path.join(ours, file + form + extension)))
                compared += 1
                if any(state or not up for _, _, _, state, up in cells) or not near([c[1] for c in cells], [p[1] for p in polys]):
                    wrong.append(f"{file}{form}{extension}: not valid for VTK, {polys} expected: {cells}")
                if [(c[0], c[2]) for c in cells] != [(p[0], p[2]) for p in polys]:
                    wrong.append(f"{file}{form}{extension}: types and numbers of {polys} expected: {cells}")
    for file in wanted:
        for form in ("_text", "_binary"):
            compared += 1
            difference = pieces_agree(os.path.join(ours, file + form + ".pvtu"))
            if difference:
                wrong.append(f"{file}{form}.pvtu: {difference}")
    print(f"{compared} files compared, {len(wrong)} differences")
    print("\n".join(wrong[:50]))
    return 1 if wrong or compared < 1000 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2]))

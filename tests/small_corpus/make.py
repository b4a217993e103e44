#!/usr/bin/env python3
"""Writes the small meshes of this folder, and INDEX.tsv with their figures, which are computed here and not by the library.

The tests that read real files use these where the corpus is absent: tests/support/corpus.hpp. Usage: python3 make.py, in this folder.
"""
import itertools
import math
import os
from collections import defaultdict

GOLDEN = (1 + math.sqrt(5)) / 2


def sub(a, b): return tuple(x - y for x, y in zip(a, b))
def add(a, b): return tuple(x + y for x, y in zip(a, b))
def times(s, a): return tuple(s * x for x in a)
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def cross(a, b): return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
def unit(a): return times(1 / math.sqrt(dot(a, a)), a)


def vector_area(points):
    total = (0, 0, 0)
    for a, b in zip(points, points[1:] + points[:1]):
        total = add(total, cross(sub(a, points[0]), sub(b, points[0])))
    return times(0.5, total)


def mean(points): return times(1 / len(points), tuple(map(sum, zip(*points))))


def noise(k):
    """A number in [-1, 1] that looks random, the same everywhere."""
    x = math.sin(12.9898 * k + 4.1414) * 43758.5453
    return 2 * (x - math.floor(x)) - 1


def grid_surface(nx, ny, point, wrap_x=False, wrap_y=False, twist=False):
    """Quads of a grid whose sides may be joined; with twist, the first and the last column are joined upside down."""
    cols, rows = nx if wrap_x else nx + 1, ny if wrap_y else ny + 1
    points = [point(i / nx, j / ny) for j in range(rows) for i in range(cols)]

    def at(i, j):
        if wrap_x and i == nx:
            i, j = 0, (rows - 1 - j if twist else j)
        return (j % rows if wrap_y else j) * cols + i
    return points, [[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)] for j in range(ny) for i in range(nx)]


def triangles(mesh):
    points, faces = mesh
    return points, [[f[0], f[k], f[k + 1]] for f in faces for k in range(1, len(f) - 1)]


def icosphere(levels, centre=(0, 0, 0), radius=1):
    points = [unit(p) for s in (1, -1) for t in (GOLDEN, -GOLDEN) for p in ((0, s, t), (s, t, 0), (t, 0, s))]
    edge = min(math.dist(points[0], p) for p in points[1:])
    close = lambda a, b: abs(math.dist(points[a], points[b]) - edge) < 1e-9
    faces = [list(f) for f in itertools.combinations(range(12), 3) if close(f[0], f[1]) and close(f[1], f[2]) and close(f[0], f[2])]
    faces = [f if dot(vector_area([points[v] for v in f]), points[f[0]]) > 0 else f[::-1] for f in faces]
    for _ in range(levels):
        middle = {}

        def between(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                middle[key] = len(points)
                points.append(unit(add(points[a], points[b])))
            return middle[key]
        faces = [g for a, b, c in faces for ab, bc, ca in [(between(a, b), between(b, c), between(c, a))]
                 for g in ([a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca])]
    return [add(centre, times(radius, p)) for p in points], faces


def dual_of(mesh):
    """Of a closed convex surface around the origin: a polygon for each vert."""
    points, faces = mesh
    centres = [unit(mean([points[v] for v in f])) for f in faces]
    around = defaultdict(dict)
    for k, f in enumerate(faces):
        for a, b, c in zip(f[-1:] + f[:-1], f, f[1:] + f[:1]):
            around[b][a] = (c, k)
    polygons = []
    for v in range(len(points)):
        start = a = next(iter(around[v]))
        polygon = []
        while True:
            c, k = around[v][a]
            polygon.append(k)
            a = c
            if a == start:
                break
        polygons.append(polygon[::-1])
    polygons = [p if dot(vector_area([centres[v] for v in p]), centres[p[0]]) > 0 else p[::-1] for p in polygons]
    return centres, polygons


def united(*meshes):
    points, faces = [], []
    for p, f in meshes:
        faces += [[v + len(points) for v in face] for face in f]
        points += p
    return points, faces


def disk(rings):
    points, faces = [(0, 0, 0)], []
    for r in range(1, rings + 1):
        first = len(points)
        points += [(r / rings * math.cos(2 * math.pi * k / (6 * r)), r / rings * math.sin(2 * math.pi * k / (6 * r)), 0) for k in range(6 * r)]
        inner = 0 if r == 1 else first - 6 * (r - 1)
        for side in range(6):
            out = [first + (side * r + k) % (6 * r) for k in range(r + 1)]
            ins = [0] if r == 1 else [inner + (side * (r - 1) + k) % (6 * (r - 1)) for k in range(r)]
            faces += [[ins[k], out[k], out[k + 1]] for k in range(r)]
            faces += [[ins[k], out[k + 1], ins[k + 1]] for k in range(r - 1)]
    return points, faces


CUBE_FACES = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
TET_FACES = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]


def block(cells, size=(1, 1, 1), moved=0.0):
    """Hexes at the integer places `cells`, with inner and outer verts moved by up to `moved` of a cell."""
    numbers, points, hexes = {}, [], []
    for c in cells:
        corner = []
        for d in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)):
            place = add(c, d)
            if place not in numbers:
                numbers[place] = k = len(points)
                points.append(tuple(s * (x + moved * noise(3 * k + i)) for i, (s, x) in enumerate(zip(size, place))))
            corner.append(numbers[place])
        hexes.append(corner)
    return points, hexes


def boundary_of(hexes):
    points, cells = hexes
    seen = defaultdict(list)
    for c in cells:
        for f in CUBE_FACES:
            face = [c[v] for v in f]
            seen[tuple(sorted(face))].append(face)
    used, faces = {}, []
    for sides in seen.values():
        if len(sides) == 1:
            faces.append([used.setdefault(v, len(used)) for v in sides[0]])
    return [points[v] for v in used], faces


def kuhn(n, moved=0.0):
    """The unit cube in n x n x n cubes of six tets each. Vert (n + 1)^2 i + (n + 1) j + k is at (i, j, k) / n."""
    at = lambda p: (p[0] * (n + 1) + p[1]) * (n + 1) + p[2]
    points, tets = [], []
    for p in itertools.product(range(n + 1), repeat=3):
        inner = all(0 < x < n for x in p)
        points.append(tuple((x + (moved * noise(7 * at(p) + i) if inner else 0)) / n for i, x in enumerate(p)))
    for p in itertools.product(range(n), repeat=3):
        for order in itertools.permutations(range(3)):
            chain = [p]
            for axis in order:
                q = list(chain[-1])
                q[axis] += 1
                chain.append(tuple(q))
            tet = [at(q) for q in chain]
            a, b, c, d = (points[v] for v in tet)
            if dot(cross(sub(b, a), sub(c, a)), sub(d, a)) < 0:
                tet[2], tet[3] = tet[3], tet[2]
            tets.append(tet)
    return points, tets


def truncated_octahedra(n):
    """Kelvin's cells: truncated octahedra that fill space, at the sites of a body-centred lattice."""
    corners = set()
    for p in itertools.permutations((0, 1, 2)):
        for s in itertools.product((1, -1), repeat=3):
            corners.add(tuple(a * b for a, b in zip(p, s)))
    normals = [tuple(s if i == axis else 0 for i in range(3)) for axis in range(3) for s in (1, -1)] + list(itertools.product((1, -1), repeat=3))
    numbers, points, faces, cells, face_numbers = {}, [], [], [], {}
    sites = [times(4, c) for c in itertools.product(range(n), repeat=3)] + [add(times(4, c), (2, 2, 2)) for c in itertools.product(range(n), repeat=3)]
    for site in sites:
        cell = []
        for normal in normals:
            limit = 2 if sum(map(abs, normal)) == 1 else 3
            ring = [c for c in corners if dot(c, normal) == limit]
            centre = mean(ring)
            x = sub(ring[0], centre)
            y = cross(normal, x)
            ring.sort(key=lambda c: math.atan2(dot(sub(c, centre), y), dot(sub(c, centre), x) * math.sqrt(dot(normal, normal))))
            face = []
            for c in ring:
                place = add(site, c)
                if place not in numbers:
                    numbers[place] = len(points)
                    points.append(times(0.25, place))
                face.append(numbers[place])
            key = tuple(sorted(face))
            outward = key not in face_numbers
            if outward:
                face_numbers[key] = len(faces)
                faces.append(face)
            cell.append((face_numbers[key], outward))
        cells.append(cell)
    return points, faces, cells


def polyhedra_of(points, cells, shape):
    """Faces and cells of tets or hexes."""
    faces, numbers, out = [], {}, []
    for c in cells:
        cell = []
        for f in shape:
            face = [c[v] for v in f]
            key = tuple(sorted(face))
            outward = key not in numbers
            if outward:
                numbers[key] = len(faces)
                faces.append(face)
            cell.append((numbers[key], outward))
        out.append(cell)
    return points, faces, out


def joined_cells(mesh, label):
    """Cells of one label become one cell."""
    points, faces, cells = mesh
    groups = defaultdict(list)
    for k, c in enumerate(cells):
        groups[label(k)].append(c)
    kept, numbers, out = [], {}, []
    for group in groups.values():
        count = defaultdict(int)
        for c in group:
            for f, _ in c:
                count[f] += 1
        cell = []
        for c in group:
            for f, outward in c:
                if count[f] == 1:
                    cell.append((numbers.setdefault(f, len(numbers)), outward))
        out.append(cell)
    kept = [faces[f] for f in numbers]
    used = {}
    kept = [[used.setdefault(v, len(used)) for v in f] for f in kept]
    return [points[v] for v in used], kept, out


# figures

def components(count, pairs):
    parent = list(range(count))

    def find(v):
        while parent[v] != v:
            parent[v] = parent[parent[v]]
            v = parent[v]
        return v
    for a, b in pairs:
        parent[find(a)] = find(b)
    return find


def edges_of(faces): return {(min(a, b), max(a, b)) for f in faces for a, b in zip(f, f[1:] + f[:1])}


def surface_figures(points, faces):
    sides = defaultdict(list)
    for k, f in enumerate(faces):
        for a, b in zip(f, f[1:] + f[:1]):
            sides[(min(a, b), max(a, b))].append((k, a < b))
    used = {v for f in faces for v in f}
    find = components(len(points), sides)
    parts = len({find(v) for v in used})
    non_manifold_edges = sum(len(s) > 2 for s in sides.values())
    # verts whose polys are not all joined by edges at the vert
    around = defaultdict(set)
    for k, f in enumerate(faces):
        for v in f:
            around[v].add(k)
    non_manifold_verts = 0
    for v, polys in around.items():
        pairs = [(s[0][0], t[0]) for e, s in sides.items() if v in e for t in s[1:]]
        f = components(len(faces), pairs)
        non_manifold_verts += len({f(p) for p in polys}) > 1 and not any(len(s) > 2 for e, s in sides.items() if v in e)
    manifold = non_manifold_edges == 0 and non_manifold_verts == 0
    side = {0: 1}
    orientable = True
    neighbours = defaultdict(list)
    for s in sides.values():
        if len(s) == 2:
            same = -1 if s[0][1] == s[1][1] else 1
            neighbours[s[0][0]].append((s[1][0], same))
            neighbours[s[1][0]].append((s[0][0], same))
    side = {}
    for first in range(len(faces)):
        if first in side:
            continue
        side[first], stack = 1, [first]
        while stack:
            k = stack.pop()
            for n, same in neighbours[k]:
                if n not in side:
                    side[n] = side[k] * same
                    stack.append(n)
                elif side[n] != side[k] * same:
                    orientable = False
    boundary = [e for e, s in sides.items() if len(s) == 1]
    f = components(len(points), boundary)
    loops = len({f(a) for a, _ in boundary})
    chi = len(used) - len(sides) + len(faces)
    genus = (2 * parts - loops - chi) // 2 if orientable and manifold else ''
    area = sum(math.sqrt(dot(n, n)) for n in (vector_area([points[v] for v in g]) for g in faces))
    is_closed = orientable and all(len(s) == 2 for s in sides.values())
    volume = sum(dot(mean([points[v] for v in g]), vector_area([points[v] for v in g])) for g in faces) / 3  # of faces as fans about their means
    facts = f'boundary_edges={len(boundary)}'
    if non_manifold_edges:
        facts += f' nonmanifold_edges={non_manifold_edges}'
    if non_manifold_verts:
        facts += f' nonmanifold_verts={non_manifold_verts}'
    return dict(n_verts=len(points), n_verts_used=len(used), n_edges=len(sides), n_faces=len(faces), n_cells=0, euler_chi=chi, components=parts,
                boundary_loops=loops, manifold='yes' if manifold else 'no', orientable=orientable, genus=genus, area_vec=f'{area:.12g}',
                volume_ctr=f'{volume:.12g}' if is_closed else '', facts=facts)


def volume_figures(points, faces, cells):
    edges = edges_of(faces)
    used = {v for f in faces for v in f}
    find = components(len(points), edges)
    parts = len({find(v) for v in used})
    count = defaultdict(int)
    volume = 0
    for cell in cells:
        for f, outward in cell:
            count[f] += 1
            corners = [points[v] for v in faces[f]]
            volume += (1 if outward else -1) * dot(mean(corners), vector_area(corners)) / 3
    area = 0
    skin = []
    for f, n in count.items():
        if n == 1:
            corners = [points[v] for v in faces[f]]
            area += math.sqrt(dot(vector_area(corners), vector_area(corners)))
            skin.append(faces[f])
    chi = len(used) - len(edges) + len(faces) - len(cells)
    skin_edges = edges_of(skin)
    skin_verts = {v for f in skin for v in f}
    shells = len({find2 for find2 in map(components(len(points), skin_edges), skin_verts)})
    genus = shells - (len(skin_verts) - len(skin_edges) + len(skin)) // 2
    return dict(n_verts=len(points), n_verts_used=len(used), n_edges=len(edges), n_faces=len(faces), n_cells=len(cells), euler_chi=chi, components=parts,
                boundary_loops='n/a', manifold='yes', orientable=True, genus=genus, area_vec=f'{area:.12g}', volume_ctr=f'{volume:.12g}', facts='')


# files

def number(x): return f'{x:.17g}' if x else '0'
def line(values): return ' '.join(map(str, values)) + '\n'


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'w') as out:
        out.write(text)


def write_surface(path, points, faces):
    if path.endswith('.obj'):
        text = ''.join('v ' + line(map(number, p)) for p in points) + ''.join('f ' + line(v + 1 for v in f) for f in faces)
    else:
        text = 'OFF\n' + line([len(points), len(faces), 0]) + ''.join(line(map(number, p)) for p in points) + ''.join(line([len(f)] + f) for f in faces)
    write(path, text)
    return surface_figures(points, faces)


def write_medit(path, points, cells):
    name, shape = ('Tetrahedra', TET_FACES) if len(cells[0]) == 4 else ('Hexahedra', CUBE_FACES)
    write(path, 'MeshVersionFormatted 2\nDimension 3\nVertices\n' + line([len(points)]) + ''.join(line(list(map(number, p)) + [0]) for p in points) +
          f'{name}\n{len(cells)}\n' + ''.join(line([v + 1 for v in c] + [0]) for c in cells) + 'End\n')
    return volume_figures(*polyhedra_of(points, cells, shape))


def write_hedra(path, points, faces, cells):
    write(path, line([len(points), len(faces), len(cells)]) + ''.join(line(map(number, p)) for p in points) + ''.join(line([len(f)] + [v + 1 for v in f]) for f in faces) +
          ''.join(line([len(c)] + [(f + 1) * (1 if outward else -1) for f, outward in c]) for c in cells))
    return volume_figures(points, faces, cells)


def main():
    pi = math.pi
    torus = lambda big, small: lambda s, t: ((big + small * math.cos(2 * pi * t)) * math.cos(2 * pi * s), (big + small * math.cos(2 * pi * t)) * math.sin(2 * pi * s),
                                             small * math.sin(2 * pi * t))
    moebius = lambda s, t: ((2 + (t - 0.5) * math.cos(pi * s)) * math.cos(2 * pi * s), (2 + (t - 0.5) * math.cos(pi * s)) * math.sin(2 * pi * s), (t - 0.5) * math.sin(pi * s))
    bumps = lambda s, t: (3 * s, 2 * t, 0.3 * math.sin(6 * s) * math.cos(5 * t))
    tube = lambda s, t: (math.cos(2 * pi * s), math.sin(2 * pi * s), 2 * t)
    cells = lambda x, y, z: list(itertools.product(range(x), range(y), range(z)))
    frame = [(i, j, 0) for i in range(5) for j in range(3) if (i, j) not in ((1, 1), (3, 1))]
    hollow = [c for c in cells(3, 3, 3) if c != (1, 1, 1)]
    ico = icosphere(0)
    hexagons = dual_of(icosphere(1))
    three = ([(0, 0, 0), (0, 0, 1), (1, 0, 0.5), (-0.5, 0.8, 0.5), (-0.5, -0.9, 0.5)], [[0, 1, 2], [1, 0, 3], [0, 1, 4]])
    octahedron = [(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)], [[a, b, 4] for a, b in ((0, 1), (1, 2), (2, 3), (3, 0))] + [[b, a, 5] for a, b in ((0, 1), (1, 2), (2, 3), (3, 0))]
    top = [add(p, (0, 0, 2)) for p in octahedron[0]]
    new = {5: 4}
    for v in (0, 1, 2, 3, 4):
        new[v] = 6 + v
    hourglass = octahedron[0] + top[:5], octahedron[1] + [[new[v] for v in f] for f in octahedron[1]]
    fans = [(0, 0, 0), (1, 0, 0), (1, 1, 0.2), (-1, 0, 0), (-1, -1, 0.3)], [[0, 1, 2], [0, 3, 4]]
    star = [((2 - k % 2) * math.cos(k * pi / 5), (2 - k % 2) * math.sin(k * pi / 5), 0) for k in range(10)]
    concave = star + [times(2, unit(p)) for p in star[1::2]], [list(range(10))] + [[2 * k, 10 + k, (2 * k + 2) % 10, 2 * k + 1] for k in range(5)]
    hex_points, hex_cells = block(cells(4, 3, 3), (0.5, 0.6, 0.4), 0.1)

    files = {
        'fields/grid_33.obj': write_surface('fields/grid_33.obj', *triangles(grid_surface(32, 32, lambda s, t: (s, t, 0)))),
        'fields/kuhn_6.mesh': write_medit('fields/kuhn_6.mesh', *kuhn(6)),
        'hex/block.mesh': write_medit('hex/block.mesh', hex_points, hex_cells),
        'hex/hollow.mesh': write_medit('hex/hollow.mesh', *block(hollow)),
        'hex/two_holes.mesh': write_medit('hex/two_holes.mesh', *block(frame, (1, 1.2, 0.7))),
        'polygon/dodecahedron.obj': write_surface('polygon/dodecahedron.obj', *dual_of(ico)),
        'polygon/football.off': write_surface('polygon/football.off', *hexagons),
        'polygon/star.obj': write_surface('polygon/star.obj', *concave),
        'polygon/grooves.off': write_surface('polygon/grooves.off', *grid_surface(12, 9, bumps)),
        'polyhedral/joined_tets.hedra': write_hedra('polyhedral/joined_tets.hedra', *joined_cells(polyhedra_of(*kuhn(3, 0.15), TET_FACES), lambda k: k // 6)),
        'polyhedral/kelvin_cells.hedra': write_hedra('polyhedral/kelvin_cells.hedra', *truncated_octahedra(2)),
        'polyhedral/pairs_of_hexes.hedra': write_hedra('polyhedral/pairs_of_hexes.hedra', *joined_cells(polyhedra_of(*block(cells(3, 4, 4)), CUBE_FACES), lambda k: k // 2)),
        'quad/bumps.obj': write_surface('quad/bumps.obj', *grid_surface(10, 8, bumps)),
        'quad/moebius.obj': write_surface('quad/moebius.obj', *grid_surface(24, 4, moebius, wrap_x=True, twist=True)),
        'quad/ring.off': write_surface('quad/ring.off', *grid_surface(24, 10, torus(2, 0.7), wrap_x=True, wrap_y=True)),
        'quad/skin_of_two_holes.obj': write_surface('quad/skin_of_two_holes.obj', *boundary_of(block(frame, (1, 1.2, 0.7)))),
        'quad/tube.off': write_surface('quad/tube.off', *grid_surface(16, 6, tube, wrap_x=True)),
        'tet/cube.mesh': write_medit('tet/cube.mesh', *kuhn(3, 0.2)),
        'tet/cube_moved.mesh': write_medit('tet/cube_moved.mesh', *kuhn(4, 0.15)),
        'tri/disk.obj': write_surface('tri/disk.obj', *disk(8)),
        'tri/ellipsoid.off': write_surface('tri/ellipsoid.off', *(lambda m: ([(2 * x, y, 0.7 * z) for x, y, z in m[0]], m[1]))(icosphere(2))),
        'tri/fan3_nonmanifold_edge.obj': write_surface('tri/fan3_nonmanifold_edge.obj', *three),
        'tri/hourglass_nonmanifold_vertex.obj': write_surface('tri/hourglass_nonmanifold_vertex.obj', *hourglass),
        'tri/icosahedron.obj': write_surface('tri/icosahedron.obj', *ico),
        'tri/skin_of_two_holes.off': write_surface('tri/skin_of_two_holes.off', *triangles(boundary_of(block(frame, (1, 1.2, 0.7))))),
        'tri/ball.obj': write_surface('tri/ball.obj', *icosphere(3)),
        'tri/ring.obj': write_surface('tri/ring.obj', *triangles(grid_surface(24, 12, torus(2, 0.8), wrap_x=True, wrap_y=True))),
        'tri/moebius.off': write_surface('tri/moebius.off', *triangles(grid_surface(20, 3, moebius, wrap_x=True, twist=True))),
        'tri/tube.off': write_surface('tri/tube.off', *triangles(grid_surface(14, 7, tube, wrap_x=True))),
        'tri/two_fans_nonmanifold_vertex.obj': write_surface('tri/two_fans_nonmanifold_vertex.obj', *fans),
        'tri/two_balls.obj': write_surface('tri/two_balls.obj', *united(icosphere(2), icosphere(2, (1.5, 0.1, 0.2), 0.8))),
        'tri/wavy.obj': write_surface('tri/wavy.obj', *triangles(grid_surface(14, 11, bumps))),
    }
    columns = ['path', 'kind'] + list(next(iter(files.values())))
    with open('INDEX.tsv', 'w') as index:
        index.write('\t'.join(columns) + '\n')
        for path, figures in files.items():
            index.write('\t'.join([path, path.split('/')[0].replace('fields', 'tri' if path.endswith('obj') else 'tet')] + [str(v) for v in figures.values()]) + '\n')


main()

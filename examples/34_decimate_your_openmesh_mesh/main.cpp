// Decimate a mesh of OpenMesh in place: no copy is made, and its handles remain valid until garbage_collect. The surface is a crater with a sharp rim. Flat parts
// lose nearly all of their triangles, the rim and the boundary keep their shape. The result says how far it is from the input.
#include <concino/adapters/openmesh.hpp>
#include <concino/edit.hpp>
#include <concino/remesh.hpp>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cn = concino;

struct Traits : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// A square of n x n cells with a crater: a cone up to a rim at radius 0.5, and a bowl inside.
Mesh crater(int n) {
  Mesh m;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = 2.0 * i / n - 1, y = 2.0 * j / n - 1, r = std::hypot(x, y);
      m.add_vertex({x, y, r < 0.5 ? 0.8 * r * r : std::max(0.0, 0.2 - (r - 0.5))});
    }
  const auto at = [n](int i, int j) { return Mesh::VertexHandle(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      m.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      m.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return m;
}

void report(const char* what, const Mesh& m, const cn::decimation& d) {
  fmt::print("{}: {} triangles are left, error at most {:.4f}, {}\n", what, cn::num_polys(m), d.error,
             d.stopped_by == cn::decimation_end::target ? "the target is reached" : d.last_refusal.why);
}

int main() {
  const Mesh input = crater(60);
  fmt::print("{} triangles\n", cn::num_polys(input));

  // To a number of triangles. The cheapest edge is collapsed first, and its vert moves to where the surface changes least.
  Mesh m = input;
  report("a tenth", m, cn::decimate(m, {.target_polys = cn::num_polys(m) / 10}));

  // As far as possible, while no vert, no midpoint of an edge and no centroid is farther than this from the input. The error that is measured afterwards is that
  // of all points of both surfaces.
  Mesh fine = input;
  report("no vert farther than 0.002", fine, cn::decimate(fine, {.max_error = 0.002}));

  // Edits that one of the invariants refuses are not made: here, everything at x < 0 stays as it is.
  auto right_half_only = [](const cn::proposed_edit& e) {
    for (const cn::vec3& x : e.points_before)
      if (x.x < 0) return cn::permission{cn::refusal::invariant, "the left half stays"};
    return cn::permission{};
  };
  Mesh half = input;
  report("the right half", half, cn::decimate(half, {.target_polys = 4000, .keep = {cn::no_inversion, right_half_only}}));

  // Within a transaction, a result that is not good enough is not kept.
  Mesh coarse = input;
  {
    cn::transaction t(coarse);
    const auto d = cn::decimate(coarse, {.target_polys = 50});
    report("50 triangles", coarse, d);
    if (d.error < 0.01) t.commit();
  }
  fmt::print("after the transaction: {} triangles\n", cn::num_polys(coarse));

  // OpenMesh marks deleted elements, and keeps them in memory. This removes them; map[v] is the new handle of a vert, or empty if it was deleted.
  const std::size_t before = m.n_vertices();
  const auto map = cn::garbage_collect(m);
  std::size_t left = 0;
  for (std::size_t i = 0; i < before; ++i) left += map[Mesh::VertexHandle(int(i))].has_value();
  fmt::print("{} of {} vertices are left, and as many are in memory: {}\n", left, before, m.n_vertices());
}

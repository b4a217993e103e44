// Measures how time and memory grow with the mesh: building, loading, searching, normals and operators at sizes from 10^4 to 10^6.5 polys. Where the cost per
// element does not depend on their number, the slope in a log-log plot is 1; report.awk fits it. The curve of the floor shows how much of a slope is due to
// the machine, whose caches hold a small mesh but not a large one.
#include "floor/graph.hpp"
#include "floor/normals.hpp"
#include "floor/operators.hpp"
#include "support/element_triplets.hpp"
#include "support/heap.hpp"
#include "support/kinds.hpp"

#include <concino/geometry/normals.hpp>
#include <concino/graph.hpp>
#include <concino/io.hpp>
#include <concino/operators.hpp>

#include <cmath>

namespace {

using bench::u32;
namespace floors = bench::floors;

/// The neighbours of polys as rows: of equal length if all polys have the same shape, else with offsets.
template<u32 K>
auto dual_rows(const floors::surface<K>& f) { return floors::rows<K>{f.p_off.data(), f.p2p.data(), f.num_polys()}; }
template<class S>
auto dual_rows(const floors::cells<S>& f) { return floors::rows<S::faces>{nullptr, f.p2p.data(), f.num_polys()}; }
[[maybe_unused]] auto dual_rows(const floors::polyhedra& f) { return floors::rows<0>{f.p_off.data(), f.p2p.data(), f.num_polys()}; }

template<u32 K>
  requires(K > 0)
auto centroids(const floors::surface<K>& f) { return floors::centroids<K>(f.points.data(), f.p2v.data(), f.num_polys()); }
template<class S>
auto centroids(const floors::cells<S>& f) { return floors::centroids<S::verts>(f.points.data(), f.p2v.data(), f.num_polys()); }

/// Measures one kind of mesh at all sizes. make(n) returns arrays of about n polys.
template<class Kind, class Make>
void grow(const bench::program& p, const std::string& name, Kind kind, bool with_searches, const Make& make) {
  using mesh = typename Kind::mesh;
  const auto wanted = [&](const char* work) { return p.wants("scaling." + std::string(work) + "." + name); };
  const bool searches = with_searches && (wanted("bfs.primal") || wanted("bfs.dual") || wanted("components.primal") || wanted("components.dual") ||
                                          wanted("dijkstra.primal") || wanted("dijkstra.dual"));
  const bool operators = wanted("laplacian") || wanted("gradient");
  if (!searches && !operators && !wanted("load") && !wanted("build") && !wanted("memory") && !wanted("normals")) return;
  for (const double exponent : {4.0, 4.5, 5.0, 5.5, 6.0, 6.5}) {
    if (p.data.tiny && exponent > 4.5) break;
    const auto arrays = make(static_cast<u32>(std::pow(10.0, p.data.tiny ? exponent - 2 : exponent)));
    const auto polys = static_cast<double>(arrays.num_polys());
    const auto measure = [&](const char* work, const char* model, auto floor, auto ours) {
      if (!wanted(work)) return;
      const auto rows = bench::compare(work, std::min(p.rounds, 3), {{"floor", floor}, {"concino", ours}});
      p.print_point("scaling." + std::string(work) + "." + name, model, polys, rows[1].value, rows[0].value);
    };
    const auto timed = [](auto work) { return [work] { return bench::seconds_of(work); }; };

    measure("build", "n",
            [&] {
              auto m = kind.flat(arrays);
              return bench::seconds_of([&] { build(m); return 0; });
            },
            [&] {
              auto copy = arrays;
              return bench::seconds_of([&] { return mesh(std::move(copy)); });
            });
    if (wanted("load")) {
      const std::string path = p.file(name + Kind::ending);
      kind.write(arrays, path);
      measure("load", "n", timed([&] { return kind.read(path); }), timed([&] { return concino::load<mesh>(path); }));
      std::filesystem::remove(path);
    }
    auto flat = kind.flat(arrays);
    build(flat);
    if (wanted("memory")) {
      const std::size_t before = bench::heap::live;
      const mesh m(arrays);
      p.print_point("scaling.memory." + name, "n", polys, static_cast<double>(bench::heap::live - before), static_cast<double>(flat.bytes()));
    }
    if constexpr (requires { floors::normals(flat); }) {
      if (wanted("normals")) {
        const mesh m(arrays);
        measure("normals", "n", timed([&] { return floors::normals(flat); }), timed([&] {
                  if constexpr (concino::SurfaceMesh<mesh>) return concino::surface_normals(m);
                  else return concino::face_normals(m);
                }));
      }
    }
    if (operators) {
      const mesh m(arrays);
      if constexpr (requires { floors::cotangents(flat); }) {
        measure("laplacian", "n", timed([&] { return floors::cotangent_laplacian(flat); }), timed([&] { return concino::laplacian(m); }));
        measure("gradient", "n", timed([&] { return floors::gradient(flat); }), timed([&] { return concino::gradient_matrix(m); }));
      } else {
        measure("laplacian", "n", timed([&] { return bench::standard_laplacian_by_triplets(m); }), timed([&] { return concino::laplacian(m); }));
      }
    }
    if (!searches) continue;
    if constexpr (requires { centroids(flat); }) {
      const mesh m(arrays);
      const floors::rows<0> primal{flat.v_off.data(), flat.v2v.data(), flat.num_verts()};
      const auto dual = dual_rows(flat);
      constexpr auto stride = decltype(dual)::stride;
      const concino::vert_id v{0};
      const concino::poly_id q{0};
      measure("bfs.primal", "n", timed([&] { return floors::bfs<0, false>(primal, 0); }), timed([&] { return concino::bfs(m, v); }));
      measure("bfs.dual", "n", timed([&] { return floors::bfs<stride, true>(dual, 0); }), timed([&] { return concino::bfs(m, q); }));
      measure("components.primal", "n", timed([&] { return floors::components<0, false>(primal); }),
              timed([&] { return concino::connected_components(m); }));
      measure("components.dual", "n", timed([&] { return floors::components<stride, true>(dual); }),
              timed([&] { return concino::connected_components(concino::dual(m)); }));
      measure("dijkstra.primal", "n log n", timed([&] { return floors::dijkstra<0, false>(primal, flat.points.data(), 0); }),
              timed([&] { return concino::dijkstra(m, v); }));
      measure("dijkstra.dual", "n log n", timed([&] {
                const auto c = centroids(flat);
                return floors::dijkstra<stride, true>(dual, c.data(), 0);
              }),
              timed([&] { return concino::dijkstra(m, q); }));
    }
  }
}

/// A closed torus with about this number of triangles.
bench::surface_arrays torus_of(double triangles) {
  const double rows = std::sqrt(triangles / 3);
  return bench::torus(static_cast<u32>(rows), static_cast<u32>(1.5 * rows));
}

u32 root3(double n) { return static_cast<u32>(std::lround(std::cbrt(n))); }

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    grow(p, "trimesh", bench::surface_kind<3, concino::trimesh>{}, true, [](u32 n) { return torus_of(n); });
    grow(p, "quadmesh", bench::surface_kind<4, concino::quadmesh>{}, false, [](u32 n) { return bench::split_into_quads<3>(torus_of(n / 3.0)); });
    grow(p, "polygonmesh", bench::surface_kind<0, concino::polygonmesh>{}, false, [](u32 n) { return bench::dual_polygons(torus_of(2.0 * n)); });
    grow(p, "tetmesh", bench::cell_kind<floors::tet_shape, concino::tetmesh>{}, true, [](u32 n) { return bench::tet_grid(root3(n / 6.0)); });
    grow(p, "hexmesh", bench::cell_kind<floors::hex_shape, concino::hexmesh>{}, false, [](u32 n) { return bench::hex_grid(root3(n)); });
    grow(p, "polyhedralmesh", bench::polyhedral_kind{}, false, [](u32 n) { return bench::hexes_as_polyhedra(root3(n)); });
  });
}

// The common base class of the native meshes; see native_mesh.hpp.
#pragma once

#include <concino/mesh/detail/tables/compaction.hpp>
#include <concino/mesh/native_mesh.hpp>

#include <utility>

#ifdef CONCINO_COMPILED
#include <concino/mesh/cell_tables.hpp>
#include <concino/mesh/polyhedra_tables.hpp>
#endif

namespace concino::detail {

CONCINO_INLINE surface_arrays to_arity(surface_arrays a, std::uint32_t arity) {
  if (arity == 0) {
    a.offsets.clear();
    for (std::size_t i = 0; i <= a.verts.size() / a.arity; ++i)
      a.offsets.push_back(static_cast<std::uint32_t>(i * a.arity));
    if (a.offsets.back() != a.verts.size()) a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  } else {
    const char* const what = arity == 3 ? "trimesh: " : "quadmesh: ";
    const std::size_t n = a.num_polys();
    for (std::size_t p = 0; p < n; ++p) {
      const std::uint32_t has = a.arity ? a.arity : a.offsets[p + 1] - a.offsets[p];
      if (has != arity)
        core::throw_joined<invalid_mesh>(
            {what, "poly ", p, " has ", has, " verts; every poly of this mesh has ", arity});
    }
    if (n * arity != a.verts.size())
      core::throw_joined<invalid_mesh>({what, "the offsets of polys do not fit the ", a.verts.size(), " verts listed"});
    a.offsets.clear();
  }
  a.arity = arity;
  return a;
}

template<class Tables>
native_mesh<Tables>::native_mesh(std::vector<vec3> points, Tables tables)
    : points_(std::move(points)), tables_(std::move(tables)) {
  shrink_if_wasteful(points_);
}
template<class Tables>
native_mesh<Tables>::native_mesh() = default;
template<class Tables>
native_mesh<Tables>::native_mesh(const native_mesh&) = default;
template<class Tables>
native_mesh<Tables>::native_mesh(native_mesh&&) noexcept = default;
template<class Tables>
native_mesh<Tables>& native_mesh<Tables>::operator=(const native_mesh& o) {
  return *this = native_mesh(o);
}
template<class Tables>
native_mesh<Tables>& native_mesh<Tables>::operator=(native_mesh&&) noexcept = default;
template<class Tables>
native_mesh<Tables>::~native_mesh() = default;

/// The numbers that the corners of the remaining polys had.
template<class Tables>
std::vector<std::uint32_t> corners_before(const Tables& t, const compact_numbers<poly_id>& kept, std::size_t bound) {
  std::vector<std::uint32_t> before;
  before.reserve(bound);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const poly_id p{kept.before(i)};
    auto corner = static_cast<std::uint32_t>(t.first_corner(p));
    for (std::size_t n = t.adj_p2v(p).size(); n > 0; --n) before.push_back(corner++);
  }
  return before;
}

template<class Tables>
correspondence native_mesh<Tables>::garbage_collect() {
  compaction kept(tables_);
  Tables tables = tables_.compacted(kept);
  std::vector<vec3> points;
  points.reserve(kept.verts.size());
  for (std::size_t v = 0; v < kept.verts.size(); ++v) points.push_back(points_[kept.verts.before(v)]);
  correspondence c;
  c.corners = element_origins(corners_before(tables_, kept.polys, tables.corner_bound()));
  c.verts = element_origins(kept.verts.take_before());
  c.edges = element_origins(kept.edges.take_before());
  c.faces = element_origins(kept.faces.take_before());
  c.polys = element_origins(kept.polys.take_before());
  properties_.renumber(c);
  points_.swap(points);
  tables_ = std::move(tables);
  return c;
}

#ifdef CONCINO_COMPILED
template class native_mesh<surface_tables<0>>;
template class native_mesh<surface_tables<3>>;
template class native_mesh<surface_tables<4>>;
template class native_mesh<tet_tables>;
template class native_mesh<hex_tables>;
template class native_mesh<polyhedra_tables>;
#endif

}  // namespace concino::detail

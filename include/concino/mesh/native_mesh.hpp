// native_mesh: the common base class of the six native meshes, with points, adjacency tables and properties. Also the
// conversion of lists of points and of verts, as braced lists or containers, into flat arrays.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/message.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/detail/edits/edit_recorder.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/mesh/indexed_base.hpp>
#include <concino/mesh/property_set.hpp>
#include <concino/mesh/surface_tables.hpp>

#include <concepts>
#include <initializer_list>

namespace concino {

/// An index in a braced list: any integer, or a descriptor of the library.
class list_index {
  std::uint32_t raw_;

 public:
  template<std::integral I>
  constexpr list_index(I i)
      : raw_(i < 0 || static_cast<std::uint64_t>(i) >= ~0u ? ~0u : static_cast<std::uint32_t>(i)) {}
  template<class Tag>
  constexpr list_index(id<Tag> x) : raw_(x.raw()) {}
  constexpr std::uint32_t raw() const { return raw_; }
};

/// A face of a polyhedron in a braced list: {face, whether its verts run counter-clockwise seen from outside}.
struct list_face {
  list_index face;
  bool outward;
};

using point_list = std::initializer_list<vec3>;
using index_lists = std::initializer_list<std::initializer_list<list_index>>;
using face_lists = std::initializer_list<std::initializer_list<list_face>>;

namespace detail {

template<class R> concept PointRange = requires(const R& r) { (*std::begin(r))[0]; (*std::begin(r))[2]; };
template<class R> concept IndexRange = requires(const R& r) { list_index(*std::begin(r)); };
template<class R> concept IndexListRange = requires(const R& r) {
  requires IndexRange<std::remove_cvref_t<decltype(*std::begin(r))>>;
};

template<class R>
std::vector<vec3> to_points(const R& r) {
  std::vector<vec3> points;
  for (const auto& p : r) points.push_back(to_vec3(p));
  return points;
}

/// Lists stored one after another; offsets are where each begins. If `arity` is given, every list must have that many
/// entries. Errors name `mesh`.
template<class R>
surface_arrays to_surface(std::vector<vec3> points, const R& lists, std::uint32_t arity, const char* mesh) {
  surface_arrays a;
  a.points = std::move(points);
  a.arity = arity;
  if (!arity) a.offsets.push_back(0);
  std::size_t p = 0;
  for (const auto& list : lists) {
    const std::size_t before = a.verts.size();
    for (const auto& i : list) a.verts.push_back(vert_id{list_index(i).raw()});
    const std::size_t n = a.verts.size() - before;
    if (arity && n != arity)
      core::throw_joined<invalid_mesh>({mesh, ": poly ", p, " has ", n, " verts; every poly of this mesh has ", arity});
    if (!arity) a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
    ++p;
  }
  return a;
}

/// The same polys, stored as lists of `arity` verts, or with offsets if `arity` is 0.
surface_arrays to_arity(surface_arrays a, std::uint32_t arity);

template<class R>
cell_arrays to_cells(std::vector<vec3> points, const R& lists, std::uint32_t arity) {
  surface_arrays a = to_surface(std::move(points), lists, arity, arity == 4 ? "tetmesh" : "hexmesh");
  return {std::move(a.points), std::move(a.verts), arity};
}

template<class Faces, class Polys>
polyhedra_arrays polyhedra_arrays_from(std::vector<vec3> points, const Faces& face_lists, const Polys& poly_lists) {
  surface_arrays a = to_surface(std::move(points), face_lists, 0, "polyhedralmesh");
  polyhedra_arrays b{std::move(a.points), std::move(a.offsets), std::move(a.verts), {0}, {}, {}};
  for (const auto& poly : poly_lists) {
    for (const auto& [face, outward] : poly) {
      b.poly_faces.push_back(face_id{list_index(face).raw()});
      b.outward.push_back(outward ? 1 : 0);
    }
    b.poly_offsets.push_back(static_cast<std::uint32_t>(b.poly_faces.size()));
  }
  return b;
}

/// Points, connectivity, properties. Copies are deep; a moved-from mesh is empty.
template<class Tables>
class native_mesh {
  std::vector<vec3> points_;
  Tables tables_;
  property_set properties_;
  edit_state<native_mesh> edits_;

 protected:
  native_mesh(std::vector<vec3> points, Tables tables);

 public:
  using native = native_mesh;
  using tables_type = Tables;

  native_mesh();
  native_mesh(const native_mesh&);
  native_mesh(native_mesh&&) noexcept;
  native_mesh& operator=(const native_mesh&);  // strong exception guarantee
  native_mesh& operator=(native_mesh&&) noexcept;
  ~native_mesh();

  const std::vector<vec3>& points() const { return points_; }
  std::vector<vec3>& points() { return points_; }
  const Tables& tables() const { return tables_; }
  Tables& tables() { return tables_; }
  const property_set& properties() const { return properties_; }
  property_set& properties() { return properties_; }
  edit_state<native_mesh>& edits() { return edits_; }

  /// Numbers the elements without gaps, in the same order. Strong exception guarantee.
  correspondence garbage_collect();
};

}  // namespace detail

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/meshes/native_mesh.ipp>
#endif

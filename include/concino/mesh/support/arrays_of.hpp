// Converts any mesh to the flat arrays from which native meshes are constructed and files are written.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/support/cell_recogniser.hpp>

#include <concepts>
#include <string>

namespace concino::core {

/// Numbers elements from 0 in the order of their range. The result is by index of the element.
template<class M, class R>
std::vector<std::uint32_t> numbered(const M& m, const R& elements, std::size_t bound) {
  std::vector<std::uint32_t> number(bound, ~0u);
  std::uint32_t n = 0;
  for (const auto x : elements) number[index_of(m, x)] = n++;
  return number;
}

template<Embedded M>
std::vector<vec3> copy_points(const M& m) {
  std::vector<vec3> points;
  points.reserve(num_verts(m));
  for (const vert_t<M> v : verts(m)) points.push_back(to_vec3(point(m, v)));
  return points;
}

[[noreturn, gnu::cold]] inline void throw_wrong_arity(bool volume, std::size_t p, const std::string& has,
                                                      std::uint32_t arity) {
  if (volume)
    core::throw_joined<unsupported>({"convert: poly ", p, " ", has, "; the wanted mesh holds ",
                                     arity == 4 ? "tets" : "hexes", " only (a polyhedralmesh takes any cell)"});
  core::throw_joined<unsupported>({"convert: poly ", p, " ", has, "; every poly of the wanted mesh has ", arity,
                                   " verts (a polygonmesh takes any polygon)"});
}

/// The arrays of a surface. `vert_number` is by index of the vert. With arity 0 polys have any size, otherwise all have
/// `arity` verts.
template<SurfaceMesh M>
surface_arrays arrays_of(const M& m, const std::vector<std::uint32_t>& vert_number, std::uint32_t arity) {
  surface_arrays a;
  a.points = copy_points(m);
  a.arity = arity;
  std::size_t num_corners = arity * num_polys(m);
  if (!arity) {
    for (const poly_t<M> p : polys(m)) num_corners += num_elements(adj_p2v(m, p));
    a.offsets.reserve(num_polys(m) + 1);
    a.offsets.push_back(0);
  }
  a.verts.reserve(num_corners);
  for (const poly_t<M> p : polys(m)) {
    const std::size_t before = a.verts.size();
    for (const vert_t<M> v : adj_p2v(m, p)) a.verts.push_back(vert_id{vert_number[index_of(m, v)]});
    if (arity && a.verts.size() - before != arity)
      throw_wrong_arity(false, index_of(m, p), core::joined({"has ", a.verts.size() - before, " verts"}), arity);
    if (!arity) a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  }
  return a;
}

template<VolumeMesh M>
polyhedra_arrays polyhedra_of(const M& m, const std::vector<std::uint32_t>& vert_number,
                              const std::vector<std::uint32_t>& face_number) {
  polyhedra_arrays a;
  a.points = copy_points(m);
  std::size_t num_corners = 0, num_uses = 0;
  for (const face_t<M> f : faces(m)) num_corners += num_elements(adj_f2v(m, f));
  for (const poly_t<M> p : polys(m)) num_uses += num_elements(adj_p2f(m, p));
  a.face_offsets.reserve(num_faces(m) + 1), a.face_verts.reserve(num_corners);
  a.poly_offsets.reserve(num_polys(m) + 1), a.poly_faces.reserve(num_uses), a.outward.reserve(num_uses);
  a.face_offsets.push_back(0);
  a.poly_offsets.push_back(0);
  for (const face_t<M> f : faces(m)) {
    for (const vert_t<M> v : adj_f2v(m, f)) a.face_verts.push_back(vert_id{vert_number[index_of(m, v)]});
    a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
  }
  for (const poly_t<M> p : polys(m)) {
    for (const face_t<M> f : adj_p2f(m, p)) {
      a.poly_faces.push_back(face_id{face_number[index_of(m, f)]});
      a.outward.push_back(face_is_outward(m, p, f));
    }
    a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
  }
  return a;
}

/// Calls take(p, corners) for every poly, with its `arity` verts in the standard order. They come from adj_p2v if the
/// mesh type lists them in this order, otherwise from the faces.
/// Errors: unsupported that names a poly which is not such a cell.
template<VolumeMesh M, class Take>
void for_each_cell(const M& m, const std::vector<std::uint32_t>& vert_number, std::uint32_t arity, const Take& take) {
  cell_recogniser known;
  for (const poly_t<M> p : polys(m)) {
    if constexpr (arity_v<M> == 4 || arity_v<M> == 8) {  // tets and hexes list their verts in the standard order
      if (arity == arity_v<M>) {
        vert_id corners[8];
        std::size_t n = 0;
        for (const vert_t<M> v : adj_p2v(m, p)) corners[n++] = vert_id{vert_number[index_of(m, v)]};
        take(p, corners);
        continue;
      }
    }
    std::size_t count = 0;
    known.clear();
    for (const face_t<M> f : adj_p2f(m, p)) {
      ++count;
      known.begin_face();
      for (const vert_t<M> v : adj_f2v(m, f)) known.push(vert_id{vert_number[index_of(m, v)]});
      if (!face_is_outward(m, p, f)) known.reverse_face();
    }
    const cell_shape s = known.recognise();
    if (s != (arity == 4 ? cell_shape::tet : cell_shape::hex))
      throw_wrong_arity(true, index_of(m, p),
                        core::joined({"is a ", s == cell_shape::general ? "polyhedron" : standard_cell_of(s).name,
                                      " of ", count, " faces"}),
                        arity);
    take(p, known.cell);
  }
}

}  // namespace concino::core

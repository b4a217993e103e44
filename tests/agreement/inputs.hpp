// The input meshes on which models of each kind are compared: arrays, their properties, and the reference, a native mesh without fixed arity.
// Coordinates are floats, so that models that store floats have the same points.
#pragma once

#include <concino/edit/elements.hpp>
#include <concino/mesh.hpp>

#include <agreement/copies.hpp>
#include <support/closed_surfaces.hpp>
#include <support/kinds.hpp>
#include <support/soups.hpp>

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace concino::agreement {

template<class Arrays>
struct input {
  std::string name;
  Arrays arrays;
  bool manifold = true;            // a half-edge mesh can hold it: consistently oriented, at most two polys at an edge
  bool closed = false;             // surfaces: without boundary
  bool in_one_piece = true;
  std::vector<unsigned> gone_polys = {}, gone_verts = {};  // to be removed after the mesh is constructed
};

/// Rounds the coordinates to floats.
template<class Arrays>
Arrays in_floats(Arrays a) {
  for (vec3& p : a.points) p = {double(float(p.x)), double(float(p.y)), double(float(p.z))};
  return a;
}
template<class Arrays>
Arrays crooked(Arrays a) { return in_floats(testing::jittered(std::move(a), 0.03)); }

/// Removes polys and verts, so that there are gaps in the indices.
template<class M>
void remove_elements(M& m, const std::vector<unsigned>& gone_polys, const std::vector<unsigned>& gone_verts) {
  for (const unsigned p : gone_polys) remove_poly(m, poly_id{p});
  for (const unsigned v : gone_verts) remove_vert(m, vert_id{v});
}

/// The grid without the second third of its polys, and without the verts that then have no polys.
template<class M, class Arrays>
input<Arrays> with_gaps(const Arrays& whole) {
  input<Arrays> r{"with gaps", whole};
  r.in_one_piece = false;
  M m(whole);
  const auto n = static_cast<unsigned>(num_polys(m));
  for (unsigned p = n / 3; p < 2 * n / 3; ++p) r.gone_polys.push_back(p);
  remove_elements(m, r.gone_polys, {});
  for (const auto v : verts(m))
    if (!(adj_v2p(m, v).begin() != adj_v2p(m, v).end())) r.gone_verts.push_back(v.raw());
  return r;
}

template<class K>
auto inputs() {
  using namespace testing;
  using arrays = decltype(grid_arrays<K>(1));
  std::vector<input<arrays>> r;
  r.push_back({"grid", crooked(grid_arrays<K>(dimension_v<K> == 2 ? 4 : 2))});
  r.push_back({"two grids and a vert of no poly", crooked(two_grids_arrays<K>(dimension_v<K> == 2 ? 2 : 1))});
  r.back().in_one_piece = false;
  r.push_back({"nothing", arrays{grid_arrays<K>(1)}});
  r.back().arrays.points.clear();
  r.back().in_one_piece = false;
  if constexpr (std::same_as<arrays, polyhedra_arrays>) r.back().arrays = {{}, {0}, {}, {0}, {}, {}};
  else {
    r.back().arrays.verts.clear();
    if constexpr (requires { r.back().arrays.offsets; })
      if (r.back().arrays.arity == 0) r.back().arrays.offsets = {0};
  }
  if constexpr (dimension_v<K> == 2) {
    const auto shaped = [](const surface_arrays& quads) {
      return crooked(arity_v<K> == 3 ? triangulated(quads) : arity_v<K> == 4 ? quads : with_middles(quads));
    };
    r.push_back({"torus", shaped(rolled_grid(5, 4)), true, true});
    const auto both = beside(rolled_grid(4, 3), voxel_skin({{0, 0, 0}}));
    r.push_back({"torus beside a sphere", arity_v<K> == 0 ? crooked(with_offsets(both)) : shaped(both), true, true, false});  // as polygons they are quads
  }
  std::mt19937 random(5);
  const auto soup = random_soup<K>(random, 9, 5);
  const K tangle = soup.mesh();
  r.push_back({"tangle", in_floats(arrays_of<K>(tangle)), false, false, false});
  r.push_back(with_gaps<K>(crooked(grid_arrays<K>(dimension_v<K> == 2 ? 4 : 2))));
  return r;
}

/// The native mesh that the models of an input are compared with.
template<class K, class Arrays>
auto reference(const input<Arrays>& in) {
  K m(in.arrays);
  remove_elements(m, in.gone_polys, in.gone_verts);
  return general_copy(m);
}

}  // namespace concino::agreement

// The hexes of midpoint subdivision: one at each vert of a polyhedron.
#pragma once

#include <concino/concepts/oriented_edges.hpp>
#include <concino/core/small_array.hpp>
#include <concino/generate/detail/subdivide/subdivision.hpp>
#include <concino/mesh/hexmesh.hpp>

#include <array>

namespace concino::detail {

/// The verts of a polyhedron, in the order of adj_p2v, with the new verts of the edges and faces around each.
class poly_corners {
  /// Counter-clockwise around its vert, as seen from outside the poly, a face begins at edge `first` and ends at edge
  /// `last`.
  struct sector {
    vert_id first, last, face;
  };
  struct corner {
    vert_id vert;
    unsigned count = 0;
    std::array<sector, 3> sectors;
  };

  core::local_numbers numbers_;
  core::small_array<corner, 12> corners_;

  void add(std::size_t index, const sector& s) {
    corner& c = corners_[numbers_.find(index)];
    if (c.count < 3) c.sectors[c.count] = s;
    ++c.count;
  }

 public:
  template<class M, class Refined>
  poly_corners(const M& m, const poly_t<M>& p, const Refined& refined) {
    for (const vert_t<M> v : adj_p2v(m, p)) {
      numbers_.add(index_of(m, v));
      corners_.push_back({refined[v], 0, {}});
    }
    for (const face_t<M> f : adj_p2f(m, p)) {
      const bool outward = face_is_outward(m, p, f);
      const vert_id face = refined[f];
      const auto add_corner = [&](const vert_t<M>& v, vert_id in, vert_id out) {
        add(index_of(m, v), outward ? sector{out, in, face} : sector{in, out, face});
      };
      bool is_first = true;
      vert_t<M> start{};
      vert_id first_out{}, in{};
      for (const auto& [e, from, to] : oriented_edges(m, f)) {
        const vert_id out = refined[e];
        if (is_first) start = from, first_out = out, is_first = false;
        else add_corner(from, in, out);
        in = out;
      }
      if (!is_first) add_corner(start, in, first_out);
    }
  }

  std::size_t size() const { return corners_.size(); }
  /// The index of vert k, and the number of edges at it.
  std::size_t index(unsigned k) const { return numbers_[k]; }
  unsigned valence(unsigned k) const { return corners_[k].count; }

  /// The hex at vert k, which has three edges, around the new vert of the poly. Returns false if the three faces are
  /// not closed around the vert.
  bool hex_at(unsigned k, vert_id centre, std::array<vert_id, 8>& hex) const {
    const corner& c = corners_[k];
    const sector& a = c.sectors[0];
    const bool in_order = a.last == c.sectors[1].first;
    const sector &b = c.sectors[in_order ? 1 : 2], &d = c.sectors[in_order ? 2 : 1];
    // Clockwise as seen from outside, the three edges from the vert form a right-handed frame.
    hex = {c.vert, a.first, d.face, d.first, a.last, a.face, centre, b.face};
    return a.last == b.first && b.last == d.first && d.last == a.first;
  }
};

template<class M>
subdivided<hexmesh> subdivide_in_hexes(const char* caller, const M& m, const subdivide_options& o) {
  using new_verts = refined_verts<M, refined_kinds{.edges = true, .faces = true, .polys = true}>;
  const std::size_t corners = num_poly_corners(m);
  check_subdivided_counts<hexmesh>(caller, new_verts::expected_size(m), static_cast<double>(corners));
  const new_verts refined(m);
  cell_arrays a{{}, {}, 8};
  a.verts.reserve(8 * corners);
  std::array<vert_id, 8> hex;
  for (const poly_t<M> p : polys(m)) {
    const poly_corners at(m, p, refined);
    for (unsigned k = 0; k < at.size(); ++k) {
      if (at.valence(k) != 3)
        core::throw_joined<unsupported>({caller, ": poly ", index_of(m, p), " has ", at.valence(k), " edges at vert ",
                                         at.index(k),
                                         ", but must have 3; subdivide_barycentric() divides all polyhedra"});
      if (!at.hex_at(k, refined[p], hex))
        core::throw_joined<invalid_mesh>({caller, ": the faces of poly ", index_of(m, p),
                                          " are not closed around vert ", at.index(k),
                                          "; validate() lists what is wrong with the mesh"});
      a.verts.insert(a.verts.end(), hex.begin(), hex.end());
    }
  }
  const mean_rule<M> rule{m};
  a.points = refined_points(refined, rule);
  return with_origins(hexmesh(std::move(a)), refined, rule, o, [&] { return polys_of_corners(m, 1); });
}

}  // namespace concino::detail

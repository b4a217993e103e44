// A cavity of tets or hexes: the verts, edges and faces of its old and new polys by local numbers, and what changes at each of them.
#pragma once

#include <concino/mesh/detail/cavity_changes.hpp>
#include <concino/mesh/detail/cavity_edges.hpp>
#include <concino/mesh/detail/cavity_faces.hpp>
#include <concino/mesh/detail/cavity_input.hpp>
#include <concino/mesh/detail/shapes.hpp>

namespace concino::detail {

/// What changes among the polys around an edge. A fan is a sequence of polys in which each shares a face at the edge with the next.
struct fan_change {
  static constexpr std::uint32_t none = ~0u;

  std::uint32_t old_joints = 0;    // faces at the edge with two old polys
  std::uint32_t new_joints = 0;    // pairs of new polys, as few as connect as many of them as possible
  std::uint32_t first_new = none;  // the first new poly at the edge
  bool starts_at_old = false;      // whether the walk around the edge starts at an old poly
  bool is_irregular = false;       // whether the polys may not be one fan before or after
};

template<class Shape>
class cell_cavity {
 public:
  using face = cavity_face<Shape::face_verts>;

  const native_cavity& c;
  const cavity_verts verts;
  const unsigned num_old_verts = static_cast<unsigned>(c.verts.size()), num_verts = num_old_verts + static_cast<unsigned>(c.points.size());
  cavity_edges edges;
  cavity_faces<Shape::face_verts> faces;
  core::small_array<fan_change, 80> fans;     // parallel to edges
  core::small_array<vert_change, 24> changes;  // of verts
  core::small_array<std::uint32_t, 16 * Shape::edges> edges_of_new;
  core::small_array<std::uint32_t, 16 * Shape::faces> faces_of_new;
  std::size_t fresh_edges = 0, left_over_edges = 0, fresh_faces = 0, left_over_faces = 0;  // those the mesh did not have, and those it loses

  std::size_t num_new() const { return c.ends.size(); }
  std::size_t num_added() const { return num_new() - c.kept; }
  const unsigned* corners(std::size_t k) const { return c.corners.begin() + k * Shape::verts; }

  template<class Tables>
  cell_cavity(const Tables& t, const native_cavity& cavity)
      : c(cavity), verts(c.verts), edges(num_verts, Shape::edges * (c.polys.size() + c.ends.size())), faces(Shape::faces * (c.polys.size() + c.ends.size())),
        changes(num_verts, vert_change{}) {
    check_cavity(c, verts, t.verts(), t.polys(), Shape::verts);
    for (const poly_id p : c.polys) find_old(t, p);
    for (std::size_t k = 0; k < num_new(); ++k) find_new(t, k);
    compare_faces();
    compare_edges(t);
    for (unsigned v = num_old_verts - static_cast<unsigned>(c.removed); v < num_old_verts; ++v)
      if (t.adj_v2p(verts[v]).size() != changes[v].polys_before) removed_vert_in_use(verts[v]);
  }

 private:
  static constexpr const auto& shape = shape_v<Shape>;

  /// The numbers of the edges and faces of one poly.
  struct numbers {
    unsigned edge[Shape::edges], face[Shape::faces];
  };

  numbers find(const unsigned (&v)[Shape::verts]) {
    numbers n;
    for (unsigned j = 0; j < Shape::edges; ++j) n.edge[j] = edges.number(edges.at(v[Shape::edge_vert[j][0]], v[Shape::edge_vert[j][1]]));
    fans.resize(edges.size(), {});
    for (unsigned k = 0; k < Shape::faces; ++k) {
      unsigned w[Shape::face_verts];
      for (unsigned i = 0; i < Shape::face_verts; ++i) w[i] = v[Shape::face_vert[k][i]];
      face& x = faces.at(w);
      if (x.old_polys + x.new_polys == 0)
        for (unsigned i = 0; i < Shape::face_verts; ++i) x.edges[i] = n.edge[shape.face_edge[k][i]];
      n.face[k] = faces.number(x);
    }
    return n;
  }

  template<class Tables>
  void find_old(const Tables& t, poly_id p) {
    unsigned v[Shape::verts];
    const auto all = t.adj_p2v(p);
    for (unsigned i = 0; i < Shape::verts; ++i) {
      v[i] = verts.local(all[i]);
      if (v[i] == cavity_verts::none) missing_cavity_vert(p, all[i]);
      ++changes[v[i]].polys_before;
    }
    const numbers n = find(v);
    for (unsigned j = 0; j < Shape::edges; ++j) {
      cavity_edge& x = edges[n.edge[j]];
      fan_change& fan = fans[n.edge[j]];
      if (x.old_polys++ == 0) {
        x.id = t.adj_p2e(p)[j];
        fan.is_irregular = t.is_non_manifold(x.id);
      }
      if (t.first_poly(x.id) == p) fan.starts_at_old = true;
    }
    for (unsigned k = 0; k < Shape::faces; ++k) {
      face& x = faces[n.face[k]];
      if (x.old_polys++ > 0) continue;
      x.id = t.adj_p2f(p)[k];
      x.num_polys = t.facet_adjacency_.num_polys_at(p, k);
    }
  }

  template<class Tables>
  void find_new(const Tables& t, std::size_t k) {
    unsigned v[Shape::verts];
    bool has_new_vert = false;
    for (unsigned i = 0; i < Shape::verts; ++i) {
      v[i] = corners(k)[i];
      ++changes[v[i]].polys_after;
      has_new_vert |= v[i] >= num_old_verts;
    }
    const numbers n = find(v);
    for (const unsigned j : n.edge) {
      cavity_edge& x = edges[j];
      edges_of_new.push_back(j);
      if (x.new_polys++ > 0) continue;
      fans[j].first_new = static_cast<std::uint32_t>(k);
      if (!x.id.is_none() || x.a >= num_old_verts || x.b >= num_old_verts) continue;
      x.id = edge_between(t.v2v_, t.v2e_, verts[x.a], verts[x.b]);
      fans[j].is_irregular = !x.id.is_none();
    }
    for (unsigned j = 0; j < Shape::faces; ++j) {
      face& x = faces[n.face[j]];
      faces_of_new.push_back(n.face[j]);
      if (x.new_polys < 2) x.new_uses[x.new_polys] = static_cast<std::uint32_t>(k * Shape::faces + j);
      if (x.new_polys++ > 0 || !x.id.is_none() || std::any_of(x.edges, x.edges + Shape::face_verts, [&](unsigned e) { return edges[e].id.is_none(); })) continue;
      vert_id all[Shape::verts];
      for (unsigned i = 0; i < Shape::verts; ++i) all[i] = v[i] < num_old_verts ? verts[v[i]] : vert_id{};
      x.id = t.face_on(all, j);
      if (!x.id.is_none()) x.num_polys = static_cast<std::uint32_t>(t.adj_f2p(x.id).size());
    }
  }

  /// An edge remains one fan if the faces between its old polys and others are those between its new polys and others, and the new polys are connected.
  void compare_faces() {
    core::small_array<std::uint32_t, 16 * Shape::edges> connected(edges_of_new.size(), 0);  // new polys at edges: trees of connected ones
    for (std::uint32_t i = 0; i < connected.size(); ++i) connected[i] = i;
    const auto root = [&](std::uint32_t i) {
      while (connected[i] != i) i = connected[i] = connected[connected[i]];
      return i;
    };
    for (const face& x : faces) {
      if (x.id.is_none()) ++fresh_faces;
      else if (x.is_left_over()) ++left_over_faces;
      const std::uint32_t others = x.num_polys - x.old_polys;
      const bool is_irregular = others == 0 ? x.old_polys > 2 || x.new_polys > 2 : others > 1 || x.old_polys != 1 || x.new_polys != 1;
      for (const unsigned e : x.edges) {
        fan_change& fan = fans[e];
        fan.is_irregular |= is_irregular;
        if (others > 0) edges[e].num_polys = 1;  // besides old ones, see compare_edges()
        if (others > 0 || is_irregular) continue;
        fan.old_joints += x.old_polys == 2;
        if (x.new_polys != 2) continue;
        const std::uint32_t a = root(use_of(e, x.new_uses[0])), b = root(use_of(e, x.new_uses[1]));
        if (a == b) continue;
        connected[std::max(a, b)] = std::min(a, b);
        ++fan.new_joints;
      }
    }
  }
  /// The place in edges_of_new of edge e, which has the face of a new poly.
  std::uint32_t use_of(unsigned e, std::uint32_t face_use) const {
    const std::uint32_t first = face_use / Shape::faces * Shape::edges;
    const std::uint8_t* at = shape.face_edge[face_use % Shape::faces];
    while (edges_of_new[first + *at] != e) ++at;
    return first + *at;
  }

  /// Counts polys at edges. Those of an edge that is one fan are not counted: it is enough that it has a poly besides the old ones.
  template<class Tables>
  void compare_edges(const Tables& t) {
    for (cavity_edge& x : edges) {
      fan_change& fan = fans[edges.number(x)];
      if (x.id.is_none()) {
        ++fresh_edges, ++changes[x.a].edges_gained, ++changes[x.b].edges_gained;
      } else {
        x.num_polys += x.old_polys;
        if (t.is_non_manifold(x.id)) x.num_polys = static_cast<std::uint32_t>(t.poly_list(x.id).size());
        else if (x.old_polys == 0) x.num_polys = 1;
        fan.is_irregular |= x.old_polys > fan.old_joints + 1;
        if (x.is_left_over()) ++left_over_edges, ++changes[x.a].edges_lost, ++changes[x.b].edges_lost;
      }
      fan.is_irregular |= x.new_polys > 0 && x.new_polys != fan.new_joints + 1;
    }
  }
};

}  // namespace concino::detail

// A cavity of tets or hexes: the verts, edges and faces of its old and new polys by local numbers, and what changes at
// each of them.
#pragma once

#include <concino/mesh/detail/cells/shapes.hpp>
#include <concino/mesh/detail/edits/cavity_changes.hpp>
#include <concino/mesh/detail/edits/cavity_edges.hpp>
#include <concino/mesh/detail/edits/cavity_faces.hpp>
#include <concino/mesh/detail/edits/cavity_input.hpp>
#include <concino/mesh/detail/edits/new_poly_links.hpp>

#include <array>

namespace concino::detail {

/// What changes among the polys around an edge. A fan is a sequence of polys in which each shares a face at the edge
/// with the next.
struct fan_change {
  std::uint32_t old_joints = 0;    // faces at the edge with two old polys
  std::uint32_t new_joints = 0;    // faces at the edge with two new polys and no others
  bool has_others = false;         // whether a face at the edge has polys besides old ones
  bool starts_at_old = false;      // whether the walk around the edge starts at an old poly
  bool is_irregular = false;       // whether the polys may not be one fan before or after
};

template<class Shape>
class cell_cavity {
 public:
  using face = cavity_face<Shape::face_verts>;

  const native_cavity& c;
  const cavity_verts verts;
  const unsigned num_old_verts = static_cast<unsigned>(c.verts.size()),
                 num_verts = num_old_verts + static_cast<unsigned>(c.points.size());
  cavity_edges edges;
  cavity_faces<Shape::face_verts> faces;
  core::small_array<fan_change, 80> fans;     // parallel to edges
  core::small_array<vert_change, 24> changes;  // of verts
  core::small_array<unsigned, 24 * Shape::verts> corners_of_old;
  core::small_array<std::uint32_t, 24 * Shape::edges> edges_of_polys;  // of the old polys, then of the new ones
  core::small_array<std::uint32_t, 24 * Shape::faces> faces_of_polys;  // the same
  // those the mesh did not have, and those it loses
  std::size_t num_new_edges = 0, num_unused_edges = 0, num_new_faces = 0, num_unused_faces = 0;

  std::size_t num_old() const { return c.polys.size(); }
  std::size_t num_new() const { return c.ends.size(); }
  std::size_t num_all() const { return num_old() + num_new(); }
  std::size_t num_added() const { return num_new() - c.kept; }
  const unsigned* corners(std::size_t k) const { return c.corners.begin() + k * Shape::verts; }
  const std::uint32_t* edges_of_new(std::size_t k) const {
    return edges_of_polys.begin() + (num_old() + k) * Shape::edges;
  }
  const std::uint32_t* faces_of_new(std::size_t k) const {
    return faces_of_polys.begin() + (num_old() + k) * Shape::faces;
  }
  /// Whether face x had old polys only.
  static bool has_no_others(const face& x) { return x.num_polys == x.old_polys; }
  /// The other use of a face that connects two new polys, as numbered in new_uses; no_mate if it has one new poly only,
  /// has_others if it has any others.
  static constexpr std::uint32_t no_mate = new_poly_links<Shape>::no_mate,
                                 has_others = new_poly_links<Shape>::has_others;
  std::uint32_t mate(std::size_t use) const { return links_.mate(use); }
  bool share_all_but_one(const face& x, const face& y) const {
    const auto a = corners_of(x), b = corners_of(y);
    unsigned common = 0;
    for (const unsigned v : a)
      for (const unsigned w : b) common += v == w;
    return common + 1 == Shape::face_verts;
  }

  template<class Tables>
  cell_cavity(const Tables& t, const native_cavity& cavity)
      : c(cavity), verts(c.verts), edges(Shape::edges * num_all()), faces(Shape::faces * num_all(), edges.capacity()),
        changes(num_verts, vert_change{}), corners_of_old(Shape::verts * num_old(), 0),
        edges_of_polys(Shape::edges * num_all(), 0), faces_of_polys(Shape::faces * num_all(), 0) {
    check_cavity(c, verts, t.verts(), t.polys(), Shape::verts);
    for (std::size_t k = 0; k < num_old(); ++k) list_corners_of_old(t, k);
    for (std::size_t k = 0; k < num_old(); ++k) {
      find(k);
      fans.resize(edges.size(), {});
      count_old(t, k);
    }
    for (std::size_t k = 0; k < num_new(); ++k) {
      find(num_old() + k);
      count_new(k);
    }
    fans.resize(edges.size(), {});
    for (cavity_edge& x : edges)
      if (x.id.is_none() && x.b < num_old_verts) x.id = t.incident_edges_.edge_between(verts[x.a], verts[x.b]);
    compare_faces(t);
    compare_edges(t);
    for (unsigned v = num_old_verts - static_cast<unsigned>(c.removed); v < num_old_verts; ++v)
      if (t.adj_v2p(verts[v]).size() != changes[v].polys_before) removed_vert_in_use(verts[v]);
  }

 private:
  static constexpr const auto& shape = shape_v<Shape>;
  new_poly_links<Shape> links_{c.ends.size()};

  /// Numbers the edges and faces of poly k, counted with old ones.
  void find(std::size_t k) {
    const unsigned* const v = corners_of_poly(k);
    std::uint32_t* const edges_of_poly = edges_of_polys.begin() + k * Shape::edges;
    for (unsigned j = 0; j < Shape::edges; ++j)
      edges_of_poly[j] = edges.number(v[Shape::edge_vert[j][0]], v[Shape::edge_vert[j][1]]);
    faces.add_edges(edges.size());
    for (unsigned j = 0; j < Shape::faces; ++j) {
      const std::size_t use = k * Shape::faces + j;
      faces_of_polys[use] = faces.number(key_of_face<Shape>(v, edges_of_poly, j), static_cast<std::uint32_t>(use));
    }
  }
  const unsigned* corners_of_poly(std::size_t k) const {
    return k < num_old() ? corners_of_old.begin() + k * Shape::verts : corners(k - num_old());
  }
  std::array<unsigned, Shape::face_verts> corners_of(const face& x) const {
    const unsigned* const v = corners_of_poly(x.first_use / Shape::faces);
    std::array<unsigned, Shape::face_verts> w;
    for (unsigned i = 0; i < Shape::face_verts; ++i) w[i] = v[Shape::face_vert[x.first_use % Shape::faces][i]];
    return w;
  }
  std::array<std::uint32_t, Shape::face_verts> edges_of(const face& x) const {
    const std::uint32_t* const all = edges_of_polys.begin() + x.first_use / Shape::faces * Shape::edges;
    std::array<std::uint32_t, Shape::face_verts> e;
    for (unsigned i = 0; i < Shape::face_verts; ++i) e[i] = all[shape.face_edge[x.first_use % Shape::faces][i]];
    return e;
  }

  template<class Tables>
  void list_corners_of_old(const Tables& t, std::size_t k) {
    const poly_id p = c.polys[k];
    unsigned* const v = corners_of_old.begin() + k * Shape::verts;
    const auto all = t.adj_p2v(p);
    for (unsigned i = 0; i < Shape::verts; ++i) {
      v[i] = verts.local(all[i]);
      if (v[i] == cavity_verts::none) missing_cavity_vert(p, all[i]);
      ++changes[v[i]].polys_before;
    }
  }

  template<class Tables>
  void count_old(const Tables& t, std::size_t k) {
    const poly_id p = c.polys[k];
    const edge_id* const e = t.adj_p2e(p).begin();
    const face_id* const f = t.adj_p2f(p).begin();
    for (unsigned j = 0; j < Shape::edges; ++j) {
      const std::uint32_t number = edges_of_polys[k * Shape::edges + j];
      cavity_edge& x = edges[number];
      ++x.old_polys;
      x.id = e[j];
      fans[number].starts_at_old |= t.first_poly(x.id) == p;
    }
    for (unsigned j = 0; j < Shape::faces; ++j) {
      face& x = faces[faces_of_polys[k * Shape::faces + j]];
      if (x.old_polys++ > 0) continue;
      x.id = f[j];
      x.num_polys = t.facet_adjacency_.num_polys_at(p, j);
    }
  }

  void count_new(std::size_t k) {
    for (unsigned i = 0; i < Shape::verts; ++i) ++changes[corners(k)[i]].polys_after;
    for (unsigned j = 0; j < Shape::edges; ++j) {
      cavity_edge& x = edges[edges_of_new(k)[j]];
      x.first_new = std::min(x.first_new, static_cast<std::uint32_t>(k * Shape::edges + j));
      ++x.new_polys;
    }
    for (unsigned j = 0; j < Shape::faces; ++j) {
      face& x = faces[faces_of_new(k)[j]];
      const auto use = static_cast<std::uint32_t>(k * Shape::faces + j);
      x.new_uses[0] = std::min(x.new_uses[0], use), x.new_uses[1] = use;
      ++x.new_polys;
    }
  }
  /// Finds face x of new polys among those of other polys. The mesh can only have it if it has all its edges.
  template<class Tables>
  void find_outside_cavity(const Tables& t, face& x,
                           const std::array<std::uint32_t, Shape::face_verts>& edges_of_x) const {
    bool is_new = false;
    for (const std::uint32_t e : edges_of_x) is_new |= edges[e].id.is_none();
    if (is_new) return;
    const unsigned* const v = corners_of_poly(x.first_use / Shape::faces);
    vert_id all[Shape::verts];
    for (unsigned i = 0; i < Shape::verts; ++i) all[i] = v[i] < num_old_verts ? verts[v[i]] : vert_id{};
    x.id = t.face_on(all, x.first_use % Shape::faces);
    if (!x.id.is_none()) x.num_polys = static_cast<std::uint32_t>(t.adj_f2p(x.id).size());
  }

  /// An edge remains one fan if the faces between its old polys and others are those between its new polys and others,
  /// and the new polys are connected.
  template<class Tables>
  void compare_faces(const Tables& t) {
    for (face& x : faces) {
      const auto edges_of_x = edges_of(x);
      if (x.id.is_none()) find_outside_cavity(t, x, edges_of_x);
      num_new_faces += x.id.is_none();
      num_unused_faces += x.is_unused();
      const std::uint32_t others = x.num_polys - x.old_polys;
      const bool is_irregular =
          others == 0 ? x.old_polys > 2 || x.new_polys > 2 : others > 1 || x.old_polys != 1 || x.new_polys != 1;
      const bool is_old_joint = x.old_polys == 2, is_new_joint = is_joint(x);
      for (const std::uint32_t e : edges_of_x) {
        fan_change& fan = fans[e];
        fan.is_irregular |= is_irregular;
        fan.has_others |= others > 0;
        fan.old_joints += is_old_joint;
        fan.new_joints += is_new_joint;
      }
      if (is_new_joint) {
        links_.join(x.new_uses[0], x.new_uses[1]);
        if (Shape::verts == 4 && opposite(x.new_uses[0]) == opposite(x.new_uses[1])) links_.allow_rings_of_two();
      } else if (x.new_polys == 1 && others == 0) {
        links_.set_alone(x.new_uses[0]);
      }
    }
  }
  /// The corner of a new tet that is not at the face with this use.
  unsigned opposite(std::uint32_t use) const {
    const auto& at = Shape::face_vert[use % Shape::faces];
    return corners(use / Shape::faces)[6 - at[0] - at[1] - at[2]];
  }
  /// Whether face x connects two new polys.
  static bool is_joint(const face& x) { return x.new_polys == 2 && has_no_others(x); }

  /// Counts polys at edges. Those of an edge that is one fan are not counted: it is enough that it has a poly besides
  /// the old ones.
  template<class Tables>
  void compare_edges(const Tables& t) {
    for (cavity_edge& x : edges) {
      fan_change& fan = fans[edges.number(x)];
      if (x.id.is_none()) {
        ++num_new_edges, ++changes[x.a].edges_gained, ++changes[x.b].edges_gained;
      } else {
        x.num_polys = x.old_polys + fan.has_others;
        const bool is_non_manifold = t.is_non_manifold(x.id);
        if (is_non_manifold) x.num_polys = static_cast<std::uint32_t>(t.poly_list(x.id).size());
        else if (x.old_polys == 0) x.num_polys = 1;
        fan.is_irregular |= is_non_manifold || x.old_polys == 0 || x.old_polys > fan.old_joints + 1;
        if (x.is_unused()) ++num_unused_edges, ++changes[x.a].edges_lost, ++changes[x.b].edges_lost;
      }
      fan.is_irregular |= x.new_polys > 0 && !links_.connect(edges.number(x), x, fan.new_joints, edges_of_new(0));
    }
  }
};

}  // namespace concino::detail

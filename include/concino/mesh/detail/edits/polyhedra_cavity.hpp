// A cavity of general polyhedra: the verts, edges and faces of its old and new polys by local numbers, and what changes
// at each of them.
#pragma once

#include <concino/mesh/detail/edits/cavity_changes.hpp>
#include <concino/mesh/detail/edits/cavity_input.hpp>

namespace concino::detail {

struct polyhedra_cavity_face {
  static constexpr unsigned longest_compared = 8;

  std::uint32_t first, size;  // where its corners are among those of all faces
  face_id id;                 // none if the mesh does not have it yet
  std::uint32_t old_polys = 0;  // of the cavity, at it
  std::uint32_t new_polys = 0;
  std::uint32_t num_polys = 0;  // of the mesh, at it before
  std::uint32_t last_poly = ~0u;       // the last new poly that has it
  const unsigned* corners = nullptr;  // set when all faces are known
  std::uint32_t partner = ~0u;         // of a new face: the number of the unused face whose descriptor it takes; of
                                       // that one: the number of the new face

  bool has_partner() const { return partner != ~0u; }
  bool is_unused() const { return !id.is_none() && new_polys == 0 && old_polys > 0 && old_polys == num_polys; }
  bool shares_all_but_one(const polyhedra_cavity_face& x) const {
    if (size > longest_compared || x.size > longest_compared) return false;
    unsigned common = 0;
    for (std::uint32_t i = 0; i < size; ++i)
      common += std::find(x.corners, x.corners + x.size, corners[i]) != x.corners + x.size;
    return common + 1 == size;
  }
};

/// 1 if two lists of n different values are the same cycle, -1 if the one is the other reversed, 0 if they differ.
template<class T>
int compare_cycles(const T* a, const T* b, std::size_t n) {
  const auto at = static_cast<std::size_t>(std::find(b, b + n, a[0]) - b);
  if (at == n) return 0;
  bool forward = true, backward = true;
  for (std::size_t i = 1; i < n; ++i) {
    forward = forward && a[i] == b[at + i < n ? at + i : at + i - n];
    backward = backward && a[i] == b[i <= at ? at - i : at + n - i];
  }
  return forward ? 1 : backward ? -1 : 0;
}

class polyhedra_cavity {
 public:
  using face = polyhedra_cavity_face;

  const native_cavity& c;
  const cavity_verts verts;
  const unsigned num_old_verts = static_cast<unsigned>(c.verts.size()),
                 num_verts = num_old_verts + static_cast<unsigned>(c.points.size());
  cavity_edges edges;  // old_polys, new_polys and num_polys count: unused old faces, new faces, all faces before
  core::small_array<face, 32> faces;
  core::small_array<vert_change, 32> changes;  // of verts
  // of the new polys, one after another
  core::small_array<unsigned, 32> faces_of_new, verts_of_new, verts_end, edges_of_new, edges_end;
  core::small_array<std::uint8_t, 32> outward_of_new;  // parallel to faces_of_new
  // of those that the mesh did not have, and of those that it loses
  std::size_t num_new_edges = 0, num_unused_edges = 0, num_new_faces = 0, num_unused_faces = 0;

  std::size_t num_new() const { return c.poly_ends.size(); }
  std::size_t num_added() const { return num_new() - c.kept; }
  unsigned first_face(std::size_t k) const { return k == 0 ? 0 : c.poly_ends[k - 1]; }
  std::size_t num_faces_of(std::size_t k) const { return c.poly_ends[k] - first_face(k); }
  std::size_t num_verts_of(std::size_t k) const { return verts_end[k] - begin_of(verts_end, k); }
  std::size_t num_edges_of(std::size_t k) const { return edges_end[k] - begin_of(edges_end, k); }
  std::size_t more_edges() const { return num_new_edges - std::min(num_new_edges, num_unused_edges); }
  std::size_t more_faces() const { return num_new_faces - std::min(num_new_faces, num_unused_faces); }
  /// Calls f(edge) for all edges of a face.
  template<class F>
  void for_each_edge(const face& x, const F& f) {
    for (std::uint32_t i = 0; i < x.size; ++i) f(edges.at(x.corners[i], x.corners[i + 1 == x.size ? 0 : i + 1]));
  }
  /// Where the values of new poly k begin.
  template<class Ends>
  static unsigned begin_of(const Ends& ends, std::size_t k) { return k == 0 ? 0 : ends[k - 1]; }

  template<class Tables>
  polyhedra_cavity(const Tables& t, const native_cavity& cavity)
      : c(cavity), verts(c.verts), edges(count_corners(t, c)) {
    changes.resize(num_verts, {});
    check_cavity_of_polyhedra(c, verts, t.verts(), t.polys());
    last_poly_of_vert_.resize(num_verts, ~0u);
    for (const poly_id p : c.polys) read_old_poly(t, p);
    for (std::size_t k = 0; k < num_new(); ++k) read_new_poly(t, k);
    for (face& x : faces) x.corners = corners_.begin() + x.first;
    compare_faces();
    compare_edges(t);
    for (unsigned v = num_old_verts - static_cast<unsigned>(c.removed); v < num_old_verts; ++v) {
      if (t.adj_v2p(verts[v]).size() != changes[v].polys_before) removed_vert_in_use(verts[v]);
      if (t.adj_v2e(verts[v]).size() != changes[v].edges_lost) removed_vert_with_face(verts[v]);
    }
    reuse_descriptors(edges, num_new_edges, num_unused_edges);
    reuse_descriptors(faces, num_new_faces, num_unused_faces);
  }

 private:
  core::small_array<unsigned, 128> corners_;                    // of faces: existing ones as the mesh stores them
  core::index_table numbers_;                                   // of faces
  core::small_array<std::uint32_t, 32> last_poly_of_vert_, last_poly_of_edge_;  // the last new poly that has it

  template<class Tables>
  static std::size_t count_corners(const Tables& t, const native_cavity& c) {
    std::size_t n = c.corners.size();
    for (const poly_id p : c.polys)
      if (t.polys().contains(p))
        for (const face_id f : t.adj_p2f(p)) n += t.adj_f2v(f).size();
    return n;
  }

  /// The face with the corners since `first`, which are the last ones. It has this id if it is not none. It is added if
  /// it is new; otherwise these corners are removed. `is_forward`: whether the face has them in this order.
  face& find_or_add_last(std::uint32_t first, face_id id, bool& is_forward) {
    const auto n = static_cast<std::uint32_t>(corners_.size()) - first;
    std::uint32_t hash = n;
    // the same in any order
    for (std::uint32_t i = first; i < corners_.size(); ++i) hash += core::index_table::hash(corners_[i]);
    int order = 0;
    const auto is_wanted = [&](std::uint32_t i) {
      const face& x = faces[i];
      if (x.size != n || (!id.is_none() && x.id != id)) return false;
      order = compare_cycles(corners_.begin() + x.first, corners_.begin() + first, n);
      return order != 0;
    };
    const std::uint32_t known = numbers_.find(hash, is_wanted);
    if (known != core::index_table::none) {
      is_forward = order > 0;
      corners_.resize(first, 0);
      return faces[known];
    }
    face x{};
    x.first = first, x.size = n, x.id = id;
    faces.push_back(x);
    numbers_.add(hash, static_cast<std::uint32_t>(faces.size() - 1));
    is_forward = true;
    return faces.back();
  }

  template<class Tables>
  void read_old_poly(const Tables& t, poly_id p) {
    const auto local = [&](vert_id v) {
      const unsigned i = verts.local(v);
      if (i == cavity_verts::none) missing_cavity_vert(p, v);
      return i;
    };
    for (const vert_id v : t.adj_p2v(p)) ++changes[local(v)].polys_before;
    const id_span<face_id> all = t.adj_p2f(p);
    for (std::uint32_t k = 0; k < all.size(); ++k) {
      const auto first = static_cast<std::uint32_t>(corners_.size());
      for (const vert_id v : t.adj_f2v(all[k])) corners_.push_back(local(v));
      bool is_forward = false;
      face& x = find_or_add_last(first, all[k], is_forward);
      if (x.old_polys++ == 0) x.num_polys = t.facet_adjacency_.num_polys_at(p, k);
    }
  }

  template<class Tables>
  void read_new_poly(const Tables& t, std::size_t k) {
    const auto poly = static_cast<std::uint32_t>(k);
    for (unsigned j = first_face(k); j < c.poly_ends[k]; ++j) {
      const auto first = static_cast<std::uint32_t>(corners_.size());
      const unsigned *const v = c.corners.begin() + begin_of(c.ends, j), *const last = c.corners.begin() + c.ends[j];
      for (const unsigned* i = v; i != last; ++i) {
        corners_.push_back(*i);
        if (last_poly_of_vert_[*i] != poly) {
          last_poly_of_vert_[*i] = poly;
          verts_of_new.push_back(*i);
          ++changes[*i].polys_after;
        }
        const unsigned e = edges.number(edges.at(*i, i + 1 == last ? *v : i[1]));
        last_poly_of_edge_.resize(edges.size(), ~0u);
        if (last_poly_of_edge_[e] != poly) {
          last_poly_of_edge_[e] = poly;
          edges_of_new.push_back(e);
        }
      }
      bool is_forward = false;
      face& x = find_or_add_last(first, {}, is_forward);
      if (x.last_poly == poly) repeated_cavity_face(k, j - first_face(k));
      x.last_poly = poly;
      if (x.new_polys++ == 0 && x.id.is_none()) is_forward = find_outside_cavity(t, x);
      faces_of_new.push_back(static_cast<unsigned>(&x - faces.begin()));
      outward_of_new.push_back(is_forward);
    }
    verts_end.push_back(static_cast<unsigned>(verts_of_new.size()));
    edges_end.push_back(static_cast<unsigned>(edges_of_new.size()));
  }

  /// Finds face x among those of other polys and those without polys, and takes over the order of its corners. Result:
  /// whether that is the direction that x had.
  template<class Tables>
  bool find_outside_cavity(const Tables& t, face& x) {
    unsigned* const v = corners_.begin() + x.first;
    if (std::any_of(v, v + x.size, [this](unsigned i) { return i >= num_old_verts; })) return true;
    const edge_id e = t.edge_between(verts[v[0]], verts[v[1]]);
    if (e.is_none()) return true;
    for (const face_id f : t.adj_e2f(e)) {
      const auto all = t.adj_f2v(f);
      if (all.size() != x.size) continue;
      core::small_array<unsigned, 16> other;
      for (const vert_id u : all) other.push_back(verts.local(u));
      const int order = compare_cycles<unsigned>(v, other.begin(), x.size);
      if (order == 0) continue;
      std::copy_n(other.begin(), x.size, v);
      x.id = f;
      x.num_polys = static_cast<std::uint32_t>(t.adj_f2p(f).size());
      return order > 0;
    }
    return true;
  }

  void compare_faces() {
    for (const face& x : faces) {
      const bool is_new = x.id.is_none();
      num_new_faces += is_new;
      num_unused_faces += x.is_unused();
      if (!is_new && !x.is_unused()) continue;
      for_each_edge(x, [&](cavity_edge& e) { ++(is_new ? e.new_polys : e.old_polys); });
    }
  }
  template<class Tables>
  void compare_edges(const Tables& t) {
    for (cavity_edge& x : edges) {
      if (x.b < num_old_verts) x.id = t.edge_between(verts[x.a], verts[x.b]);
      if (x.id.is_none()) {
        ++num_new_edges, ++changes[x.a].edges_gained, ++changes[x.b].edges_gained;
        continue;
      }
      x.num_polys = static_cast<std::uint32_t>(t.adj_e2f(x.id).size());
      if (x.is_unused()) ++num_unused_edges, ++changes[x.a].edges_lost, ++changes[x.b].edges_lost;
    }
  }
};

}  // namespace concino::detail

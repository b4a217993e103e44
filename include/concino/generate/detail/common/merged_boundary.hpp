// The boundary of the union of several polys of a mesh, and whether the union is a disk or a ball.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/concepts/oriented_edges.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// The reason why polys do not form a disk or ball. Without a text, they do.
struct merge_fault {
  const char* text = "";
  std::size_t index = ~std::size_t{0};  // of the element to name at the end of the text, if any
  explicit operator bool() const { return *text != 0; }
};

/// Values of some elements of one kind, which can be cleared in constant time.
template<class T>
class stamped_array {
  std::vector<std::uint32_t> stamp_;
  std::vector<T> value_;
  std::uint32_t now_ = 1;

 public:
  explicit stamped_array(std::size_t bound) : stamp_(bound, 0), value_(bound) {}
  void clear() { ++now_; }
  bool has(std::size_t i) const { return stamp_[i] == now_; }
  T& operator[](std::size_t i) { return value_[i]; }
  /// Sets a value unless it is set. Returns whether it was not set since clear().
  bool add(std::size_t i, const T& x) {
    if (has(i)) return false;
    stamp_[i] = now_;
    value_[i] = x;
    return true;
  }
};

/// A set of polys, with a test whether they are connected through edges (surfaces) or faces (volumes).
template<AnyMesh M>
class merged_polys {
  const M& m_;
  stamped_array<unsigned char> in_;
  std::vector<poly_t<M>> queue_;

 public:
  explicit merged_polys(const M& m) : m_(m), in_(poly_index_bound(m)) {}

  /// Replaces the set. Returns whether the polys are connected. Its own search takes time proportional to the set; bfs
  /// would fill a map of all polys.
  bool set(std::span<const poly_t<M>> polys) {
    in_.clear();
    for (const poly_t<M>& p : polys) in_.add(index_of(m_, p), 1);
    queue_.assign(1, polys.front());
    in_[index_of(m_, polys.front())] = 0;
    for (std::size_t k = 0; k < queue_.size(); ++k) {
      const poly_t<M> at = queue_[k];
      for (const poly_t<M> q : adj_p2p(m_, at)) {
        const std::size_t i = index_of(m_, q);
        if (!in_.has(i) || !in_[i]) continue;
        in_[i] = 0;
        queue_.push_back(q);
      }
    }
    return queue_.size() == polys.size();
  }
  template<class R>
  std::size_t count(const R& polys) const {
    std::size_t n = 0;
    for (const poly_t<M> p : polys) n += in_.has(index_of(m_, p));
    return n;
  }
};

template<class M> class merged_boundary;

/// On a surface, the boundary of the union is the cycle of verts of one polygon.
template<SurfaceMesh M>
class merged_boundary<M> {
  struct boundary_edge { vert_t<M> from, to; };
  const M& m_;
  merged_polys<M> members_;
  stamped_array<std::uint32_t> leaving_, first_from_;  // by vert: the boundary edge from it; by interior edge: its
                                                       // first vert in the first poly
  stamped_array<unsigned char> visited_;
  std::vector<boundary_edge> edges_;
  std::vector<vert_t<M>> ring_;

 public:
  explicit merged_boundary(const M& m)
      : m_(m), members_(m), leaving_(vert_index_bound(m)), first_from_(edge_index_bound(m)),
        visited_(vert_index_bound(m)) {
  }

  const std::vector<vert_t<M>>& ring() const { return ring_; }

  /// Finds the boundary cycle of one or more polys. A single poly is not checked.
  merge_fault read(std::span<const poly_t<M>> polys) {
    ring_.clear();
    if (polys.size() == 1) {
      for (const vert_t<M> v : adj_p2v(m_, polys.front())) ring_.push_back(v);
      return {};
    }
    if (!members_.set(polys)) return {"they are not connected across edges"};
    leaving_.clear(), first_from_.clear(), visited_.clear(), edges_.clear();
    std::ptrdiff_t inside = 0, visited = 0;
    merge_fault fault;
    for (const poly_t<M>& p : polys) {
      for (const auto& [e, from, to] : oriented_edges(m_, p)) {
        visited += visited_.add(index_of(m_, from), 1);
        const std::size_t n = members_.count(adj_e2p(m_, e)), at = index_of(m_, from);
        if (n > 2) fault = {"more than two of them meet at edge", index_of(m_, e)};
        if (n == 1) {
          if (!leaving_.add(at, static_cast<std::uint32_t>(edges_.size())))
            fault = {"their boundary passes twice through vert", at};
          edges_.push_back({from, to});
        } else if (first_from_.add(index_of(m_, e), static_cast<std::uint32_t>(at))) {
          ++inside;
        } else if (first_from_[index_of(m_, e)] == at) {
          fault = {"two of them run in the same direction along edge", index_of(m_, e)};
        }
      }
      if (fault) return fault;
    }
    if (edges_.empty()) return {"they have no boundary"};
    for (std::size_t k = 0; ring_.size() < edges_.size();) {
      ring_.push_back(edges_[k].from);
      const std::size_t next = index_of(m_, edges_[k].to);
      k = leaving_.has(next) ? leaving_[next] : 0;
      if (k == 0) break;
    }
    if (ring_.size() != edges_.size()) return {"they have more than one boundary"};
    const std::ptrdiff_t chi =
        visited - inside - static_cast<std::ptrdiff_t>(edges_.size()) + static_cast<std::ptrdiff_t>(polys.size());
    if (chi != 1) return {"they have a handle, or touch themselves at a vert"};
    return {};
  }
};

/// In a volume, the boundary of the union is the faces of one polyhedron.
template<VolumeMesh M>
class merged_boundary<M> {
 public:
  struct boundary_face { face_t<M> face; bool outward; };

 private:
  const M& m_;
  merged_polys<M> members_;
  stamped_array<unsigned char> inside_, met_vert_, times_;   // by face: whether the first poly has it outward; by edge:
                                                             // the number of its boundary faces
  stamped_array<std::uint32_t> first_face_;                  // by edge
  std::vector<boundary_face> faces_;

 public:
  explicit merged_boundary(const M& m)
      : m_(m), members_(m), inside_(face_index_bound(m)), met_vert_(vert_index_bound(m)), times_(edge_index_bound(m)),
        first_face_(edge_index_bound(m)) {}

  const std::vector<boundary_face>& boundary_faces() const { return faces_; }

  /// Finds the boundary faces of one or more polys. A single poly is not checked.
  merge_fault read(std::span<const poly_t<M>> polys) {
    faces_.clear();
    if (polys.size() == 1) {
      for (const face_t<M> f : adj_p2f(m_, polys.front())) faces_.push_back({f, face_is_outward(m_, polys.front(), f)});
      return {};
    }
    if (!members_.set(polys)) return {"they are not connected across faces"};
    inside_.clear(), met_vert_.clear(), times_.clear(), first_face_.clear();
    for (const poly_t<M>& p : polys)
      for (const face_t<M> f : adj_p2f(m_, p)) {
        const std::size_t n = members_.count(adj_f2p(m_, f)), i = index_of(m_, f);
        if (n > 2) return {"more than two of them meet at face", i};
        const bool outward = face_is_outward(m_, p, f);
        if (n == 1) faces_.push_back({f, outward});
        else if (!inside_.add(i, outward) && (inside_[i] != 0) == outward)
          return {"two of them lie on the same side of face", i};
      }
    if (faces_.empty()) return {"they have no boundary"};
    disjoint_sets pieces(faces_.size());
    std::size_t num_pieces = faces_.size(), open = 0;
    std::ptrdiff_t chi = static_cast<std::ptrdiff_t>(faces_.size());
    for (std::size_t k = 0; k < faces_.size(); ++k) {
      for (const edge_t<M> e : adj_f2e(m_, faces_[k].face)) {
        const std::size_t i = index_of(m_, e);
        if (first_face_.add(i, static_cast<std::uint32_t>(k))) {
          times_.add(i, 1);
          --chi, ++open;
          continue;
        }
        if (++times_[i] == 2) --open;
        else return {"their boundary passes twice through edge", i};
        num_pieces -= pieces.unite(first_face_[i], k);
      }
      for (const vert_t<M> v : adj_f2v(m_, faces_[k].face)) chi += met_vert_.add(index_of(m_, v), 1);
    }
    if (open != 0) return {"their border is not closed"};
    if (num_pieces != 1) return {"they have more than one boundary"};
    if (chi != 2) return {"they have a handle, or their boundary touches itself at a vert"};
    return {};
  }
};

}  // namespace concino::detail

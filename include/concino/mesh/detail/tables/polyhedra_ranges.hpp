// Ranges for adjacencies of general polyhedra that are not stored: the polys around an edge, the faces at a vert, the
// edges of a face. The cost of each is about the total size of the elements that it visits.
#pragma once

#include <concino/mesh/detail/facets/adjacent_polys.hpp>

namespace concino::detail {

/// The polys of the faces at an edge, each once.
template<class Tables>
class polys_of_faces {
  const Tables* tables_ = nullptr;
  id_span<face_id> faces_;

 public:
  using value_type = poly_id;
  class iterator {
    const Tables* tables_ = nullptr;
    const face_id *first_ = nullptr, *at_ = nullptr, *last_ = nullptr;
    polys_of_facet now_{};
    std::uint32_t i_ = 0;

    bool visited_before(poly_id q) const {
      if (at_ - first_ > 64)
        if (const auto faces = tables_->adj_p2f(q); 16 * faces.size() < static_cast<std::size_t>(at_ - first_))
          return visited_before(faces);
      for (const face_id* f = first_; f != at_; ++f)
        for (const poly_id r : tables_->adj_f2p(*f))
          if (r == q) return true;
      return false;
    }
    /// The faces at an edge are in ascending order.
    bool visited_before(id_span<face_id> faces) const {
      return std::any_of(faces.begin(), faces.end(), [this](face_id f) { return std::binary_search(first_, at_, f); });
    }
    void skip_invalid() {
      for (; at_ != last_; ++at_, i_ = 0) {
        if (i_ == 0) now_ = tables_->adj_f2p(*at_);
        for (; i_ < now_.size(); ++i_)
          if (!visited_before(now_[i_])) return;
      }
    }

   public:
    using value_type = poly_id;
    using reference = poly_id;
    using difference_type = std::ptrdiff_t;
    iterator() = default;
    iterator(const Tables* t, const face_id* at, const face_id* last) : tables_(t), first_(at), at_(at), last_(last) {
      skip_invalid();
    }
    poly_id operator*() const { return now_[i_]; }
    iterator& operator++() {
      ++i_;
      skip_invalid();
      return *this;
    }
    iterator operator++(int) { iterator old = *this; ++*this; return old; }
    friend bool operator==(const iterator& a, const iterator& b) { return a.at_ == b.at_ && a.i_ == b.i_; }
  };

  polys_of_faces() = default;
  polys_of_faces(const Tables* t, id_span<face_id> faces) : tables_(t), faces_(faces) {}
  iterator begin() const { return {tables_, faces_.begin(), faces_.end()}; }
  iterator end() const { return {tables_, faces_.end(), faces_.end()}; }
};

/// The faces at a vert. A face has two edges there; it is found at the one that leads to the next vert of the face.
template<class Tables>
class faces_at_edges {
  const Tables* tables_ = nullptr;
  vert_id vert_;

 public:
  using value_type = face_id;
  class iterator {
    const Tables* tables_ = nullptr;
    vert_id vert_;
    std::uint32_t i_ = 0, j_ = 0;

    void skip_invalid() {
      const id_span<edge_id> edges = tables_->adj_v2e(vert_);
      for (; i_ < edges.size(); ++i_, j_ = 0) {
        const vert_id far = tables_->adj_v2v(vert_)[i_];
        const id_span<face_id> faces = tables_->adj_e2f(edges[i_]);
        for (; j_ < faces.size(); ++j_)
          if (tables_->next_in_face(faces[j_], vert_) == far) return;
      }
    }

   public:
    using value_type = face_id;
    using reference = face_id;
    using difference_type = std::ptrdiff_t;
    iterator() = default;
    iterator(const Tables* t, vert_id v, std::uint32_t i) : tables_(t), vert_(v), i_(i) { skip_invalid(); }
    face_id operator*() const { return tables_->adj_e2f(tables_->adj_v2e(vert_)[i_])[j_]; }
    iterator& operator++() {
      ++j_;
      skip_invalid();
      return *this;
    }
    iterator operator++(int) { iterator old = *this; ++*this; return old; }
    friend bool operator==(const iterator& a, const iterator& b) { return a.i_ == b.i_ && a.j_ == b.j_; }
  };

  faces_at_edges() = default;
  faces_at_edges(const Tables* t, vert_id v) : tables_(t), vert_(v) {}
  iterator begin() const { return {tables_, vert_, 0}; }
  iterator end() const { return {tables_, vert_, static_cast<std::uint32_t>(tables_->adj_v2e(vert_).size())}; }
};

/// The edges of a face. Each is looked up between two consecutive verts.
template<class Tables, class Verts>
class edges_between {
  const Tables* tables_ = nullptr;
  Verts verts_;

 public:
  using value_type = edge_id;
  using iterator = index_iterator<edges_between>;

  edges_between() = default;
  edges_between(const Tables* t, Verts verts) : tables_(t), verts_(verts) {}
  std::size_t size() const { return verts_.size(); }
  edge_id operator[](std::size_t k) const {
    return tables_->edge_between(verts_[k], verts_[k + 1 == size() ? 0 : k + 1]);
  }
  iterator begin() const { return {*this, 0}; }
  iterator end() const { return {*this, size()}; }
};

}  // namespace concino::detail

// Ranges for adjacencies of tets and hexes that are not stored: the polys and faces around an edge, the faces at a
// vert, the verts and edges of a face. Each costs time proportional to its number of elements.
#pragma once

#include <concino/mesh/detail/cells/shapes.hpp>
#include <concino/mesh/detail/facets/facet_adjacency.hpp>

namespace concino::detail {

/// At most N values, stored inside the object.
template<class T, unsigned N>
class inline_array {
  T values_[N] = {};

 public:
  using value_type = T;
  constexpr T& operator[](std::size_t i) { return values_[i]; }
  constexpr const T& operator[](std::size_t i) const { return values_[i]; }
  constexpr std::size_t size() const { return N; }
  constexpr bool empty() const { return false; }
  constexpr const T* begin() const { return values_; }
  constexpr const T* end() const { return values_ + N; }
};

/// The polys around an edge, found by steps from poly to poly through the faces at the edge. The walk goes in one
/// direction until it meets the boundary or the first poly again; after the boundary it continues from the first poly
/// in the other direction. If the polys are not one such fan, their list is read instead.
template<class Tables>
class polys_around_edge {
  const Tables* tables_ = nullptr;
  edge_id edge_;

 public:
  using value_type = poly_id;
  class iterator {
    const Tables* tables_ = nullptr;
    const poly_id* poly_list_ = nullptr;
    edge_id edge_;
    poly_id at_;                      // none: past the end
    std::uint32_t left_or_face_ = 0;  // list: how many are left; fan: the local face through which the walk leaves
    bool turned_ = false;

    void step() {
      const poly_id next = tables_->neighbour_at_face(at_, left_or_face_);
      if (next.is_none()) {
        if (turned_) { at_ = {}; return; }
        turned_ = true;
        const poly_id start = tables_->first_poly(edge_);
        left_or_face_ = tables_->faces_at(start, edge_)[1];
        at_ = tables_->neighbour_at_face(start, left_or_face_);
        if (!at_.is_none()) enter_from(start, left_or_face_);
      } else if (!turned_ && next == tables_->first_poly(edge_)) {
        at_ = {};
      } else {
        const poly_id from = at_;
        at_ = next;
        enter_from(from, left_or_face_);
      }
    }
    void enter_from(poly_id from, std::uint32_t by) {
      const face_id f = tables_->adj_p2f(from)[by];
      const auto two = tables_->faces_at(at_, edge_);
      left_or_face_ = tables_->adj_p2f(at_)[two[0]] == f ? two[1] : two[0];
    }

   public:
    using value_type = poly_id;
    using reference = poly_id;
    using difference_type = std::ptrdiff_t;

    iterator() = default;
    iterator(const Tables* t, edge_id e) : tables_(t), edge_(e) {
      if (t->is_non_manifold(e)) {
        const auto poly_list = t->poly_list(e);
        poly_list_ = poly_list.begin();
        left_or_face_ = static_cast<std::uint32_t>(poly_list.size());
        at_ = left_or_face_ ? *poly_list_ : poly_id{};
      } else {
        at_ = t->first_poly(e);
        left_or_face_ = t->faces_at(at_, e)[0];
      }
    }
    poly_id operator*() const { return at_; }
    iterator& operator++() {
      if (poly_list_) at_ = --left_or_face_ ? *++poly_list_ : poly_id{};
      else step();
      return *this;
    }
    iterator operator++(int) { iterator old = *this; ++*this; return old; }
    friend bool operator==(const iterator& a, const iterator& b) { return a.at_ == b.at_; }
  };

  polys_around_edge() = default;
  polys_around_edge(const Tables* t, edge_id e) : tables_(t), edge_(e) {}
  iterator begin() const { return {tables_, edge_}; }
  iterator end() const { return {}; }
};

/// The faces owned by the polys of a range, among the few that `faces_of` gives for each poly. A face has one owner, so
/// each occurs once.
template<class Tables, class Polys, class FacesOf, unsigned MaxFaces>
class owned_faces {
  const Tables* tables_ = nullptr;
  Polys polys_;
  FacesOf faces_of_;

 public:
  using value_type = face_id;
  class iterator {
    using poly_iterator = decltype(std::declval<const Polys&>().begin());
    const Tables* tables_ = nullptr;
    poly_iterator at_{}, last_{};
    FacesOf faces_of_{};
    inline_array<std::uint8_t, MaxFaces> local_{};
    unsigned i_ = 0;

    void skip_invalid() {
      for (; at_ != last_; ++at_, i_ = 0) {
        const poly_id p = *at_;
        if (i_ == 0) local_ = faces_of_(*tables_, p);
        for (; i_ < MaxFaces; ++i_)
          if (tables_->owns(p, local_[i_])) return;
      }
      i_ = 0;
    }

   public:
    using value_type = face_id;
    using reference = face_id;
    using difference_type = std::ptrdiff_t;
    iterator() = default;
    iterator(const Tables* t, poly_iterator at, poly_iterator last, FacesOf faces_of)
        : tables_(t), at_(at), last_(last), faces_of_(faces_of) {
      skip_invalid();
    }
    face_id operator*() const { return tables_->adj_p2f(*at_)[local_[i_]]; }
    iterator& operator++() {
      ++i_;
      skip_invalid();
      return *this;
    }
    iterator operator++(int) { iterator old = *this; ++*this; return old; }
    friend bool operator==(const iterator& a, const iterator& b) { return a.at_ == b.at_ && a.i_ == b.i_; }
  };

  owned_faces() = default;
  owned_faces(const Tables* t, Polys polys, FacesOf faces_of) : tables_(t), polys_(polys), faces_of_(faces_of) {}
  iterator begin() const { return {tables_, polys_.begin(), polys_.end(), faces_of_}; }
  iterator end() const { return {tables_, polys_.end(), polys_.end(), faces_of_}; }
};

struct faces_at_edge {
  edge_id e;
  template<class Tables>
  inline_array<std::uint8_t, 2> operator()(const Tables& t, poly_id p) const { return t.faces_at(p, e); }
};
struct faces_at_vert {
  vert_id v;
  template<class Tables>
  inline_array<std::uint8_t, 3> operator()(const Tables& t, poly_id p) const { return t.faces_at(p, v); }
};

}  // namespace concino::detail

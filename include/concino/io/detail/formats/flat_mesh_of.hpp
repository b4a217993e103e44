// Converts any mesh to a flat_mesh, without copying arrays that the mesh already stores in this form.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>
#include <concino/io/flat_mesh.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/property.hpp>

#include <array>
#include <type_traits>
#include <vector>

namespace concino::detail {

/// Collects lists one by one. It refers to the originals as long as each list begins where the previous one ends, and
/// copies them otherwise.
template<class T>
class list_collector {
  const T* first_ = nullptr;
  std::vector<T> copies_;
  std::vector<std::size_t> offsets_;  // as soon as lists differ in length
  std::size_t lists_ = 0, values_ = 0, arity_ = 0;
  bool is_copy_;

  void end(std::size_t length);

 public:
  explicit list_collector(bool copy) : is_copy_(copy) {}

  void refer_to(const T* first, const T* last);
  void push(T x) { copies_.push_back(x); }
  /// Ends a list whose values were added by push().
  void end_list() { end(copies_.size() - values_); }

  flat_lists<T> lists() const;
};

/// Numbers the elements in the order of iteration. `indices` maps numbers to indices and `numbers` maps back; both are
/// empty if the indices are 0, 1, 2, ... in this order.
struct element_numbers {
  std::vector<std::uint32_t> indices, numbers;
  std::size_t size = 0;
  bool lists_hold_numbers = true;  // the ids of elements are equal to their numbers, so lists of ids need not be copied

  template<class X>
  void add(const X& x, std::size_t index, std::size_t bound) {
    if constexpr (requires { x.raw(); }) lists_hold_numbers = lists_hold_numbers && x.raw() == size;
    if (index != size && numbers.empty()) renumber(bound);
    if (!numbers.empty()) {
      numbers[index] = static_cast<std::uint32_t>(size);
      indices.push_back(static_cast<std::uint32_t>(index));
    }
    ++size;
  }
  std::uint32_t number_of(std::size_t index) const {
    return numbers.empty() ? static_cast<std::uint32_t>(index) : numbers[index];
  }

 private:
  void renumber(std::size_t bound);
};

template<class M>
class flat_mesh_of final : public flat_mesh {
  const M& mesh_;
  element_numbers verts_, faces_;
  std::vector<vec3> own_points_;
  std::vector<std::uint32_t> poly_indices_;
  list_collector<vert_id> poly_verts_, face_verts_;
  list_collector<face_id> poly_faces_;
  std::vector<std::uint8_t> outward_;

  /// Adds a list of verts or faces, as numbers.
  template<class Id, class X, class R>
  static void add_list(list_collector<Id>& lists, const element_numbers& of, const M& m, const R& range) {
    if constexpr (std::is_same_v<R, id_span<Id>>) {
      if (of.lists_hold_numbers) return lists.refer_to(range.begin(), range.end());
    }
    for (const X x : range) lists.push(Id{of.number_of(index_of(m, x))});
    lists.end_list();
  }

  void collect_points() {
    constexpr bool lie_in_the_mesh = std::is_same_v<decltype(point(mesh_, *verts(mesh_).begin())), const vec3&>;
    if constexpr (lie_in_the_mesh) {
      const vec3* first = nullptr;
      std::size_t n = 0;
      for (const vert_t<M> v : verts(mesh_)) {
        const vec3& p = point(mesh_, v);
        if (n == 0) first = &p;
        else if (&p != first + n) break;
        ++n;
      }
      points = {first, n};
      if (n == verts_.size) return;
    }
    own_points_.reserve(verts_.size);
    for (const vert_t<M> v : verts(mesh_)) own_points_.push_back(to_vec3(point(mesh_, v)));
    points = own_points_;
  }

  void make_polyhedra() override {
    if constexpr (dimension_v<M> == 3) {  // surfaces have no polyhedra
      for (const face_t<M> f : faces(mesh_)) faces_.add(f, index_of(mesh_, f), face_index_bound(mesh_));
      face_verts_ =
          list_collector<vert_id>(!can_refer_to<vert_id, decltype(adj_f2v(mesh_, *faces(mesh_).begin()))>(verts_));
      poly_faces_ =
          list_collector<face_id>(!can_refer_to<face_id, decltype(adj_p2f(mesh_, *polys(mesh_).begin()))>(faces_));
      for (const face_t<M> f : faces(mesh_))
        add_list<vert_id, vert_t<M>>(face_verts_, verts_, mesh_, adj_f2v(mesh_, f));
      for (const poly_t<M> p : polys(mesh_)) {
        add_list<face_id, face_t<M>>(poly_faces_, faces_, mesh_, adj_p2f(mesh_, p));
        for (const face_t<M> f : adj_p2f(mesh_, p)) outward_.push_back(face_is_outward(mesh_, p, f) ? 1 : 0);
      }
      face_indices = faces_.indices;
      polyhedra_ = {face_verts_.lists(), poly_faces_.lists(), outward_};
    }
  }

  void make_edges() override {
    element_numbers numbered;
    for (const edge_t<M> e : edges(mesh_)) {
      numbered.add(e, index_of(mesh_, e), edge_index_bound(mesh_));
      std::array<vert_id, 2> ends;
      std::size_t k = 0;
      for (const vert_t<M> v : adj_e2v(mesh_, e))
        if (k < 2) ends[k++] = vert_id{verts_.number_of(index_of(mesh_, v))};
      edge_verts_.push_back(ends);
    }
    edge_indices_ = std::move(numbered.indices);
  }

  void make_corners() override {
    if constexpr (NumbersCorners<M> && dimension_v<M> == 2) {  // writers of volumes ask for no corners
      bool is_equal = true;
      for (const poly_t<M> p : polys(mesh_)) {
        const std::size_t first = traits<M>::first_corner(mesh_, p), n = num_elements(adj_p2v(mesh_, p));
        for (std::size_t k = 0; k < n; ++k) {
          is_equal = is_equal && first + k == corner_indices_.size();
          corner_indices_.push_back(static_cast<std::uint32_t>(first + k));
        }
      }
      if (is_equal) corner_indices_.clear();
    }
  }

  template<class Id, class R>
  static bool can_refer_to(const element_numbers& of) {
    return std::is_same_v<std::remove_cvref_t<R>, id_span<Id>> && of.lists_hold_numbers;
  }

 public:
  /// The mesh must not change as long as this object is used.
  explicit flat_mesh_of(const M& m) : mesh_(m), poly_verts_(true), face_verts_(true), poly_faces_(true) {
    dimension = dimension_v<M>;
    arity = static_cast<std::uint32_t>(arity_v<M>);
    if constexpr (ShowsProperties<M>) properties = &traits<M>::properties(m);
    for (const vert_t<M> v : verts(m)) verts_.add(v, index_of(m, v), vert_index_bound(m));
    vert_indices = verts_.indices;
    collect_points();
    element_numbers numbered;
    poly_verts_ = list_collector<vert_id>(!can_refer_to<vert_id, decltype(adj_p2v(m, *polys(m).begin()))>(verts_));
    for (const poly_t<M> p : polys(m)) {
      numbered.add(p, index_of(m, p), poly_index_bound(m));
      if constexpr (dimension_v<M> == 2 || arity_v<M> == 4 || arity_v<M> == 8)  // polyhedra are lists of faces
        add_list<vert_id, vert_t<M>>(poly_verts_, verts_, m, adj_p2v(m, p));
    }
    num_polys = numbered.size;
    poly_indices_ = std::move(numbered.indices);
    poly_indices = poly_indices_;
    poly_verts = poly_verts_.lists();
  }

  std::size_t num_loose_edges() const override {
    std::size_t n = 0;
    if constexpr (!from_surface<M> && !from_cells<M> && !from_polyhedra<M>)  // native meshes have no such edges
      for (const edge_t<M> e : edges(mesh_)) {
        const auto is_empty = [](const auto& around) { return !(around.begin() != around.end()); };
        // edges bound polys in a surface, and faces in a volume
        if constexpr (dimension_v<M> == 2) n += is_empty(adj_e2p(mesh_, e));
        else n += is_empty(adj_e2f(mesh_, e));
      }
    return n;
  }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/formats/flat_mesh_of.ipp>
#endif

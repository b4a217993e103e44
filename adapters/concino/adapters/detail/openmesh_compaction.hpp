// Garbage collection of an OpenMesh mesh that allocates all memory before anything changes. OpenMesh's own function
// accesses its properties by functions whose assertions allocate memory, also in libraries as Debian builds them.
#pragma once

#include <concino/adapters/detail/openmesh_links.hpp>
#include <concino/mesh/element_origins.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// New numbers of the elements of one kind: the last ones move into the gaps, as in OpenMesh.
template<class Handle>
struct openmesh_renumbering {
  std::vector<std::uint32_t> origins;  // by new number
  std::vector<int> numbers;            // by old number
  std::vector<int> moved;              // the new numbers of those that move

  openmesh_renumbering(const openmesh_elements<Handle>& all, std::size_t bound) : origins(all.count()), numbers(bound) {
    const int n = static_cast<int>(origins.size());
    moved.reserve(origins.size());
    int last = static_cast<int>(bound);
    for (int i = 0; i < n; ++i) {
      const bool stays = all.contains(Handle(i));
      if (!stays) {
        do --last;
        while (!all.contains(Handle(last)));
        moved.push_back(i);
      }
      const int old = stays ? i : last;
      origins[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(old),
      numbers[static_cast<std::size_t>(old)] = i;
    }
  }
  int origin(int i) const { return static_cast<int>(origins[static_cast<std::size_t>(i)]); }
  Handle operator[](Handle old) const { return Handle(numbers[static_cast<std::size_t>(old.idx())]); }
  int size() const { return static_cast<int>(origins.size()); }
};

class openmesh_compaction {
  using mesh = OpenMesh::PolyConnectivity;

  mesh& m_;
  openmesh_renumbering<OpenMesh::VertexHandle> verts_;
  openmesh_renumbering<OpenMesh::EdgeHandle> edges_;
  openmesh_renumbering<OpenMesh::FaceHandle> polys_;

  OpenMesh::HalfedgeHandle moved(OpenMesh::HalfedgeHandle h) const {
    return h.is_valid()
               ? OpenMesh::HalfedgeHandle(2 * edges_.numbers[static_cast<std::size_t>(h.idx() >> 1)] + (h.idx() & 1))
               : h;
  }
  template<class Iterator>
  static void swap_values(Iterator first, Iterator last, int i, int j) {
    for (; first != last; ++first)
      if (*first) (*first)->swap(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  }
  void move_elements() {
    for (const int i : verts_.moved) {
      m_.vertex(OpenMesh::VertexHandle(i)) = m_.vertex(OpenMesh::VertexHandle(verts_.origin(i)));
      swap_values(m_.vprops_begin(), m_.vprops_end(), i, verts_.origin(i));
    }
    for (const int i : edges_.moved) {
      m_.edge(OpenMesh::EdgeHandle(i)) = m_.edge(OpenMesh::EdgeHandle(edges_.origin(i)));
      swap_values(m_.eprops_begin(), m_.eprops_end(), i, edges_.origin(i));
      for (const int k : {0, 1}) swap_values(m_.hprops_begin(), m_.hprops_end(), 2 * i + k, 2 * edges_.origin(i) + k);
    }
    for (const int i : polys_.moved) {
      m_.face(OpenMesh::FaceHandle(i)) = m_.face(OpenMesh::FaceHandle(polys_.origin(i)));
      swap_values(m_.fprops_begin(), m_.fprops_end(), i, polys_.origin(i));
    }
  }
  void renumber_links() {
    for (int i = 0; i < verts_.size(); ++i) {
      const OpenMesh::VertexHandle v(i);
      m_.set_halfedge_handle(v, moved(m_.halfedge_handle(v)));
    }
    for (int i = 0; i < 2 * edges_.size(); ++i) {
      const OpenMesh::HalfedgeHandle h(i);
      m_.set_vertex_handle(h, verts_[m_.to_vertex_handle(h)]);
      m_.set_next_halfedge_handle(h, moved(m_.next_halfedge_handle(h)));
      if (const auto p = m_.face_handle(h); p.is_valid()) m_.set_face_handle(h, polys_[p]);
    }
    for (int i = 0; i < polys_.size(); ++i) {
      const OpenMesh::FaceHandle p(i);
      m_.set_halfedge_handle(p, moved(m_.halfedge_handle(p)));
    }
  }

 public:
  explicit openmesh_compaction(mesh& m)
      : m_(m), verts_(openmesh_links::verts(m), openmesh_links::vert_index_bound(m)),
        edges_(openmesh_links::edges(m), openmesh_links::edge_index_bound(m)),
        polys_(openmesh_links::polys(m), openmesh_links::poly_index_bound(m)) {}

  void make() noexcept {
    move_elements();
    renumber_links();
    m_.resize(verts_.origins.size(), edges_.origins.size(), polys_.origins.size());
  }
  /// After make().
  correspondence origins() noexcept {
    return {element_origins(std::move(verts_.origins)),
            element_origins(std::move(edges_.origins)),
            {},
            element_origins(std::move(polys_.origins))};
  }
};

}  // namespace concino::detail

// Builds polyhedra one at a time: checks their faces, turns them outward, and merges equal faces.
#pragma once

#include <concino/io/detail/cells/cell_lists.hpp>
#include <concino/io/detail/cells/orient.hpp>
#include <concino/mesh/support/face_merger.hpp>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// The faces of one polyhedron at a time, from a list: the number of faces, and for each the number of its verts and
/// these.
template<class Vert>
class face_list_decoder {
  std::vector<std::uint32_t> offsets_;
  std::vector<Vert> verts_;
  std::vector<std::uint8_t> outward_;

 public:
  /// All faces are outward.
  oriented_faces operator()(const Vert* list) {
    offsets_.assign(1, 0);
    verts_.clear();
    outward_.assign(list->raw(), 1);
    const Vert* v = list + 1;
    for (std::uint32_t left = list->raw(); left > 0; --left) {
      const std::uint32_t n = v++->raw();
      verts_.insert(verts_.end(), v, v + n);
      offsets_.push_back(static_cast<std::uint32_t>(verts_.size()));
      v += n;
    }
    return {offsets_.data(), verts_.data(), outward_.data(), list->raw()};
  }
};

/// Collects polyhedra. Those that are not oriented outward are changed; equal faces become one.
template<class Vert>
class polyhedra_builder {
  basic_face_merger<Vert> merger_;
  faces_check<Vert> check_;
  face_list_decoder<Vert> decode_;
  poly_orienter<Vert> orient_;
  polyhedra_arrays out_;
  std::size_t num_turned_ = 0;

  void push(const Vert* v, std::size_t n, bool is_outward) {
    const auto [face, order] = merger_.add(v, n);
    out_.poly_faces.push_back(face);
    out_.outward.push_back((order > 0) == is_outward);
  }
  void end_poly() { out_.poly_offsets.push_back(static_cast<std::uint32_t>(out_.poly_faces.size())); }

 public:
  /// Needs: the points of all verts, which do not move as long as this exists.
  explicit polyhedra_builder(std::span<const vec3> points) : merger_(points.size()), orient_(points) {
    out_.poly_offsets.push_back(0);
  }

  /// The polys that were not oriented outward.
  std::size_t num_turned() const { return num_turned_; }

  /// Adds a cell of positive volume, or of none.
  void add_cell(cell_shape s, const Vert* v) {
    const standard_cell& t = standard_cell_of(s);
    for (unsigned f = 0; f < t.num_faces; ++f) {
      Vert face[4];
      for (unsigned i = 0; i < t.face_size[f]; ++i) face[i] = v[t.face_vert[f][i]];
      push(face, t.face_size[f], true);
    }
    end_poly();
  }

  /// Says more about the last fault, or the last polyhedron.
  const faces_check<Vert>& checked() const { return check_; }

  /// Checks the list of a polyhedron, and adds it if it has no fault. Result: its first fault.
  /// Needs: verts that have points.
  face_fault add(const Vert* list) {
    if (const face_fault fault = check_(list); fault != face_fault::none) return fault;
    const oriented_faces listed = decode_(list);
    num_turned_ += orient_(listed);
    for (std::uint32_t k = 0; k < listed.size; ++k)
      push(listed.verts + listed.offsets[k], listed.offsets[k + 1] - listed.offsets[k], listed.outward[k]);
    end_poly();
    return face_fault::none;
  }

  /// Moves the points and the polyhedra into the arrays of a mesh.
  polyhedra_arrays finish(std::vector<vec3>&& points) {
    out_.poly_faces.shrink_to_fit();
    out_.outward.shrink_to_fit();
    out_.poly_offsets.shrink_to_fit();
    merger_.finish(out_);
    out_.points = std::move(points);
    return std::move(out_);
  }
};

}  // namespace concino::detail

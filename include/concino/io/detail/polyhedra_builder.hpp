// Builds polyhedra one at a time: checks their faces, turns them outward, and merges equal faces.
#pragma once

#include <concino/io/detail/cell_lists.hpp>
#include <concino/io/detail/orient.hpp>
#include <concino/io/detail/regular_poly_check.hpp>
#include <concino/mesh/face_merger.hpp>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// The faces of one polyhedron at a time, from a list: the number of faces, and for each the number of its verts and these.
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
  regular_poly_check<Vert> is_regular_;
  faces_check<Vert> check_;
  face_list_decoder<Vert> decode_;
  poly_orienter<Vert> orient_;
  polyhedra_arrays out_;
  std::size_t num_faces_ = 0;  // of all polys; a face of two polys twice
  std::size_t num_turned_ = 0;

  void begin_poly(std::size_t num_faces) {
    core::make_room(out_.poly_faces, num_faces_ + num_faces);
    core::make_room(out_.outward, num_faces_ + num_faces);
  }
  void push(typename basic_face_merger<Vert>::place x, bool is_outward) {
    out_.poly_faces[num_faces_] = x.face;
    out_.outward[num_faces_++] = (x.order > 0) == is_outward;
  }
  void end_poly() { out_.poly_offsets.push_back(static_cast<std::uint32_t>(num_faces_)); }

  /// Adds a polyhedron that may not be oriented outward.
  [[gnu::noinline, gnu::cold]] void add_unoriented(const Vert* list) {
    const oriented_faces listed = decode_(list);
    num_turned_ += orient_(listed);
    for (std::uint32_t k = 0; k < listed.size; ++k)
      push(merger_.add(listed.verts + listed.offsets[k], listed.offsets[k + 1] - listed.offsets[k]), listed.outward[k]);
  }

 public:
  /// Needs: the points of all verts, which do not move as long as this exists.
  explicit polyhedra_builder(std::span<const vec3> points) : merger_(points.size()), is_regular_(points), orient_(points) {
    out_.poly_offsets.push_back(0);
  }

  /// The polys that were not oriented outward.
  std::size_t num_turned() const { return num_turned_; }

  /// Makes room for so many times the polys that there are, which have as many faces and corners as these.
  void reserve_times(double factor) {
    const auto times = [&](std::size_t n, double share) { return static_cast<std::size_t>(static_cast<double>(n) * factor * share) + 1; };
    core::reserve_large(out_.poly_offsets, times(out_.num_polys(), 1.01));
    core::reserve_large(out_.poly_faces, times(num_faces_, 1.01));
    core::reserve_large(out_.outward, times(num_faces_, 1.01));
    const double share = 0.53 * static_cast<double>(num_faces_) / static_cast<double>(merger_.num_faces());  // few are at the boundary
    merger_.reserve(times(merger_.num_faces(), share), times(merger_.num_corners(), share));
  }

  /// Adds a cell of positive volume, or of none.
  void add_cell(cell_shape s, const Vert* v) {
    const standard_cell& t = standard_cell_of(s);
    begin_poly(t.num_faces);
    for (unsigned f = 0; f < t.num_faces; ++f) {
      Vert face[4];
      for (unsigned i = 0; i < t.face_size[f]; ++i) face[i] = v[t.face_vert[f][i]];
      push(merger_.add(face, t.face_size[f]), true);
    }
    end_poly();
  }

  /// Says more about the last fault.
  const faces_check<Vert>& checked() const { return check_; }

  /// Checks the list of a polyhedron, which has so many numbers, and adds it if it has no fault. Result: its first fault.
  /// Needs: verts that have points.
  face_fault add(const Vert* list, std::size_t) {
    const bool is_regular = is_regular_(list);
    if (!is_regular)
      if (const face_fault fault = check_(list); fault != face_fault::none) return fault;
    begin_poly(list->raw());
    if (is_regular)
      for (const auto& f : is_regular_.faces()) push(merger_.add(f.verts, f.size, f.smallest, f.sum), true);
    else add_unoriented(list);
    end_poly();
    return face_fault::none;
  }

  /// Moves the points and the polyhedra into the arrays of a mesh.
  polyhedra_arrays finish(std::vector<vec3>&& points) {
    core::trim(out_.poly_faces, num_faces_);
    core::trim(out_.outward, num_faces_);
    merger_.finish(out_);
    out_.points = std::move(points);
    return std::move(out_);
  }
};

}  // namespace concino::detail

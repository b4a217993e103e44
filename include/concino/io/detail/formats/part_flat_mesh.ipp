// Bodies of part_flat_mesh.hpp: a part of a mesh as a flat_mesh.
#pragma once

#include <concino/io/detail/formats/part_flat_mesh.hpp>

#include <algorithm>

namespace concino::detail {

/// The position of a number in a sorted list that has it.
inline std::uint32_t position_in_sorted(const std::vector<std::uint32_t>& sorted, std::uint32_t x) {
  return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), x) - sorted.begin());
}

/// Sorts numbers, and keeps each once.
inline void sort_once(std::vector<std::uint32_t>& all) {
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

CONCINO_INLINE vert_id part_flat_mesh::number_of(vert_id v) const {
  return vert_id{position_in_sorted(verts_, v.raw())};
}

CONCINO_INLINE void part_flat_mesh::collect_verts(std::span<const std::uint32_t> more) {
  verts_.assign(more.begin(), more.end());
  const bool has_lists = whole_.poly_verts.size() > 0;
  for (const std::uint32_t p : polys_) {
    if (has_lists) {
      for (const vert_id v : whole_.poly_verts[p]) verts_.push_back(v.raw());
      continue;
    }
    for (const face_id f : whole_.polyhedra().poly_faces[p])
      for (const vert_id v : whole_.polyhedra().face_verts[f.raw()]) verts_.push_back(v.raw());
  }
  sort_once(verts_);
  for (const std::uint32_t v : verts_) {
    own_points_.push_back(whole_.points[v]);
    vert_indices_.push_back(static_cast<std::uint32_t>(whole_.vert_index(v)));
  }
}

CONCINO_INLINE part_flat_mesh::part_flat_mesh(flat_mesh& whole, std::span<const std::uint32_t> polys,
                                              std::span<const std::uint32_t> more, const property_set& all_properties)
    : whole_(whole), polys_(polys) {
  dimension = whole.dimension;
  arity = whole.arity;
  num_polys = polys.size();
  properties = &all_properties;
  collect_verts(more);
  if (arity == 0) offsets_.push_back(0);
  for (const std::uint32_t p : polys) {
    poly_indices_.push_back(static_cast<std::uint32_t>(whole.poly_index(p)));
    if (whole.poly_verts.size() == 0) continue;
    for (const vert_id v : whole.poly_verts[p]) poly_verts_.push_back(number_of(v));
    if (arity == 0) offsets_.push_back(poly_verts_.size());
  }
  points = own_points_;
  vert_indices = vert_indices_;
  poly_indices = poly_indices_;
  poly_verts = {poly_verts_, offsets_, arity};
}

CONCINO_INLINE void part_flat_mesh::make_polyhedra() {
  const flat_polyhedra& all = whole_.polyhedra();
  std::vector<std::uint32_t> faces;
  for (const std::uint32_t p : polys_)
    for (const face_id f : all.poly_faces[p]) faces.push_back(f.raw());
  sort_once(faces);
  face_offsets_.push_back(0);
  for (const std::uint32_t f : faces) {
    for (const vert_id v : all.face_verts[f]) face_verts_.push_back(number_of(v));
    face_offsets_.push_back(face_verts_.size());
    face_indices_.push_back(whole_.face_indices.empty() ? f : whole_.face_indices[f]);
  }
  face_indices = face_indices_;
  poly_face_offsets_.push_back(0);
  for (const std::uint32_t p : polys_) {
    const std::span<const face_id> of_poly = all.poly_faces[p];
    const auto first = static_cast<std::size_t>(of_poly.data() - all.poly_faces.values.data());
    for (std::size_t i = 0; i < of_poly.size(); ++i) {
      poly_faces_.push_back(face_id{position_in_sorted(faces, of_poly[i].raw())});
      outward_.push_back(all.outward[first + i]);
    }
    poly_face_offsets_.push_back(poly_faces_.size());
  }
  polyhedra_ = {{face_verts_, face_offsets_, 0}, {poly_faces_, poly_face_offsets_, 0}, outward_};
}

}  // namespace concino::detail

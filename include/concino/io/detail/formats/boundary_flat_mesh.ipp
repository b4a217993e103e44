// Bodies of boundary_flat_mesh.hpp: the boundary of a volume as a flat_mesh.
#pragma once

#include <concino/core/message.hpp>
#include <concino/io/detail/formats/boundary_flat_mesh.hpp>

#include <algorithm>
#include <span>

namespace concino::detail {

CONCINO_INLINE boundary_flat_mesh::boundary_flat_mesh(flat_mesh& volume) : volume_(volume) {
  const flat_polyhedra& all = volume.polyhedra();
  struct use {
    std::uint32_t count = 0;
    bool outward = true;
  };
  std::vector<use> uses(all.face_verts.size());
  for (std::size_t i = 0; i < all.poly_faces.values.size(); ++i) {
    use& u = uses[all.poly_faces.values[i].raw()];
    ++u.count;
    u.outward = all.outward[i] != 0;
  }
  numbers_.assign(volume.points.size(), ~0u);
  offsets_.push_back(0);
  for (std::size_t f = 0; f < uses.size(); ++f) {
    if (uses[f].count != 1) continue;
    for (const vert_id v : all.face_verts[f]) {
      numbers_[v.raw()] = 0;  // a number follows
      poly_verts_.push_back(v);
    }
    if (!uses[f].outward)
      std::reverse(poly_verts_.begin() + static_cast<std::ptrdiff_t>(offsets_.back()), poly_verts_.end());
    offsets_.push_back(poly_verts_.size());
    poly_indices_.push_back(static_cast<std::uint32_t>(volume.face_indices.empty() ? f : volume.face_indices[f]));
  }
  for (std::size_t v = 0; v < numbers_.size(); ++v) {
    if (numbers_[v] == ~0u) continue;
    numbers_[v] = static_cast<std::uint32_t>(own_points_.size());
    own_points_.push_back(volume.points[v]);
    vert_indices_.push_back(static_cast<std::uint32_t>(volume.vert_index(v)));
  }
  for (vert_id& v : poly_verts_) v = vert_id{numbers_[v.raw()]};
  arity = volume.arity == 4 ? 3 : volume.arity == 8 ? 4 : 0;
  num_polys = poly_indices_.size();
  points = own_points_;
  vert_indices = vert_indices_;
  poly_indices = poly_indices_;
  if (arity) offsets_.clear();
  poly_verts = {poly_verts_, offsets_, arity};
  if (volume.properties) copy_properties();
}

CONCINO_INLINE void boundary_flat_mesh::copy_properties() {
  const property_set& all = *volume_.properties;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const property_info p = all.info(i);
    if (p.kind == element_kind::poly || p.kind == element_kind::corner) continue;
    const column& values = *all.values(i);
    column copies(values);
    own_properties_
        .get(p.kind == element_kind::face ? element_kind::poly : p.kind, p.name, values.operations(), values.size())
        ->swap_values(copies);
  }
  properties = &own_properties_;
}

CONCINO_INLINE void boundary_flat_mesh::make_edges() {
  using ends = std::array<std::uint32_t, 2>;
  const auto sorted = [](vert_id a, vert_id b) { return ends{std::min(a.raw(), b.raw()), std::max(a.raw(), b.raw())}; };
  std::vector<ends> of_polys;
  for (std::size_t p = 0; p < num_polys; ++p) {
    const std::span<const vert_id> v = poly_verts[p];
    for (std::size_t k = 0; k < v.size(); ++k) of_polys.push_back(sorted(v[k], v[k + 1 == v.size() ? 0 : k + 1]));
  }
  std::sort(of_polys.begin(), of_polys.end());
  const std::vector<flat_property> list = volume_.edge_property_list();
  const std::uint32_t* const indices = list.empty() ? nullptr : list.front().indices;
  const std::span<const std::array<vert_id, 2>> edges_of_volume = volume_.edge_verts();
  for (std::uint32_t e = 0; e < edges_of_volume.size(); ++e) {
    const std::uint32_t a = numbers_[edges_of_volume[e][0].raw()], b = numbers_[edges_of_volume[e][1].raw()];
    if (a == ~0u || b == ~0u) continue;
    if (!std::binary_search(of_polys.begin(), of_polys.end(), sorted(vert_id{a}, vert_id{b}))) continue;
    edge_verts_.push_back({vert_id{a}, vert_id{b}});
    edge_indices_.push_back(indices ? indices[e] : e);
  }
}

CONCINO_INLINE void boundary_flat_mesh::report_lost(save_report& report) const {
  const auto lost = [&](std::size_t n, core::message what) {
    if (n) report.lost.push_back(core::joined({n, core::joined(what)}));
  };
  lost(volume_.num_polys, {" polys: the boundary surface of ", num_polys, " polys was saved instead"});
  lost(volume_.points.size() - points.size(), {" verts that are not on the boundary"});
  for (std::size_t i = 0; volume_.properties && i < volume_.properties->size(); ++i)
    if (const property_info p = volume_.properties->info(i); p.kind == element_kind::poly)
      report.lost.push_back(
          core::joined({to_string(p.kind), " property \"", p.name, "\": the polys of the boundary are faces"}));
}

}  // namespace concino::detail

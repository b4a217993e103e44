// Bodies of mend_repeated_verts.hpp: what load_options::repeated_verts does to the contents of a file, after any format
// was read.
#pragma once

#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/io/detail/formats/mend_repeated_verts.hpp>

#include <algorithm>
#include <cstring>
#include <utility>

namespace concino::detail {

/// The values of a column at some positions.
CONCINO_INLINE std::shared_ptr<column> picked(const column& from, const std::vector<std::uint32_t>& origin) {
  const value_type& type = from.operations();
  const std::shared_ptr<column> to = make_column(type, origin.size());
  auto* value = static_cast<unsigned char*>(to->data());
  const auto* const values = static_cast<const unsigned char*>(from.data());
  for (const std::uint32_t i : origin) {
    if (i < from.size()) {
      if (type.copy) replace_value(type, value, values + i * type.size);
      else std::memcpy(value, values + i * type.size, type.size);
    }
    value += type.size;
  }
  return to;
}

/// Gives the polys of the mesh the values of polys of the file: the i-th those of origin[i]. The same for corners.
CONCINO_INLINE void renumber_polys(file_contents& c, std::size_t num_in_file, const std::vector<std::uint32_t>& origin,
                                   const std::vector<std::uint32_t>& corner_origin) {
  if (!c.poly_labels.empty()) {
    std::vector<int> labels;
    for (const std::uint32_t p : origin) labels.push_back(p < c.poly_labels.size() ? c.poly_labels[p] : 0);
    c.poly_labels = std::move(labels);
  }
  if (!c.poly_colors.empty()) {
    std::vector<rgba> colors;
    for (const std::uint32_t p : origin) colors.push_back(p < c.poly_colors.size() ? c.poly_colors[p] : rgba());
    c.poly_colors.resize(colors.size());
    for (std::size_t i = 0; i < colors.size(); ++i) c.poly_colors[i] = colors[i];
  }
  std::vector<std::uint32_t> first(num_in_file + 1, static_cast<std::uint32_t>(origin.size()));
  for (std::size_t i = origin.size(); i-- > 0;) first[origin[i]] = static_cast<std::uint32_t>(i);
  for (std::size_t p = num_in_file; p-- > 0;) first[p] = std::min(first[p], first[p + 1]);
  for (name_runs* const names : {&c.objects, &c.groups, &c.materials}) {
    names->renumber([&](std::size_t p) { return std::size_t{first[std::min(p, num_in_file)]}; });
    names->end(origin.size());
  }
  for (property_column& x : c.properties) {
    if (!x.values) continue;
    if (x.kind == element_kind::poly) x.values = picked(*x.values, origin);
    if (x.kind == element_kind::corner) x.values = picked(*x.values, corner_origin);
  }
}

/// Mends the polys of a surface.
CONCINO_INLINE void mend_surface(file_contents& contents) {
  surface_arrays& s = contents.surface;
  polys_with_repeats& repeated = contents.repeated;
  surface_arrays out;
  std::vector<std::uint32_t> origin, corner_origin;
  std::vector<std::uint64_t> scratch;
  cycle_collapser collapse;
  out.offsets.push_back(0);
  bool any = false;
  const bool is_counted = !repeated.empty();
  const auto end_poly = [&](std::size_t p) {
    out.offsets.push_back(static_cast<std::uint32_t>(out.verts.size()));
    origin.push_back(static_cast<std::uint32_t>(p));
  };
  const auto push = [&](vert_id v, std::size_t corner) {
    out.verts.push_back(v);
    corner_origin.push_back(static_cast<std::uint32_t>(corner));
  };
  for (std::size_t p = 0; p < s.num_polys(); ++p) {
    const std::size_t first = s.arity ? p * s.arity : s.offsets[p],
                      n = (s.arity ? first + s.arity : s.offsets[p + 1]) - first;
    const vert_id* const v = s.verts.data() + first;
    // else the mesh refuses it
    const bool in_range = std::all_of(v, v + n, [&](vert_id x) { return x.raw() < s.points.size(); });
    if (!in_range || first_repeated(v, n, scratch) == n) {
      for (std::size_t i = 0; i < n; ++i) push(v[i], first + i);
      end_poly(p);
      continue;
    }
    any = true;
    if (!is_counted) repeated.add(p, [] { return std::string(); });
    if (repeated.policy == concino::repeated_verts::skip) continue;
    const std::span<const std::uint32_t> kept = collapse(v, n);
    std::vector<vert_id> cycle;
    for (const std::uint32_t i : kept) cycle.push_back(v[i]);
    if (kept.size() < 3) {
      repeated.add_vanished();
    } else if (first_repeated(cycle.data(), cycle.size(), scratch) == cycle.size()) {
      for (const std::uint32_t i : kept) push(v[i], first + i);
      end_poly(p);
    } else {
      ++repeated.num_cut;
      std::vector<vec3> corners;
      for (const vert_id x : cycle) corners.push_back(s.points[x.raw()]);
      polygon_triangulator triangulate;
      for (const polygon_triangle& t : triangulate(corners)) {
        if (cycle[t[0]] == cycle[t[1]] || cycle[t[1]] == cycle[t[2]] || cycle[t[2]] == cycle[t[0]]) continue;
        for (const std::uint32_t i : t) push(cycle[i], first + kept[i]);
        end_poly(p);
      }
    }
  }
  if (!any) return;
  renumber_polys(contents, s.num_polys(), origin, corner_origin);
  out.points = std::move(s.points);
  s = std::move(out);
}

CONCINO_INLINE void mend_repeated_verts(file_contents& contents, std::size_t num_polys_of_volume, load_report& report) {
  if (contents.filled == arrays_kind::surface) {
    mend_surface(contents);
  } else if (const std::vector<std::uint32_t>& dropped = contents.repeated.dropped; !dropped.empty()) {
    std::vector<std::uint32_t> origin;
    const std::size_t n = num_polys_of_volume + dropped.size();
    for (std::uint32_t p = 0; p < n; ++p)
      if (!std::binary_search(dropped.begin(), dropped.end(), p)) origin.push_back(p);
    renumber_polys(contents, n, origin, {});
  }
  contents.repeated.report(report);
}

}  // namespace concino::detail

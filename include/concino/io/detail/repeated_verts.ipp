// Definitions of repeated_verts.hpp.
#pragma once

#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/io/detail/repeated_verts.hpp>
#include <concino/io/file_contents.hpp>

#include <algorithm>
#include <cstring>
#include <utility>

namespace concino::detail {

[[gnu::cold]] CONCINO_INLINE std::span<const std::uint32_t> cycle_collapser::operator()(const vert_id* v, std::size_t n) {
  kept_.clear();
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::size_t size = kept_.size();
    if (size > 0 && v[kept_[size - 1]] == v[i]) continue;
    if (size > 1 && v[kept_[size - 2]] == v[i]) kept_.pop_back();
    else kept_.push_back(i);
  }
  std::size_t begin = 0;
  for (;;) {  // the last corner and the first one are neighbours
    const std::size_t size = kept_.size() - begin;
    if (size < 2) break;
    const auto vert = [&](std::size_t i) { return v[kept_[begin + i]]; };
    if (vert(0) == vert(size - 1) || (size > 2 && vert(0) == vert(size - 2))) kept_.pop_back();
    else if (size > 2 && vert(1) == vert(size - 1)) ++begin;
    else break;
  }
  return std::span<const std::uint32_t>(kept_).subspan(begin);
}

[[gnu::cold]] CONCINO_INLINE std::uint32_t collapse_verts(vert_id* v, std::uint32_t n) {
  cycle_collapser collapse;
  const std::span<const std::uint32_t> kept = collapse(v, n);
  if (kept.size() < 3) return n;
  for (std::size_t i = 0; i < kept.size(); ++i) v[i] = v[kept[i]];
  return static_cast<std::uint32_t>(kept.size());
}

[[gnu::cold]] CONCINO_INLINE std::size_t repeated_polys::size_after(const vert_id* v, std::size_t n) {
  if (policy == concino::repeated_verts::skip) return 0;
  std::vector<vert_id> left;
  std::vector<std::uint64_t> scratch;
  for (const std::uint32_t i : collapse_(v, n)) left.push_back(v[i]);
  if (left.size() < 3) return 0;
  return first_repeated(left.data(), left.size(), scratch) == left.size() ? left.size() : 3;
}

[[gnu::cold]] CONCINO_INLINE void repeated_polys::report(load_report& r) const {
  if (num_ == 0) return;
  if (policy == concino::repeated_verts::skip) {
    r.skipped.push_back(core::joined({num_, " polys with a vert twice, the first is ", first_}));
    return;
  }
  r.notes.push_back(core::joined({num_, " polys with a vert twice were collapsed, the first is ", first_}));
  if (num_cut) r.notes.push_back(core::joined({num_cut, " polygons that pass a vert twice were cut into triangles"}));
  if (num_vanished_) r.skipped.push_back(core::joined({num_vanished_, " polys with a vert twice that have no area or volume left"}));
}

[[gnu::cold]] CONCINO_INLINE std::vector<vert_id> cut_cycle(std::vector<vert_id> cycle, std::span<const vec3> points) {
  const std::vector<vert_id> given = cycle;
  std::vector<vert_id> best;
  bool is_reversed = false;
  for (const bool reversed : {false, true}) {
    for (std::size_t k = 0; k < cycle.size(); ++k) {
      std::rotate(cycle.begin(), cycle.begin() + 1, cycle.end());
      if (!best.empty() && !std::lexicographical_compare(cycle.begin(), cycle.end(), best.begin(), best.end())) continue;
      best = cycle;
      is_reversed = reversed;
    }
    std::reverse(cycle.begin(), cycle.end());
  }
  std::vector<vec3> corners;
  for (const vert_id v : best) corners.push_back(points[v.raw()]);
  std::vector<vert_id> triangles;
  polygon_triangulator triangulate;
  for (const polygon_triangle& t : triangulate(corners)) {
    const vert_id a = best[t[0]], b = best[t[is_reversed ? 2 : 1]], c = best[t[is_reversed ? 1 : 2]];
    if (a != b && b != c && c != a) triangles.insert(triangles.end(), {a, b, c});
  }
  return triangles;
}

[[gnu::cold]] CONCINO_INLINE bool has_repeated_vert(const vert_id* list, std::vector<std::uint64_t>& scratch) {
  for (std::uint32_t left = list++->raw(); left > 0; --left) {
    const std::uint32_t n = list++->raw();
    if (first_repeated(list, n, scratch) != n) return true;
    list += n;
  }
  return false;
}

[[gnu::cold]] CONCINO_INLINE std::vector<vert_id> collapsed_faces(const vert_id* list, std::span<const vec3> points) {
  std::vector<std::vector<vert_id>> faces, sorted;
  std::vector<std::uint64_t> scratch;
  cycle_collapser collapse;
  const auto add = [&](std::vector<vert_id> face) {
    std::vector<vert_id> verts = face;
    std::sort(verts.begin(), verts.end());
    const auto same = std::find(sorted.begin(), sorted.end(), verts);
    if (same == sorted.end()) {
      sorted.push_back(std::move(verts));
      faces.push_back(std::move(face));
    } else {  // nothing is left between the two
      faces.erase(faces.begin() + (same - sorted.begin()));
      sorted.erase(same);
    }
  };
  for (std::uint32_t left = list++->raw(); left > 0; --left) {
    const std::uint32_t n = list++->raw();
    std::vector<vert_id> face;
    for (const std::uint32_t i : collapse(list, n)) face.push_back(list[i]);
    list += n;
    if (face.size() < 3) continue;
    if (first_repeated(face.data(), face.size(), scratch) == face.size()) {
      add(std::move(face));
      continue;
    }
    const std::vector<vert_id> triangles = cut_cycle(std::move(face), points);
    for (std::size_t i = 0; i < triangles.size(); i += 3) add({triangles[i], triangles[i + 1], triangles[i + 2]});
  }
  std::vector<vert_id> result{vert_id{std::size_t{0}}};
  if (faces.size() < 4) return result;
  result[0] = vert_id{faces.size()};
  for (const std::vector<vert_id>& f : faces) {
    result.push_back(vert_id{f.size()});
    result.insert(result.end(), f.begin(), f.end());
  }
  return result;
}

/// The values of a column at some positions.
[[gnu::cold]] CONCINO_INLINE std::shared_ptr<column> picked(const column& from, const std::vector<std::uint32_t>& origin) {
  const value_type& type = from.operations();
  const std::shared_ptr<column> to = make_column(type, origin.size());
  auto* value = static_cast<unsigned char*>(to->data());
  const auto* const values = static_cast<const unsigned char*>(from.data());
  for (const std::uint32_t i : origin) {
    if (i < from.size()) {
      if (type.copy) type.destroy(value), type.copy(value, values + i * type.size);
      else std::memcpy(value, values + i * type.size, type.size);
    }
    value += type.size;
  }
  return to;
}

/// Gives the polys of the mesh the values of polys of the file: the i-th those of origin[i]. The same for corners.
[[gnu::cold]] CONCINO_INLINE void renumber_polys(file_contents& c, std::size_t num_in_file, const std::vector<std::uint32_t>& origin,
                                                 const std::vector<std::uint32_t>& corner_origin) {
  if (!c.poly_labels.empty()) {
    std::vector<int> labels;
    for (const std::uint32_t p : origin) labels.push_back(p < c.poly_labels.size() ? c.poly_labels[p] : 0);
    c.poly_labels = std::move(labels);
  }
  if (!c.poly_colors.empty()) {
    element_values<rgba> colors;
    for (const std::uint32_t p : origin) colors.push_back(p < c.poly_colors.size() ? c.poly_colors[p] : rgba());
    c.poly_colors = std::move(colors);
  }
  std::vector<std::uint32_t> first(num_in_file + 1, static_cast<std::uint32_t>(origin.size()));
  for (std::size_t i = origin.size(); i-- > 0;) first[origin[i]] = static_cast<std::uint32_t>(i);
  for (std::size_t p = num_in_file; p-- > 0;) first[p] = std::min(first[p], first[p + 1]);
  for (name_runs* const names : {&c.objects, &c.groups, &c.materials}) {
    names->renumber([&](std::size_t p) { return std::size_t{first[std::min(p, num_in_file)]}; });
    names->end(origin.size());
  }
  for (property_column& x : c.properties)
    if (x.values && (x.kind == element_kind::poly || x.kind == element_kind::corner)) x.values = picked(*x.values, x.kind == element_kind::poly ? origin : corner_origin);
}

/// Mends the polys of a surface.
[[gnu::cold]] CONCINO_INLINE void mend_surface(file_contents& contents) {
  surface_arrays& s = contents.surface;
  repeated_polys& repeated = contents.repeated;
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
    const std::size_t first = s.arity ? p * s.arity : s.offsets[p], n = (s.arity ? first + s.arity : s.offsets[p + 1]) - first;
    const vert_id* const v = s.verts.data() + first;
    const bool in_range = std::all_of(v, v + n, [&](vert_id x) { return x.raw() < s.points.size(); });  // else the mesh refuses it
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

[[gnu::cold]] CONCINO_INLINE void mend_repeated_verts(file_contents& contents, std::size_t num_polys_of_volume, load_report& report) {
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

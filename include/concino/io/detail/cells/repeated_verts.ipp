// Bodies of repeated_verts.hpp: polys with a vert twice: what load_options::repeated_verts makes of them.
#pragma once

#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/io/detail/cells/repeated_verts.hpp>

#include <algorithm>
#include <utility>

namespace concino::detail {

CONCINO_INLINE std::span<const std::uint32_t> cycle_collapser::operator()(const vert_id* v, std::size_t n) {
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

CONCINO_INLINE std::uint32_t collapse_verts(vert_id* v, std::uint32_t n) {
  cycle_collapser collapse;
  const std::span<const std::uint32_t> kept = collapse(v, n);
  if (kept.size() < 3) return n;
  for (std::size_t i = 0; i < kept.size(); ++i) v[i] = v[kept[i]];
  return static_cast<std::uint32_t>(kept.size());
}

CONCINO_INLINE std::size_t polys_with_repeats::size_after(const vert_id* v, std::size_t n) {
  if (policy == concino::repeated_verts::skip) return 0;
  std::vector<vert_id> left;
  std::vector<std::uint64_t> scratch;
  for (const std::uint32_t i : collapse_(v, n)) left.push_back(v[i]);
  if (left.size() < 3) return 0;
  return first_repeated(left.data(), left.size(), scratch) == left.size() ? left.size() : 3;
}

CONCINO_INLINE void polys_with_repeats::report(load_report& r) const {
  if (num_ == 0) return;
  if (policy == concino::repeated_verts::skip) {
    r.skipped.push_back(core::joined({num_, " polys with a vert twice, the first is ", first_}));
    return;
  }
  r.notes.push_back(core::joined({num_, " polys with a vert twice were collapsed, the first is ", first_}));
  if (num_cut) r.notes.push_back(core::joined({num_cut, " polygons that pass a vert twice were cut into triangles"}));
  if (num_vanished_)
    r.skipped.push_back(core::joined({num_vanished_, " polys with a vert twice that have no area or volume left"}));
}

CONCINO_INLINE std::vector<vert_id> cut_cycle(std::vector<vert_id> cycle, std::span<const vec3> points) {
  const std::vector<vert_id> given = cycle;
  std::vector<vert_id> best;
  bool is_reversed = false;
  for (const bool reversed : {false, true}) {
    for (std::size_t k = 0; k < cycle.size(); ++k) {
      std::rotate(cycle.begin(), cycle.begin() + 1, cycle.end());
      if (!best.empty() && !std::lexicographical_compare(cycle.begin(), cycle.end(), best.begin(), best.end()))
        continue;
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

CONCINO_INLINE bool has_repeated_vert(const vert_id* list, std::vector<std::uint64_t>& scratch) {
  for (std::uint32_t left = list++->raw(); left > 0; --left) {
    const std::uint32_t n = list++->raw();
    if (first_repeated(list, n, scratch) != n) return true;
    list += n;
  }
  return false;
}

CONCINO_INLINE std::vector<vert_id> collapsed_faces(const vert_id* list, std::span<const vec3> points) {
  std::vector<std::vector<vert_id>> kept, sorted;
  std::vector<std::uint64_t> scratch;
  cycle_collapser collapse;
  const auto add = [&](std::vector<vert_id> face) {
    std::vector<vert_id> ids = face;
    std::sort(ids.begin(), ids.end());
    const auto same = std::find(sorted.begin(), sorted.end(), ids);
    if (same == sorted.end()) {
      sorted.push_back(std::move(ids));
      kept.push_back(std::move(face));
    } else {  // nothing is left between the two
      kept.erase(kept.begin() + (same - sorted.begin()));
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
  if (kept.size() < 4) return result;
  result[0] = vert_id{kept.size()};
  for (const std::vector<vert_id>& f : kept) {
    result.push_back(vert_id{f.size()});
    result.insert(result.end(), f.begin(), f.end());
  }
  return result;
}

}  // namespace concino::detail

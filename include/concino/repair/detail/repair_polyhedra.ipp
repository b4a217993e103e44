// Bodies of repair_polyhedra.hpp.
#pragma once

#include <concino/core/message.hpp>
#include <concino/mesh/support/face_merger.hpp>
#include <concino/mesh/support/standard_cells.hpp>
#include <concino/repair/detail/cell_windings.hpp>
#include <concino/repair/detail/polyhedron_shell.hpp>
#include <concino/repair/detail/repair_polyhedra.hpp>
#include <concino/repair/detail/surface_steps.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace concino::detail {

/// The faces of a volume as polygons of `lists`, and its cells as lists of these.
class polyhedra_mender {
  surface_lists faces_;  // of them, poly_origin is the number before
  cell_faces cells_;
  std::vector<std::uint32_t> origin_;  // by cell
  repair_log& log_;

  /// Keeps the cells that are not marked.
  void remove(const std::vector<std::uint8_t>& marked) {
    cell_faces kept;
    kept.num_faces = cells_.num_faces;
    std::vector<std::uint32_t> origin;
    for (std::size_t c = 0; c < cells_.num_cells(); ++c) {
      if (marked[c]) continue;
      for (std::uint32_t i = cells_.offsets[c]; i < cells_.offsets[c + 1]; ++i) {
        kept.faces.push_back(cells_.faces[i]);
        kept.outward.push_back(cells_.outward[i]);
      }
      kept.offsets.push_back(static_cast<std::uint32_t>(kept.faces.size()));
      origin.push_back(origin_[c]);
    }
    cells_ = std::move(kept);
    origin_ = std::move(origin);
  }

 public:
  polyhedra_mender(polyhedra_arrays a, repair_log& log) : log_(log) {
    surface_arrays faces{std::move(a.points), std::move(a.face_offsets), std::move(a.face_verts), 0};
    if (faces.offsets.empty()) faces.offsets.push_back(0);
    faces_ = lists_of(std::move(faces));
    if (!a.poly_offsets.empty()) cells_.offsets = std::move(a.poly_offsets);
    cells_.faces.reserve(a.poly_faces.size());
    for (const face_id f : a.poly_faces) cells_.faces.push_back(f.raw());
    cells_.outward = std::move(a.outward);
    origin_.resize(cells_.num_cells());
    std::iota(origin_.begin(), origin_.end(), 0u);
  }

  void merge_verts(double tolerance) { merge_verts_within(faces_, tolerance, log_); }

  /// Faces that pass a vert twice become the cycles in between, and equal faces become one if wished.
  void unite_faces(bool unites) {
    const std::size_t before = faces_.num_polys();
    repair_log unused({}, {});
    cut_at_repeated_verts(faces_, 0, unused);
    std::vector<std::uint32_t> first(before + 1);  // by face before: its first cycle
    for (const std::uint32_t f : faces_.poly_origin) ++first[f + 1];
    for (std::size_t f = 0; f < before; ++f) first[f + 1] += first[f];
    face_merger merger(faces_.points.size());
    polyhedra_arrays merged;  // of each cycle: the face that it became
    std::vector<vert_id> list;
    for (std::size_t k = 0; k < faces_.num_polys(); ++k) {
      list.clear();
      for (const std::uint32_t v : faces_.poly(k)) list.push_back(vert_id{v});
      const auto at = unites ? merger.add(list.data(), list.size()) : face_merger::merged_face{face_id{k}, 1};
      merged.poly_faces.push_back(at.face);
      merged.outward.push_back(at.order > 0);
    }
    if (unites) {
      const std::size_t cycles = faces_.num_polys();
      merger.finish(merged);
      if (merged.num_faces() < cycles) take_faces(merged);
    }
    take_cells(first, merged);
  }

 private:
  void take_faces(const polyhedra_arrays& merged) {
    surface_lists& s = faces_;
    std::vector<std::uint8_t> is_again(s.num_polys()), is_known(merged.num_faces());
    for (std::size_t k = 0; k < s.num_polys(); ++k) {
      is_again[k] = std::exchange(is_known[merged.poly_faces[k].raw()], std::uint8_t{1});
      if (is_again[k]) log_.add(repair_kind::united_faces, s.vert_origin[s.poly(k)[0]]);
    }
    s.remove(is_again);
  }

  /// A face that a cell has twice is there once if both have the same outside, else it has none.
  void take_cells(const std::vector<std::uint32_t>& first, const polyhedra_arrays& merged) {
    cell_faces cells;
    cells.num_faces = faces_.num_polys();
    std::vector<std::uint32_t> place(cells.num_faces, ~0u);
    std::vector<std::uint8_t> marked(cells_.num_cells());
    for (std::size_t c = 0; c < cells_.num_cells(); ++c) {
      const std::size_t begin = cells.faces.size();
      for (std::uint32_t i = cells_.offsets[c]; i < cells_.offsets[c + 1]; ++i)
        for (std::uint32_t k = first[cells_.faces[i]]; k < first[cells_.faces[i] + 1]; ++k) {
          const std::uint32_t f = merged.poly_faces[k].raw();
          const auto outward = static_cast<std::uint8_t>(cells_.outward[i] == merged.outward[k]);
          if (place[f] == ~0u) {
            place[f] = static_cast<std::uint32_t>(cells.faces.size());
            cells.faces.push_back(f);
            cells.outward.push_back(outward);
          } else if (cells.outward[place[f]] != outward && cells.faces[place[f]] == f) {
            cells.faces[place[f]] = ~0u;
          }
        }
      std::size_t end = begin;
      for (std::size_t i = begin; i < cells.faces.size(); ++i) {
        if (cells.faces[i] == ~0u) continue;
        cells.outward[end] = cells.outward[i];
        cells.faces[end++] = cells.faces[i];
      }
      const std::size_t old_size = cells_.offsets[c + 1] - cells_.offsets[c];
      for (std::uint32_t i = cells_.offsets[c]; i < cells_.offsets[c + 1]; ++i)
        for (std::uint32_t k = first[cells_.faces[i]]; k < first[cells_.faces[i] + 1]; ++k)
          place[merged.poly_faces[k].raw()] = ~0u;
      cells.faces.resize(end), cells.outward.resize(end);
      cells.offsets.push_back(static_cast<std::uint32_t>(end));
      marked[c] = end - begin < 4 && end - begin < old_size;
      if (marked[c]) log_.add(repair_kind::removed_degenerate, origin_[c]);
      else if (end - begin != old_size) log_.add(repair_kind::collapsed_corners, origin_[c]);
    }
    cells_ = std::move(cells);
    if (std::find(marked.begin(), marked.end(), std::uint8_t{1}) != marked.end()) remove(marked);
  }

 public:
  void remove_duplicates() {
    surface_lists cells;  // as lists of their verts
    std::vector<std::uint32_t> list;
    for (std::size_t c = 0; c < cells_.num_cells(); ++c) {
      list.clear();
      for (std::uint32_t i = cells_.offsets[c]; i < cells_.offsets[c + 1]; ++i)
        for (const std::uint32_t v : faces_.poly(cells_.faces[i])) list.push_back(v);
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      cells.add_poly(list, static_cast<std::uint32_t>(c));
    }
    cells.points.resize(faces_.points.size());
    std::vector<std::uint8_t> marked(cells_.num_cells(), 1);
    repair_log unused({}, {});
    remove_duplicate_polys(cells, unused);
    for (const std::uint32_t c : cells.poly_origin) marked[c] = 0;
    for (std::size_t c = 0; c < marked.size(); ++c)
      if (marked[c]) log_.add(repair_kind::removed_duplicates, origin_[c]);
    if (cells.num_polys() < marked.size()) remove(marked);
  }

  /// Turns faces of each cell so that they have one outside, and cells so that volumes are positive. Logs open cells.
  void turn(bool turns) {
    polyhedron_shell shell(faces_);
    std::vector<std::int8_t> sign;
    const std::vector<std::uint8_t> was = cells_.outward;
    for (std::size_t c = 0; c < cells_.num_cells(); ++c) {
      const std::uint32_t begin = cells_.offsets[c], n = cells_.offsets[c + 1] - begin;
      shell.read({cells_.faces.data() + begin, n}, {cells_.outward.data() + begin, n});
      if (turns) shell.orient();
      sign.push_back(shell.sign());
      if (!shell.is_closed()) log_open(c, shell.missing_loops());
    }
    if (!turns) return;
    const std::vector<std::uint32_t>& origin = origin_;
    const std::vector<std::uint8_t> turned = cells_to_turn(cells_, sign, origin, log_);
    log_.of(repair_kind::turned_polys).clear();
    for (std::size_t c = 0; c < cells_.num_cells(); ++c) {
      bool any = false;
      for (std::uint32_t i = cells_.offsets[c]; i < cells_.offsets[c + 1]; ++i) {
        cells_.outward[i] ^= turned[c];
        any = any || cells_.outward[i] != was[i];
      }
      if (any) log_.add(repair_kind::turned_polys, origin_[c]);
    }
  }

 private:
  void log_open(std::size_t c, const std::vector<std::vector<std::uint32_t>>& loops) {
    std::string what = core::joined({"poly ", log_.poly_index()[origin_[c]], " is open: no face has the "});
    for (std::size_t k = 0; k < loops.size(); ++k) {
      what += k == 0 ? "loop of verts" : ", nor the loop of verts";
      for (const std::uint32_t v : loops[k]) what += core::joined({' ', log_.vert_index()[faces_.vert_origin[v]]});
    }
    log_.add_single(repair_kind::open_cell, origin_[c], std::move(what));
  }

 public:
  repaired_arrays<polyhedra_arrays> finish(bool remove_unreferenced) {
    cells_.num_faces = faces_.num_polys();
    if (remove_unreferenced) remove_faces();
    repaired_arrays<surface_arrays> r = arrays_of_lists(std::move(faces_), 0, remove_unreferenced, log_);
    polyhedra_arrays a{std::move(r.arrays.points),
                       std::move(r.arrays.offsets),
                       std::move(r.arrays.verts),
                       std::move(cells_.offsets),
                       {},
                       std::move(cells_.outward)};
    for (const std::uint32_t f : cells_.faces) a.poly_faces.push_back(face_id{f});
    return {std::move(a), std::move(r.verts), element_origins(std::move(origin_)), std::move(r.cluster)};
  }

 private:
  void remove_faces() {
    std::vector<std::uint8_t> is_unused(faces_.num_polys(), 1);
    for (const std::uint32_t f : cells_.faces) is_unused[f] = 0;
    std::vector<std::uint32_t> number(is_unused.size());
    std::uint32_t n = 0;
    for (std::size_t f = 0; f < is_unused.size(); ++f) {
      number[f] = n;
      n += !is_unused[f];
      if (is_unused[f]) log_.add(repair_kind::removed_faces, faces_.vert_origin[faces_.poly(f)[0]]);
    }
    if (n == is_unused.size()) return;
    faces_.remove(is_unused);
    for (std::uint32_t& f : cells_.faces) f = number[f];
  }
};

CONCINO_INLINE repaired_arrays<polyhedra_arrays> repair_polyhedra(polyhedra_arrays a, const repair_options& options,
                                                                  repair_log& log) {
  polyhedra_mender m(std::move(a), log);
  if (options.merge_within) m.merge_verts(*options.merge_within);
  m.unite_faces(options.unite_faces);
  report_progress(options.progress, 0.3, "repair");
  if (options.remove_duplicates) m.remove_duplicates();
  m.turn(options.turn_inverted);
  report_progress(options.progress, 0.6, "repair");
  return m.finish(options.remove_unreferenced);
}

}  // namespace concino::detail

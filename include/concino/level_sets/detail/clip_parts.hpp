// The polys of a volume that a level set crosses, and their parts.
#pragma once

#include <concino/level_sets/clip_options.hpp>
#include <concino/level_sets/detail/cell_parts.hpp>
#include <concino/level_sets/detail/clip_verts.hpp>
#include <concino/level_sets/detail/convex_cells.hpp>
#include <concino/level_sets/detail/crossed_volume_reader.hpp>
#include <concino/level_sets/detail/parallel_cell_reader.hpp>
#include <concino/level_sets/detail/part_merger.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// Finds the parts of simple cells in the fast way, and those of the others in the general one. The lists are the same as if all were found in the general way,
/// but the fast way leaves out parts below that are not wanted.
template<class M>
class clip_parts {
  static constexpr auto surface = arity_v<M> > 0 ? cell_cuts::cells_are::spheres : cell_cuts::cells_are::unknown;

  double level_;
  std::vector<poly_t<M>> polys_;
  std::optional<parallel_cell_reader<M>> simple_;  // empty if one of the polys is unusual
  std::optional<crossed_volume_reader<M>> reader_;
  std::uint32_t first_of_reader_ = ~0u;            // ends from it on are verts of reader_
  std::vector<unsigned char> is_cut_, is_convex_;  // of the polys that were cut in the general way

 public:
  part_lists lists;
  place_ends ends;
  std::vector<std::uint32_t> poly_indices;
  std::vector<vert_t<M>> moved_verts;
  std::vector<unsigned char> is_cut, is_convex;  // by poly; is_convex is set where is_cut is

  /// Reads these polys. number_of_face: see simple_cells.
  template<class U>
  clip_parts(const M& m, const U& u, double level, const unsigned char* vert_states, const unsigned char* poly_states, std::uint32_t* number_of_face, std::vector<poly_t<M>> polys)
      : level_(level), polys_(std::move(polys)) {
    simple_.emplace(m, vert_states, number_of_face);
    if (!simple_->read(u, std::span<const poly_t<M>>(polys_), poly_states)) simple_.reset();
  }

  /// Cuts the polys, once.
  /// Errors: see cell_cuts.
  template<class U>
  void cut(const M& m, const U& u, bool both, const char* caller) {
    core::reserve_pages(poly_indices, polys_.size());
    for (const poly_t<M>& p : polys_) poly_indices.push_back(static_cast<std::uint32_t>(index_of(m, p)));
    const bool is_cut_fast = simple_ && cut_fast(m, u, both, caller);
    simple_.reset();
    if (!is_cut_fast) cut_all(m, u, caller);
  }

  /// The verts of m of which a place was made.
  void list_origins(const level_place& x, std::vector<origin>& list) const {
    if (x.above >= first_of_reader_) {
      const bool is_vert = x.kind == level_place::vert;
      reader_->list_origins({x.kind, is_vert ? x.element - first_of_reader_ : x.element, x.below - first_of_reader_, x.above - first_of_reader_}, list);
      return;
    }
    const double t = crossing_parameter(ends.values[x.below], ends.values[x.above], level_);
    list.assign({{ends.vert_indices[x.below], 1 - t}, {ends.vert_indices[x.above], t}});
  }

 private:
  template<class U>
  bool cut_fast(const M& m, const U& u, bool both, const char* caller) {
    parallel_cell_reader<M>& simple = *simple_;
    if (!simple.join()) return false;
    is_cut.assign(polys_.size(), 1);
    is_convex.resize(polys_.size());
    for (std::size_t c = 0; c < polys_.size(); ++c) is_convex[c] = simple.cells().is_convex(c);
    const std::vector<std::uint32_t> cells = simple.cells().cells_to_cut();
    if (cells.empty()) {
      part_merger merger(simple.cells(), both);
      merger.list();
      lists = std::move(merger.lists);
      lists.places = std::move(simple.places());
      ends = std::move(simple.ends());
      return true;
    }
    std::vector<poly_t<M>> to_cut;
    std::vector<std::uint32_t> indices;
    for (const std::uint32_t c : cells) to_cut.push_back(polys_[c]), indices.push_back(poly_indices[c]);
    const part_lists cut = cut_general(m, u, std::move(to_cut), indices, caller);
    if (!moved_verts.empty()) return false;
    for (std::size_t i = 0; i < cells.size(); ++i) is_cut[cells[i]] = is_cut_[i], is_convex[cells[i]] = is_convex_[i];
    return merge(simple, cells, cut, both);
  }

  bool merge(parallel_cell_reader<M>& simple, const std::vector<std::uint32_t>& cells, const part_lists& cut, bool both) {
    const auto num_ends = static_cast<std::uint32_t>(simple.ends().points.size());
    std::vector<level_place>& places = simple.places();
    std::vector<std::uint32_t> numbers;
    for (const level_place& x : cut.places) {
      if (x.kind == level_place::vert && reader_->arrays.vert_indices[x.above] != reader_->arrays.none) {
        numbers.push_back(part_lists::of_mesh | reader_->arrays.vert_indices[x.above]);
        continue;
      }
      std::uint32_t number = x.kind == level_place::edge ? simple.place_on_edge(x.element) : ~0u;
      if (number == ~0u) {
        number = static_cast<std::uint32_t>(places.size());
        places.push_back({x.kind, x.kind == level_place::vert ? x.element + num_ends : x.element, x.below + num_ends, x.above + num_ends});
      }
      numbers.push_back(number);
    }
    part_merger merger(simple.cells(), both, cells, &cut, numbers, places.size());
    if (!merger.list()) return false;
    lists = std::move(merger.lists);
    lists.places.resize(static_cast<std::size_t>(std::count_if(merger.final_places().begin(), merger.final_places().end(), [](std::uint32_t x) { return x != ~0u; })));
    for (std::size_t i = 0; i < places.size(); ++i)
      if (const std::uint32_t x = merger.final_places()[i]; x != ~0u) lists.places[x] = places[i];
    ends = std::move(simple.ends());
    first_of_reader_ = num_ends;
    const crossed_volume& v = reader_->arrays;
    ends.vert_indices.insert(ends.vert_indices.end(), v.vert_indices.begin(), v.vert_indices.end());
    ends.points.insert(ends.points.end(), v.points.begin(), v.points.end());
    ends.values.insert(ends.values.end(), v.values.begin(), v.values.end());
    return true;
  }

  template<class U>
  void cut_all(const M& m, const U& u, const char* caller) {
    moved_verts.clear();
    lists = cut_general(m, u, std::move(polys_), poly_indices, caller);
    is_cut = std::move(is_cut_), is_convex = std::move(is_convex_);
    first_of_reader_ = 0;
    ends = {reader_->arrays.vert_indices, reader_->arrays.points, reader_->arrays.values};
  }

  template<class U>
  part_lists cut_general(const M& m, const U& u, std::vector<poly_t<M>> polys, const std::vector<std::uint32_t>& indices, const char* caller) {
    const std::size_t n = polys.size();
    reader_.emplace(m, u, level_, std::move(polys));
    cell_cuts cuts(reader_->arrays, surface, caller, indices);
    is_cut_.assign(n, 0), is_convex_.assign(n, 0);
    for (const cell_cuts::loop& l : cuts.loops()) is_cut_[l.cell] |= l.cuts;
    for (std::uint32_t c = 0; c < n; ++c) is_convex_[c] = is_cut_[c] && is_convex_cell(reader_->arrays, c);
    cell_parts parts(cuts);
    for (const std::uint32_t v : parts.moved_verts) moved_verts.push_back(reader_->verts[v]);
    return std::move(static_cast<part_lists&>(parts));
  }
};

}  // namespace concino::detail

// Makes the level set of a volume as polygons, in the fast way where that is possible.
#pragma once

#include <concino/core/block_allocator.hpp>
#include <concino/core/large_pages.hpp>
#include <concino/level_sets/detail/crossed_edge.hpp>
#include <concino/level_sets/detail/crossed_edge_numbers.hpp>
#include <concino/level_sets/detail/crossed_volume_reader.hpp>
#include <concino/level_sets/detail/level_polygons.hpp>
#include <concino/level_sets/detail/simple_caps.hpp>

#include <algorithm>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace concino::detail {

/// A level set as polygons.
template<class M>
struct level_surface_parts {
  std::vector<mesh_point<M>> places;   // by vert
  std::vector<vec3> points;            // their positions
  std::vector<vert_id> verts;          // the corners of all polygons
  std::vector<std::uint32_t> offsets;  // where the corners of each polygon begin, and where those of the last one end
  std::vector<poly_t<M>> polys;        // by polygon
  std::vector<double> values;          // by polygon, or empty: the value of the level set
  element_origins origins;             // of the verts, if asked for
};

/// The level set of one value.
template<class M, class U>
class level_surface_maker {
  static constexpr auto surface = arity_v<M> > 0 ? cell_cuts::cells_are::spheres : cell_cuts::cells_are::unknown;
  static constexpr std::size_t chunk = 512;
  static constexpr std::size_t many = 16384;  // cells, whose corners are numbered in a quarter of a millisecond

  const M& m_;
  const U& u_;
  double level_;
  const char* caller_;
  bool with_origins_;
  state_array states_;
  std::vector<poly_t<M>> cells_;

 public:
  level_surface_maker(const M& m, const U& u, double level, bool with_origins, const char* caller)
      : m_(m), u_(u), level_(level), caller_(caller), with_origins_(with_origins), states_(level_states(m, u, level, caller)), cells_(crossed_polys(m, states_)) {}

  /// The level set by any way.
  level_surface_parts<M> make_general() const {
    const crossed_volume_reader<M> crossed(m_, u_, level_, cells_);
    cell_cuts cuts(crossed.arrays, surface, caller_, crossed.poly_indices);
    level_surface_arrays made = level_polygons(cuts).make();
    level_surface_parts<M> parts;
    for (const level_place& x : made.places) {
      parts.places.push_back(crossed.mesh_point_of(m_, x));
      parts.points.push_back(parts.places.back().position);
      if (with_origins_) parts.origins.add(std::span<const origin>(crossed.origins_of(x)));
    }
    for (const std::uint32_t v : made.verts) parts.verts.push_back(vert_id{v});
    parts.offsets.push_back(0);
    parts.offsets.insert(parts.offsets.end(), made.ends.begin(), made.ends.end());
    for (const std::uint32_t c : made.cells) parts.polys.push_back(cells_[c]);
    return parts;
  }

  /// The level set, if no vert lies on it. It may lack the last step: verts are not doubled where fans meet, and polygons that cancel are kept.
  /// Returns false if a vert lies on the level set.
  bool make_simple(level_surface_parts<M>& parts) const {
    std::vector<simple_cap_list<M>> lists((cells_.size() + chunk - 1) / chunk);
    const std::size_t bound = edge_index_bound(m_), of_lists = (cells_.size() + lists.size()) * simple_cap_list<M>::bytes_per_cell;
    const std::size_t of_numbers = crossed_edge_numbers<M>::bytes_for(bound, cells_.size());  // most level sets cross fewer edges than cells
    const auto block = std::make_shared<core::memory_block>(of_numbers + of_lists);
    crossed_edge_numbers<M> numbers(bound, block);
    std::mutex announcing;
    const unsigned char* const states = states_.data();
    parallel_for(
        lists.size(),
        [&](std::size_t i) {
          simple_cap_reader<M> reader(m_, states);
          const std::size_t first = i * chunk, last = std::min(cells_.size(), first + chunk);
          lists[i] = simple_cap_list<M>(last - first, block);
          reader.read({cells_.data() + first, last - first}, static_cast<std::uint32_t>(first), lists[i]);
          const std::lock_guard<std::mutex> lock(announcing);  // for a sixth of the time of a chunk
          for (const edge_t<M>& e : lists[i].corners) numbers.announce(index_of(m_, e));
        },
        1);
    std::vector<poly_t<M>> difficult;
    std::vector<std::uint32_t> difficult_numbers;
    for (const simple_cap_list<M>& list : lists) {
      if (list.meets_verts) return false;
      for (const std::uint32_t c : list.difficult) difficult.push_back(cells_[c]), difficult_numbers.push_back(c);
    }
    const crossed_volume_reader<M> others(m_, u_, level_, std::move(difficult));
    level_surface_arrays other_caps;
    if (!others.polys.empty()) {
      cell_cuts cuts(others.arrays, surface, caller_, others.poly_indices);
      other_caps = level_polygons(cuts).make();
    }
    join(lists, others, other_caps, difficult_numbers, numbers, parts);
    return true;
  }

 private:
  /// Announces the edges of other caps, and makes room. Returns the number of places, or a little more.
  std::size_t prepare(const std::vector<simple_cap_list<M>>& lists, const crossed_volume_reader<M>& others, const level_surface_arrays& other_caps,
                      crossed_edge_numbers<M>& numbers, level_surface_parts<M>& parts) const {
    std::size_t num_corners = other_caps.verts.size(), num_polys = other_caps.ends.size(), num_inside = 0;
    for (const simple_cap_list<M>& list : lists) num_corners += list.corners.size(), num_polys += list.ends.size();
    for (const level_place& x : other_caps.places)
      if (x.kind == level_place::edge && others.is_edge_of_mesh(x.element)) numbers.announce(x.element);
      else ++num_inside;
    parts.verts.reserve(num_corners), parts.offsets.reserve(num_polys + 1), parts.polys.reserve(num_polys);
    parts.offsets.push_back(0);
    return numbers.count() + num_inside;
  }

  /// Numbers the corners, whose edges are announced, and merges the caps of simple and of difficult cells in the order of the cells.
  void join(const std::vector<simple_cap_list<M>>& lists, const crossed_volume_reader<M>& others, const level_surface_arrays& other_caps,
            const std::vector<std::uint32_t>& difficult, crossed_edge_numbers<M>& numbers, level_surface_parts<M>& parts) const {
    const std::size_t max_places = prepare(lists, others, other_caps, numbers, parts);
    place_numbers other_places;
    std::vector<std::uint32_t> number_of_other;  // by number in other_places
    std::vector<std::pair<std::uint32_t, level_place>> inside;
    std::size_t other = 0;
    const auto add_others_before = [&](std::uint32_t cell) {
      for (; other < other_caps.ends.size() && difficult[other_caps.cells[other]] < cell; ++other) {
        for (std::uint32_t k = other == 0 ? 0 : other_caps.ends[other - 1]; k < other_caps.ends[other]; ++k) {
          const level_place& x = other_caps.places[other_caps.verts[k]];
          if (x.kind == level_place::edge && others.is_edge_of_mesh(x.element)) {
            parts.verts.push_back(vert_id{numbers.add(m_, others.edge_of(x.element))});
            continue;
          }
          const std::uint32_t n = other_places.add(x);
          if (n == number_of_other.size()) {
            number_of_other.push_back(numbers.add_other());
            inside.push_back({number_of_other.back(), x});
          }
          parts.verts.push_back(vert_id{number_of_other[n]});
        }
        parts.offsets.push_back(static_cast<std::uint32_t>(parts.verts.size()));
        parts.polys.push_back(others.polys[other_caps.cells[other]]);
      }
    };
    const auto number_corners = [&] {
      crossed_edge_numbers<M>& to_numbers = numbers;  // compilers keep variables of this function in registers
      level_surface_parts<M>& to = parts;
      for (const simple_cap_list<M>& list : lists) {
        std::uint32_t k = 0;
        for (std::size_t i = 0; i < list.ends.size(); ++i) {
          if (other < other_caps.ends.size()) add_others_before(list.cells[i]);
          for (; k < list.ends[i]; ++k) to.verts.push_back(vert_id{to_numbers.add(m_, list.corners[k])});
          to.offsets.push_back(static_cast<std::uint32_t>(to.verts.size()));
          to.polys.push_back(cells_[list.cells[i]]);
        }
      }
      add_others_before(~0u);
    };
    // Pages of new memory take as long as numbers. While one thread requests some, the system lets another wait if it allocates.
    core::reserve_exact(parts.places, max_places), core::reserve_exact(parts.points, max_places), core::reserve_exact(parts.values, parts.polys.capacity());
    const auto request = [](auto& v) { core::request_pages(v.data(), v.capacity() * sizeof v[0]); };
    const auto request_lists = [&] { request(parts.verts), request(parts.offsets), request(parts.polys); };
    const auto make_places = [&] { request(parts.places), parts.places.resize(max_places); };
    const auto make_points = [&] { request(parts.points), parts.points.resize(max_places); };
    const auto make_values = [&] { request(parts.values), parts.values.resize(parts.values.capacity(), level_); };
    core::run_all(cells_.size() > many, {request_lists, number_corners, make_places, make_points, make_values});
    parts.places.resize(numbers.edges.size()), parts.points.resize(numbers.edges.size()), parts.values.resize(parts.polys.size());
    locate_edges(numbers, parts);
    for (const auto& [number, x] : inside) parts.places[number] = others.mesh_point_of(m_, x), parts.points[number] = parts.places[number].position;
    if (!with_origins_) return;
    auto next = inside.begin();
    for (std::size_t i = 0; i < numbers.edges.size(); ++i) {
      if (numbers.is_edge(i)) add_origins(parts.places[i], parts.origins);
      else parts.origins.add(std::span<const origin>(others.origins_of((next++)->second)));
    }
  }

  void locate_edges(const crossed_edge_numbers<M>& numbers, level_surface_parts<M>& parts) const {
    constexpr std::size_t some = 1024;
    const std::size_t n = numbers.edges.size();
    parallel_for(
        (n + some - 1) / some,
        [&](std::size_t i) {
          const std::size_t first = i * some;
          cross_edges(
              m_, u_, level_, std::min(some, n - first), [&](std::size_t k) { return numbers.is_edge(first + k); },
              [&](std::size_t k) { return numbers.edges[first + k]; }, [&](std::size_t k, const mesh_point<M>& x) {
                parts.places[first + k] = x;
                parts.points[first + k] = x.position;
              });
        },
        1);
  }

  void add_origins(const mesh_point<M>& x, element_origins& to) const {
    const edge_point<M>& on_edge = std::get<edge_point<M>>(x.element);
    const auto ends = end_verts(m_, on_edge.edge);
    to.add({{static_cast<std::uint32_t>(index_of(m_, ends.first)), 1 - on_edge.parameter}, {static_cast<std::uint32_t>(index_of(m_, ends.second)), on_edge.parameter}});
  }
};

}  // namespace concino::detail

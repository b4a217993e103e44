// Lines of one field from many starts: options and starts are checked, and lines found in parallel.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/block_allocator.hpp>
#include <concino/core/large_pages.hpp>
#include <concino/core/memory_blocks.hpp>
#include <concino/core/parallel.hpp>
#include <concino/core/progress.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/lowest_element.hpp>
#include <concino/lines/detail/surface_line_walker.hpp>
#include <concino/lines/detail/volume_line_walker.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

namespace requirement {

template<class M, class S>
concept is_line_start = std::same_as<S, vert_t<M>> || std::same_as<S, poly_t<M>> || std::same_as<S, mesh_point<std::remove_cvref_t<M>>>;
template<class M, class R>
concept gives_line_starts = requires(const R& r) {
  { *r.begin() };
  r.end();
} && is_line_start<M, std::remove_cvref_t<decltype(*std::declval<const R&>().begin())>>;

}  // namespace requirement

namespace detail {

template<class M, class G>
using line_walker = typename std::conditional_t<dimension_v<M> == 2, std::type_identity<surface_line_walker<M, G>>, std::type_identity<volume_line_walker<M, G>>>::type;

/// Memory for the lines of one call. The system takes longer to make small pages for them than they take to be followed.
class line_memory {
  core::memory_blocks blocks_;
  std::size_t num_lines_;

 public:
  explicit line_memory(std::size_t num_lines) : num_lines_(num_lines) {}
  std::shared_ptr<core::memory_block> block_for(std::size_t bytes) { return blocks_.block_for(bytes, num_lines_); }
};

/// An empty line with memory for points, its own or from `memory`. Pages are requested at once: waiting for each of them takes longer than following a line
/// through some polys.
template<class M>
field_line<M> line_with_memory(std::size_t num_points, std::size_t num_polys, line_memory* memory) {
  field_line<M> line;
  if (memory) {
    const auto block = memory->block_for(num_points * sizeof(mesh_point<M>) + num_polys * sizeof(poly_t<M>) + 2 * alignof(std::max_align_t));
    line.points = decltype(line.points)(core::block_allocator<mesh_point<M>>(block));
    line.polys = decltype(line.polys)(core::block_allocator<poly_t<M>>(block));
  }
  line.points.reserve(num_points);
  line.polys.reserve(num_polys);
  core::request_pages(line.points.data(), num_points * sizeof(mesh_point<M>));
  return line;
}

template<class M>
field_line<M> compact_copy(const field_line<M>& x, line_memory* memory) {
  field_line<M> line = line_with_memory<M>(x.points.size(), x.polys.size(), memory);
  line = x;
  return line;
}

/// The first part turned round, then the second one, from the same start.
template<class M>
field_line<M> joined(const field_line<M>& back, const field_line<M>& forward, line_memory* memory = nullptr) {
  field_line<M> line = line_with_memory<M>(back.points.size() + forward.points.size() - 1, back.polys.size() + forward.polys.size(), memory);
  line.points.assign(back.points.rbegin(), back.points.rend());
  line.points.insert(line.points.end(), forward.points.begin() + 1, forward.points.end());
  line.polys.assign(back.polys.rbegin(), back.polys.rend());
  line.polys.insert(line.polys.end(), forward.polys.begin(), forward.polys.end());
  line.length = back.length + forward.length;
  line.began_by = back.stopped_by;
  line.stopped_by = forward.stopped_by;
  line.cycle = forward.cycle.empty() ? back.cycle : forward.cycle;
  return line;
}

/// Follows one line to its end.
template<class M, class Walker>
void run(Walker& walker, const mesh_point<M>& start, double sense, line_recorder<M>& to) {
  walker.start(start, sense, to);
  while (!to.done()) walker.step(to);
}

/// Reader: of the field, from the mesh, what the caller passed and the caller's name. Walker: from the mesh and a reader.
template<class M, class Reader, class Walker>
class field_follower {
  static constexpr std::size_t lines_per_task = 16;

  const M* m_;
  const char* caller_;
  Reader field_;
  integral_line_options options_;
  std::size_t max_steps_;

 public:
  template<class G>
  field_follower(const M& m, const G& g, const integral_line_options& options, const char* caller)
      : m_(&m), caller_(caller), field_(m, g, caller), options_(options), max_steps_(options.max_steps) {
    if (!(options.max_length > 0)) core::throw_joined<invalid_argument>({caller, ": max_length must be above 0; leave it out to follow lines to their end"});
    if (max_steps_ == 0) max_steps_ = 16 * num_polys(m) + 1000;
  }

  template<class S>
  field_line<M> line(const S& start) const {
    line_in_turn x(*m_, field_);
    begin(x, place_of(start), 0);
    while (!is_done(x)) x.walker.step(*x.to);
    return line_of(x, nullptr);
  }

  template<class R>
  std::vector<field_line<M>> lines(const R& starts) const {
    std::vector<mesh_point<M>> places;
    for (const auto& x : starts) places.push_back(place_of(x));
    std::vector<field_line<M>> found(places.size());
    line_memory memory(places.size());
    unused_lines unused;
    const std::size_t tasks = (places.size() + lines_per_task - 1) / lines_per_task;
    const auto follow_some = [&](std::size_t task) {
      std::size_t next = task * lines_per_task;
      const std::size_t end = std::min(places.size(), next + lines_per_task);
      std::vector<std::unique_ptr<line_in_turn>> turns;
      const auto begin_next = [&](line_in_turn& x) {
        begin(x, places[next], next);
        ++next;
      };
      while (next < end && turns.size() < Walker::lines_in_turn) {
        turns.push_back(unused.take(*m_, field_));
        begin_next(*turns.back());
      }
      while (!turns.empty())
        for (std::size_t i = 0; i < turns.size();) {
          line_in_turn& x = *turns[i];
          if (!is_done(x)) {
            x.walker.step(*x.to);
            ++i;
            continue;
          }
          found[x.number] = line_of(x, &memory);
          if (next < end) {
            begin_next(x);
          } else {
            unused.give(std::move(turns[i]));
            turns.erase(turns.begin() + static_cast<std::ptrdiff_t>(i));
          }
        }
    };
    bool stopped = false;
    parallel_for(tasks, follow_some, 1, [&](double done) { return stopped = options_.progress && !options_.progress(done, caller_); });
    if (stopped) core::throw_joined<cancelled>({caller_, ": stopped by the progress callback"});
    return found;
  }

 private:
  mesh_point<M> place_of(const vert_t<M>& v) const { return place_of(mesh_point<M>{v, {}}); }
  mesh_point<M> place_of(const poly_t<M>& p) const {
    if (!contains(*m_, p)) return place_of(mesh_point<M>{p, {}});
    return nearest_place(*m_, p, centroid(*m_, p), caller_);
  }
  mesh_point<M> place_of(const mesh_point<M>& x) const { return lowest_element_of(*m_, x, caller_, "start"); }

  /// A line that is followed by steps, in turn with others: while memory for the one is on its way, the others go on. Its memory grows with the lines, and
  /// what is returned is copied from it.
  struct line_in_turn {
    Walker walker;
    field_line<M> forward, backward;
    std::optional<line_recorder<M>> to;
    mesh_point<M> start = {vert_t<M>(), {}};
    std::size_t number = 0;
    bool is_backward = false;  // the part that is followed

    line_in_turn(const M& m, const Reader& field) : walker(m, field) {}
  };

  /// Those that no thread uses, with their memory.
  class unused_lines {
    std::mutex mutex_;
    std::vector<std::unique_ptr<line_in_turn>> all_;

   public:
    std::unique_ptr<line_in_turn> take(const M& m, const Reader& field) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (all_.empty()) return std::make_unique<line_in_turn>(m, field);
      std::unique_ptr<line_in_turn> last = std::move(all_.back());
      all_.pop_back();
      return last;
    }
    void give(std::unique_ptr<line_in_turn> x) {
      const std::lock_guard<std::mutex> lock(mutex_);
      all_.push_back(std::move(x));
    }
  };

  void begin(line_in_turn& x, const mesh_point<M>& start, std::size_t number) const {
    x.start = start;
    x.number = number;
    begin_part(x, !options_.both_ways && options_.backward);
  }
  void begin_part(line_in_turn& x, bool backward) const {
    x.is_backward = backward;
    x.to.emplace(backward ? x.backward : x.forward, options_.max_length, max_steps_);
    x.walker.start(x.start, backward ? -1 : 1, *x.to);
  }
  /// Of lines both ways, the second part begins where the first one is done, unless this is closed.
  bool is_done(line_in_turn& x) const {
    if (!x.to->done()) return false;
    if (!options_.both_ways || x.is_backward || x.forward.stopped_by == line_end::closed) return true;
    begin_part(x, true);
    return x.to->done();
  }
  field_line<M> line_of(const line_in_turn& x, line_memory* memory) const {
    if (options_.both_ways && x.is_backward) return joined(x.backward, x.forward, memory);
    return compact_copy(x.is_backward ? x.backward : x.forward, memory);
  }
};

template<class M, class G>
using poly_field_follower = field_follower<M, field_reader<M, G>, line_walker<M, G>>;

}  // namespace detail

}  // namespace concino

// The laws HE1 and HE2 of <concino/concepts/halfedge_kernel.hpp>: the half-edges along polys, and their directions.
#pragma once

#include <concino/concepts/halfedge_kernel.hpp>
#include <concino/core/message.hpp>
#include <concino/validate/detail/element_table.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace concino::detail {

/// Surfaces whose mesh_traits come from halfedge_kernel.
template<class M> concept halfedge_mesh = SurfaceMesh<M> && requires { typename traits<M>::halfedge_links; };

/// Checks the laws HE1 and HE2 in order, and keeps the half-edges along polys.
template<halfedge_mesh M>
class halfedge_polygon_laws {
  static constexpr const char* remedy = ": half-edges cannot represent that, use indexed_surface";

 protected:
  using K = typename traits<M>::halfedge_links;
  using halfedge = typename K::halfedge;
  struct step {  // along a poly
    halfedge h;
    order_index poly, from, to;
  };

  const M& m_;
  law_log& log_;
  element_table<vert_t<M>> vs_;
  element_table<poly_t<M>> ps_;
  std::vector<step> steps_;

  halfedge_polygon_laws(const M& m, law_log& log) : m_(m), log_(log) {}

  static std::string number(const char* kind, std::size_t i) { return core::joined({kind, " ", i}); }
  std::string vert_name(order_index v) const { return number("vert", vs_.index[v]); }
  std::string poly_name(order_index p) const { return number("poly", ps_.index[p]); }
  std::string describe_direction(const step& s) const {
    return core::joined({"from ", vert_name(s.from), " to ", vert_name(s.to)});
  }
  std::string witness(const step& s) const { return core::joined({vs_.name(s.from), " ", vs_.name(s.to)}); }

  void read_verts(law_log& log) {
    vs_ = read_elements<vert_t<M>>(m_, 'v', verts, num_verts, vert_index_bound, "PG1", "PG2", log);
  }
  void read_polys(law_log& log) {
    ps_ = read_elements<poly_t<M>>(m_, 'p', polys, num_polys, poly_index_bound, "DG1", "DG2", log);
  }

  bool fault(const char* law, core::message what, std::string witness) {
    log_.add(law, core::joined(what), std::move(witness));
    return log_.full(law);
  }
  bool law_holds(const char* law) const { return log_.count(law) == 0; }

  static bool same_verts(const step& a, const step& b) {
    return (a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from);
  }

  bool walk_polys() {
    for (order_index p = 0; p < ps_.size() && !log_.full("HE1"); ++p) {
      const halfedge start = K::halfedge_of(m_, ps_.items[p]);
      const std::size_t first = steps_.size();
      halfedge h = start, mark = start;
      std::size_t limit = 1;  // a cycle without its start meets the mark again, which moves on at 1, 3, 7, 15 ... steps
      do {
        const std::size_t k = steps_.size() - first;
        if (K::is_border(m_, h)) {
          fault("HE1",
                {"the half-edges of ", poly_name(p),
                 k ? ": next leads to one at the border" : ": halfedge_of is at the border"},
                ps_.name(p));
          break;
        }
        if (!(K::poly_of(m_, h) == ps_.items[p])) {
          fault("HE1",
                {"the half-edges of ", poly_name(p),
                 k ? ": next leads to one whose poly_of is another poly" : ": poly_of(halfedge_of) is another poly"},
                ps_.name(p));
          break;
        }
        const order_index to = vs_.find(m_, K::target(m_, h));
        if (to == no_order_index) {
          fault("HE1", {"the half-edges of ", poly_name(p), ": the target of one of them is not a vert of the mesh"},
                ps_.name(p));
          break;
        }
        steps_.push_back({h, p, steps_.size() > first ? steps_.back().to : no_order_index, to});
        h = K::next(m_, h);
        if (h == start) break;
        if (h == mark) {
          fault("HE1", {"the half-edges of ", poly_name(p), ": next does not come back to halfedge_of"}, ps_.name(p));
          break;
        }
        if (k + 1 == limit) mark = h, limit = 2 * limit + 1;
      } while (true);
      if (steps_.size() > first) steps_[first].from = steps_.back().to;
    }
    return law_holds("HE1");
  }

  bool check_polys_of_edges() {
    sort_steps();
    for (std::size_t i = 0, n = 0; i < steps_.size() && !log_.full("HE2"); i += n) {
      for (n = 1; i + n < steps_.size() && same_verts(steps_[i], steps_[i + n]);) ++n;
      const step &s = steps_[i], &t = steps_[i + n - 1];
      if (s.from == s.to) {
        fault("HE2", {poly_name(s.poly), " runs from ", vert_name(s.from), " to itself"}, witness(s));
      } else if (n > 2) {
        std::string polys;
        for (std::size_t k = i; k < i + n && k < i + 4; ++k)
          polys += core::joined({k > i ? ", " : "", ps_.name(steps_[k].poly)});
        fault("HE2",
              {"the edge ", describe_direction(s), " has ", n, " polys (", polys, n > 4 ? ", ...)" : ")", remedy},
              witness(s));
      } else if (n == 2 && s.poly == t.poly && s.from == t.from) {
        fault("HE2", {poly_name(s.poly), " runs ", describe_direction(s), " twice", remedy}, witness(s));
      } else if (n == 2 && s.from == t.from) {
        fault("HE2",
              {poly_name(s.poly), " and ", poly_name(t.poly), " both run ", describe_direction(s),
               ", so their orientations disagree: reverse one of them, or use indexed_surface"},
              witness(s));
      }
    }
    return law_holds("HE2");
  }

 private:
  /// Sorts steps_ so that steps between the same two verts are adjacent: by the larger vert, then stably by the
  /// smaller.
  void sort_steps() {
    std::vector<step> sorted(steps_.size());
    std::vector<std::size_t> next(vs_.size() + std::size_t{1});
    for (const bool by_smaller : {false, true}) {
      const auto key = [&](const step& s) { return by_smaller ? std::min(s.from, s.to) : std::max(s.from, s.to); };
      std::fill(next.begin(), next.end(), 0);
      for (const step& s : steps_) ++next[key(s) + std::size_t{1}];
      for (order_index v = 0; v < vs_.size(); ++v) next[v + std::size_t{1}] += next[v];
      for (const step& s : steps_) sorted[next[key(s)]++] = s;
      steps_.swap(sorted);
    }
  }
};

}  // namespace concino::detail

// The laws HE1 .. HE4 of <concino/concepts/halfedge_kernel.hpp>: the links of half-edges, and which surfaces they can
// represent.
#pragma once

#include <concino/concepts/halfedge_kernel.hpp>
#include <concino/core/message.hpp>
#include <concino/validate/detail/halfedge_polygon_laws.hpp>
#include <concino/validate/detail/law_tables.hpp>

#include <new>

namespace concino::detail {

/// Checks the laws HE1 .. HE4 in order. Only half-edges to which links lead that were found to be right are queried,
/// because wrong links may lead to half-edges that do not exist.
template<halfedge_mesh M>
class halfedge_laws : halfedge_polygon_laws<M> {
  using base = halfedge_polygon_laws<M>;
  using K = typename traits<M>::halfedge_links;
  using typename base::halfedge, typename base::step;
  using base::m_, base::log_, base::vs_, base::ps_, base::steps_;
  using base::number, base::vert_name, base::poly_name, base::describe_direction, base::witness, base::same_verts,
      base::fault, base::law_holds;

  element_table<edge_t<M>> es_;
  std::vector<halfedge> halfedges_;  // 2 e and 2 e + 1: the half-edges of the edge at position e

  std::string edge_name(order_index e) const { return number("edge", es_.index[e]); }

 public:
  halfedge_laws(const M& m, law_log& log) : base(m, log) {}

  /// Reads the elements. Other laws check them.
  bool read_elements_of_mesh(law_log& log) {
    this->read_verts(log);
    es_ = read_elements<edge_t<M>>(m_, 'e', edges, num_edges, edge_index_bound, "SM1", "SM1", log);
    this->read_polys(log);
    return log.empty();
  }

  /// Whether all laws hold. Call it only if the elements could be read.
  bool check() {
    try {
      return this->walk_polys() && this->check_polys_of_edges() && check_borders_exist() && check_pairs() &&
             walk_around_verts();
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& e) {
      log_.add("HE1", core::joined({"a function of the half-edges throws: ", e.what()}), "");
      return false;
    }
  }

 private:
  /// Libraries without border half-edges return one value for all of them from `opposite`, or the half-edge itself.
  bool check_borders_exist() {
    const step* first = nullptr;  // the first step at the border
    for (std::size_t i = 0, n = 0; i < steps_.size(); i += n) {
      n = i + 1 < steps_.size() && same_verts(steps_[i], steps_[i + 1]) ? 2 : 1;
      if (n == 2) continue;
      const step& s = steps_[i];
      const halfedge o = K::opposite(m_, s.h);
      if (o == s.h || (first && o == K::opposite(m_, first->h))) {
        fault("HE3",
              {"the edge ", describe_direction(s), " lies at the border, and opposite gives ",
               o == s.h ? "the half-edge itself" : "another border edge the same half-edge",
               ": border half-edges must exist, or the links say static constexpr bool has_border_halfedges = false"},
              witness(s));
        return false;
      }
      if (!first) first = &s;
    }
    return true;
  }

  bool check_pairs() {
    for (std::size_t i = 0, n = 0; i < steps_.size() && !log_.full("HE3"); i += n) {
      n = i + 1 < steps_.size() && same_verts(steps_[i], steps_[i + 1]) ? 2 : 1;
      const step& s = steps_[i];
      const halfedge o = K::opposite(m_, s.h);
      if (n == 2) {
        const step& t = steps_[i + 1];
        if (!(o == t.h) || !(K::opposite(m_, t.h) == s.h))
          fault("HE3",
                {"the half-edges ", describe_direction(s), " of ", poly_name(s.poly), " and ", describe_direction(t),
                 " of ", poly_name(t.poly), " are not opposite to each other"},
                witness(s));
      } else if (!K::is_border(m_, o)) {
        fault("HE3",
              {"the half-edge ", describe_direction(s), " of ", poly_name(s.poly),
               ": its opposite belongs to a poly that does not run the other way"},
              witness(s));
      } else if (!(K::opposite(m_, o) == s.h)) {
        fault("HE3",
              {"the half-edge ", describe_direction(s), " of ", poly_name(s.poly),
               ": opposite of its opposite is another half-edge"},
              witness(s));
      } else if (vs_.find(m_, K::target(m_, o)) != s.from) {
        fault("HE3",
              {"the half-edge ", describe_direction(s), " of ", poly_name(s.poly), ": its opposite does not lead to ",
               vert_name(s.from)},
              witness(s));
      }
    }
    if (!law_holds("HE3")) return false;
    halfedges_.reserve(2 * es_.items.size());
    for (order_index e = 0; e < es_.size(); ++e) {
      halfedges_.push_back(K::halfedge_of(m_, es_.items[e]));
      halfedges_.push_back(K::opposite(m_, halfedges_.back()));
      const halfedge &h = halfedges_[2 * std::size_t{e}], &o = halfedges_.back();
      const bool good = !(o == h) && K::opposite(m_, o) == h && K::edge_of(m_, h) == es_.items[e] &&
                        K::edge_of(m_, o) == es_.items[e];
      if (!good &&
          fault("HE3",
                {edge_name(e),
                 ": edge_of(halfedge_of(e)) and of its opposite must be e, and the two be opposite to each other"},
                es_.name(e)))
        break;
    }
    if (!law_holds("HE3")) return false;
    for (std::size_t i = 0; i < halfedges_.size(); ++i)
      if (K::is_border(m_, halfedges_[i]) && !K::is_border(m_, K::next(m_, halfedges_[i])) &&
          fault(
              "HE1",
              {edge_name(static_cast<order_index>(i / 2)), ": next leads from its half-edge at the border into a poly"},
              es_.name(static_cast<order_index>(i / 2))))
        break;
    if (!law_holds("HE1")) return false;
    return check_edges_of_halfedges();
  }

  /// Whether each half-edge of a poly is one of the two of its edge.
  bool check_edges_of_halfedges() {
    for (const step& s : steps_)
      if (number_of_halfedge(s.h) == none && fault("HE3",
                                                   {"the half-edge ", describe_direction(s), " of ", poly_name(s.poly),
                                                    ": its edge_of has other half-edges"},
                                                   ps_.name(s.poly)))
        break;
    return law_holds("HE3");
  }

  static constexpr std::size_t none = ~std::size_t{0};
  std::size_t number_of_halfedge(const halfedge& h) const {
    const order_index e = es_.find(m_, K::edge_of(m_, h));
    if (e == no_order_index) return none;
    const std::size_t i = 2 * std::size_t{e};
    return halfedges_[i] == h ? i : halfedges_[i + 1] == h ? i + 1 : none;
  }

  /// Marks and counts the half-edges around v, beginning with start, and counts those at the border.
  /// Result: null, or a text that says why the walk failed.
  struct counts { std::size_t all = 0, at_border = 0; };
  const char* walk_around(order_index v, const halfedge& start, std::vector<std::uint8_t>& visited,
                          counts& count) const {
    halfedge h = start;
    do {
      const halfedge o = K::opposite(m_, h);
      if (vs_.find(m_, K::target(m_, o)) != v) return " leads to a half-edge that leaves another vert";
      const std::size_t i = number_of_halfedge(h);
      if (i == none) return " leads to a half-edge of no edge of the mesh";
      if (visited[i]) return " does not come back to the first half-edge";
      visited[i] = 1;
      ++count.all;
      count.at_border += K::is_border(m_, h);
      h = K::next(m_, o);
    } while (!(h == start));
    return nullptr;
  }

  bool walk_around_verts() {
    std::vector<std::size_t> leaving(vs_.items.size());
    std::vector<order_index> from(halfedges_.size());
    for (std::size_t i = 0; i < halfedges_.size(); ++i) {
      from[i] = vs_.find(m_, K::target(m_, halfedges_[i ^ 1]));
      if (from[i] != no_order_index) ++leaving[from[i]];
      else if (fault("HE3",
                     {edge_name(static_cast<order_index>(i / 2)),
                      ": the target of one of its half-edges is not a vert of the mesh"},
                     es_.name(static_cast<order_index>(i / 2))))
        return false;
    }
    if (!law_holds("HE3")) return false;

    std::vector<std::uint8_t> visited(halfedges_.size());
    std::vector<order_index> with_several_fans;  // verts with half-edges that were not visited
    for (order_index v = 0; v < vs_.size() && !log_.full("HE4"); ++v) {
      if (K::is_isolated(m_, vs_.items[v])) {
        if (leaving[v]) fault("HE4", {vert_name(v), ": is_isolated is true, but half-edges leave it"}, vs_.name(v));
        continue;
      }
      counts count;
      if (!leaving[v]) fault("HE4", {vert_name(v), ": is_isolated is false, but no half-edge leaves it"}, vs_.name(v));
      else if (const char* why = walk_around(v, K::halfedge_of(m_, vs_.items[v]), visited, count))
        fault("HE4", {vert_name(v), ": stepping from halfedge_of to next(opposite(h))", why}, vs_.name(v));
      else if (count.all < leaving[v]) with_several_fans.push_back(v);
    }
    if (!law_holds("HE4")) return false;
    if (with_several_fans.empty()) return true;
    // An open fan has one border half-edge that leaves its vert; a closed fan is a cycle without any.
    std::vector<std::size_t> fans(vs_.items.size());
    std::fill(visited.begin(), visited.end(), 0);
    for (std::size_t i = 0; i < halfedges_.size(); ++i) {
      fans[from[i]] += K::is_border(m_, halfedges_[i]);
      counts count;
      if (!visited[i] && !walk_around(from[i], halfedges_[i], visited, count) && count.at_border == 0) ++fans[from[i]];
    }
    for (const order_index v : with_several_fans) {
      const char* const words[] = {"two", "three", "four"};
      const std::string n = fans[v] >= 2 && fans[v] < 5 ? words[fans[v] - 2] : core::joined({fans[v]});
      if (fault("HE4",
                {vert_name(v), " has ", n,
                 " fans of polys: use indexed_surface, or link the border half-edges from one fan to the next"},
                vs_.name(v)))
        break;
    }
    return false;
  }
};

}  // namespace concino::detail

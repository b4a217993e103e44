// Tables for law checks: elements and adjacencies are read once into arrays over positions (the order of iteration),
// guarding against any wrong result of a broken mesh. The laws are then statements about these arrays.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/message.hpp>
#include <concino/validate/broken_law.hpp>
#include <concino/validate/detail/element_table.hpp>

#include <exception>
#include <new>
#include <span>
#include <vector>

namespace concino::detail {

/// For each a of a table its adjacent b's, all by position, in the order of the mesh.
struct adjacency_lists {
  std::vector<std::size_t> offsets{0};
  std::vector<order_index> items;

  order_index size() const { return static_cast<order_index>(offsets.size() - 1); }
  std::span<const order_index> operator[](order_index a) const {
    return {items.data() + offsets[a], items.data() + offsets[a + 1]};
  }
  void close() { offsets.push_back(items.size()); }
};

/// Reads one adjacency. Each ring must contain only elements of the mesh, none twice, and be the same each time;
/// otherwise `law` is broken.
template<class M, class A, class B, class Ring>
adjacency_lists read_adjacency(const M& m, const element_table<A>& from, const element_table<B>& to,
                               const Ring& ring_of, const char* law, const char* verb, law_log& log) {
  adjacency_lists r;
  r.offsets.reserve(from.items.size() + 1);
  std::vector<order_index> seen(to.items.size(), no_order_index);
  for (order_index a = 0; a < from.size(); ++a) {
    const auto call = [&] { return core::joined({verb, "(", from.name(a), ")"}); };
    try {
      auto&& ring = ring_of(m, from.items[a]);
      // An endless ring has many faults in a row. If one is left early, the elements that were not reached would be
      // reported as missing.
      const std::size_t endless = log.full(law) ? 16 : 1024 + to.size();
      std::size_t faults = 0, in_a_row = 0;
      for (auto it = ring.begin(); in_a_row < endless && it != ring.end(); ++it) {
        const B x = *it;
        const order_index b = to.find(m, x);
        if (b != no_order_index && seen[b] != a) {
          seen[b] = a;
          r.items.push_back(b);
          in_a_row = 0;
          continue;
        }
        ++in_a_row;
        if (faults++ > 0) continue;  // one witness per ring
        if (b != no_order_index)
          log.add(law, core::joined({call(), " holds ", to.name(b), " twice"}),
                  core::joined({from.name(a), " ", to.name(b)}));
        else if (to.is_complete)  // otherwise it may have been left out of the table, and reported before
          log.add(law, core::joined({call(), " holds something that is not a ", to.kind(), " of the mesh"}),
                  core::joined({from.name(a), " ", to.letter, index_of(m, x)}));
      }
      if (faults == 0) {
        std::size_t i = r.offsets.back();
        bool same = true;
        for (auto it = ring.begin(); same && it != ring.end(); ++it, ++i)
          same = i < r.items.size() && to.items[r.items[i]] == static_cast<B>(*it);
        if (!same || i != r.items.size())
          log.add(law, core::joined({call(), " has other elements when iterated again"}), from.name(a));
      }
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& e) {
      log.add(law, core::joined({call(), " throws: ", e.what()}), from.name(a));
    }
    r.close();
  }
  return r;
}

/// For each b the a's whose ring contains it.
inline adjacency_lists transposed(const adjacency_lists& ab, order_index num_b) {
  adjacency_lists t;
  t.offsets.assign(num_b + std::size_t{1}, 0);
  for (const order_index b : ab.items) ++t.offsets[b + std::size_t{1}];
  for (std::size_t b = 0; b < num_b; ++b) t.offsets[b + 1] += t.offsets[b];
  t.items.resize(ab.items.size());
  std::vector<std::size_t> next(t.offsets.begin(), t.offsets.end() - 1);
  for (order_index a = 0; a < ab.size(); ++a)
    for (const order_index b : ab[a]) t.items[next[b]++] = a;
  return t;
}

/// For each a the b's of its m's: the adj_a2b that follows from adj_a2m and adj_m2b. A b may occur several times.
inline adjacency_lists composed(const adjacency_lists& am, const adjacency_lists& mb) {
  adjacency_lists r;
  for (order_index a = 0; a < am.size(); ++a) {
    for (const order_index m : am[a]) r.items.insert(r.items.end(), mb[m].begin(), mb[m].end());
    r.close();
  }
  return r;
}

/// Calls only_in_x(a, b) and only_in_y(a, b) for the elements b of a's ring that only one of x and y contains; either
/// returns false to stop.
template<class InX, class InY>
void compare_sets(const adjacency_lists& x, const adjacency_lists& y, order_index num_b, const InX& only_in_x,
                  const InY& only_in_y) {
  std::vector<order_index> in_x(num_b, no_order_index), in_y(num_b, no_order_index);
  for (order_index a = 0; a < x.size(); ++a) {
    for (const order_index b : x[a]) in_x[b] = a;
    for (const order_index b : y[a]) in_y[b] = a;
    for (const order_index b : x[a])
      if (in_y[b] != a && !only_in_x(a, b)) return;
    for (const order_index b : y[a])
      if (in_x[b] != a && !only_in_y(a, b)) return;
  }
}

/// Checks that adj_b2a is the transpose of adj_a2b.
template<class A, class B>
void check_mirror(const element_table<A>& as, const element_table<B>& bs, const adjacency_lists& ab,
                  const adjacency_lists& ba, const char* law, const char* a2b, const char* b2a, law_log& log) {
  const auto one_sided = [&](const std::string& x, const std::string& y, const char* x2y, const char* y2x) {
    log.add(law, core::joined({x2y, "(", x, ") holds ", y, ", but ", y2x, "(", y, ") does not hold ", x}),
            core::joined({x, " ", y}));
    return !log.full(law);
  };
  compare_sets(
      ab, transposed(ba, as.size()), bs.size(),
      [&](order_index a, order_index b) { return one_sided(as.name(a), bs.name(b), a2b, b2a); },
      [&](order_index a, order_index b) { return one_sided(bs.name(b), as.name(a), b2a, a2b); });
}

/// Checks that each ring of `verb` is, as a set, the result of other adjacencies, called `rule`.
template<class A, class B>
void check_same(const element_table<A>& as, const element_table<B>& bs, const adjacency_lists& listed,
                const adjacency_lists& expected, const char* law, const char* verb, const char* rule, law_log& log) {
  compare_sets(
      listed, expected, bs.size(),
      [&](order_index a, order_index b) {
        log.add(law, core::joined({verb, "(", as.name(a), ") holds ", bs.name(b), ", which is not ", rule}),
                core::joined({as.name(a), " ", bs.name(b)}));
        return !log.full(law);
      },
      [&](order_index a, order_index b) {
        log.add(law, core::joined({verb, "(", as.name(a), ") lacks ", bs.name(b), ", which is ", rule}),
                core::joined({as.name(a), " ", bs.name(b)}));
        return !log.full(law);
      });
}

}  // namespace concino::detail

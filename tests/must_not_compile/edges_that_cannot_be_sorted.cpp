// expect in 10 lines: edges_in_order = false: to sort, adj_p2e needs adj_p2v and adj_e2v, on a surface adj_v2e and adj_e2p too
#include <concino/concepts/mesh_traits.hpp>

struct drawing {};
struct corner { bool operator==(const corner&) const = default; };
struct line { bool operator==(const line&) const = default; };
struct area { bool operator==(const area&) const = default; };
template<class X>
struct list {
  const X* begin() const;
  const X* end() const;
};

template<>
struct concino::mesh_traits<drawing> {
  using vert = corner;
  using edge = line;
  using poly = area;
  static constexpr int dimension = 2;
  static constexpr bool edges_in_order = false;
  static list<line> adj_p2e(const drawing&, area);
};
static_assert(!concino::requirement::can_sort_edges_of_polys<drawing>);

auto refused(const drawing& m, area p) { return concino::adj_p2e(m, p); }

// expect in 10 lines: edges_in_order = false: to sort, adj_f2e needs adj_f2v, adj_e2v, adj_v2e and adj_e2f
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
  using face = area;
  static constexpr int dimension = 3;
  static constexpr bool edges_in_order = false;
  static list<line> adj_f2e(const drawing&, area);
  static list<corner> adj_f2v(const drawing&, area);
  static list<corner> adj_e2v(const drawing&, line);
  static list<line> adj_v2e(const drawing&, corner);
};
static_assert(!concino::requirement::can_sort_edges_of_faces<drawing>);

auto refused(const drawing& m, area f) { return concino::adj_f2e(m, f); }

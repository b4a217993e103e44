// How tables of tets and hexes are built and edited; see cell_tables.hpp.
#pragma once

#include <concino/mesh/cell_tables.hpp>

namespace concino {

template<class Shape, class Lists>
vert_id cell_tables<Shape, Lists>::add_vert(function_ref<void(const detail::index_bounds&)> grow) {
  detail::stage_star(v2v_, v2e_, v2p_);
  verts_.reserve(1);
  if (grow) grow(detail::index_bounds{verts_.bound() + 1, edges_.bound(), faces_.bound(), polys_.bound()});
  detail::add_star(v2v_, v2e_, v2p_);
  return verts_.add();
}

template<class Shape, class Lists>
poly_id cell_tables<Shape, Lists>::add_poly(std::span<const vert_id> corners, function_ref<void(const detail::index_bounds&)> grow) {
  const poly_id p{polys_.bound()};
  if (corners.size() != Shape::verts)
    core::throw_joined<invalid_mesh>({"poly ", p.raw(), " has ", corners.size(), " verts; every poly of this mesh has ", Shape::verts});
  detail::check_new_verts(corners, verts_, "poly", p.raw());
  vert_id c[Shape::verts];
  std::copy_n(corners.begin(), Shape::verts, c);
  edge_id e[Shape::edges];
  std::uint32_t polys_at_edge[Shape::edges], more_edges = 0, more_at[Shape::verts] = {}, crowds = 0;
  std::size_t crowded = 0;
  crowds_.loosen();
  for (unsigned j = 0; j < Shape::edges; ++j) {
    const unsigned a = Shape::edge_vert[j][0], b = Shape::edge_vert[j][1];
    e[j] = detail::edge_between(v2v_, v2e_, c[a], c[b]);
    polys_at_edge[j] = 1;
    if (e[j].is_none()) {
      ++more_edges, ++more_at[a], ++more_at[b];
    } else {
      polys_at_edge[j] += count_polys(e[j]);
      if (is_crowded(e[j])) crowds_.reserve_in_row(crowd_number(e[j]), 1);
      else ++crowds, crowded += polys_at_edge[j];
    }
  }
  face_id* const f = sides_.stage_poly(Shape::faces);
  std::uint32_t more_faces = 0;
  for (unsigned k = 0; k < Shape::faces; ++k) {
    f[k] = face_on(c, k);
    more_faces += f[k].is_none();
  }
  for (unsigned i = 0; i < Shape::verts; ++i) {
    detail::reserve_edges_at(v2v_, v2e_, c[i], more_at[i]);
    v2p_.reserve_in_row(c[i].raw(), 1);
  }
  p2v_.reserve_rows(1);
  p2e_.reserve_rows(1);
  e2v_.reserve_rows(more_edges);
  e2p_.room_for(more_edges);
  if (crowds > 0) crowds_.reserve_rows(crowds, crowded);
  edges_.reserve(more_edges);
  faces_.reserve(more_faces);
  polys_.reserve(1);
  auto scratch = sides_.reserve_links(f, Shape::faces, more_faces);
  if (grow) grow(detail::index_bounds{verts_.bound(), edges_.bound() + more_edges, faces_.bound() + more_faces, polys_.bound() + 1});

  for (unsigned j = 0; j < Shape::edges; ++j)
    if (e[j].is_none()) {
      e[j] = detail::add_edge(edges_, e2v_, v2v_, v2e_, c[Shape::edge_vert[j][0]], c[Shape::edge_vert[j][1]]);
      e2p_.push_back(p.raw());
    }
  p2v_.add_row(c, c + Shape::verts);
  p2e_.add_row(e, e + Shape::edges);
  sides_.commit_poly(Shape::faces);
  for (unsigned k = 0; k < Shape::faces; ++k) {
    face_id side = f[k];
    if (side.is_none()) {
      side = faces_.add();
      sides_.add_facet();
    }
    sides_.link(p.raw(), k, side);
  }
  sides_.remark(p.raw(), std::move(scratch));
  for (const vert_id v : c) v2p_.push(v.raw(), p);
  const poly_id added = polys_.add();
  for (unsigned j = 0; j < Shape::edges; ++j) refan(e[j], polys_at_edge[j]);
  return added;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::reserve_removal(std::span<const poly_id> polys) {
  v2v_.loosen();
  v2e_.loosen();
  v2p_.loosen();
  crowds_.loosen();
  sides_.reserve_removal();
  verts_.reserve_removal();
  edges_.reserve_removal();
  faces_.reserve_removal();
  polys_.reserve_removal();
  std::size_t crowds = 0, crowded = 0;
  for (const poly_id p : polys)
    for (const edge_id e : adj_p2e(p)) ++crowds, crowded += count_polys(e) - 1;
  if (crowds > 0) crowds_.reserve_rows(crowds, crowded);
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::remove_poly(poly_id p) {
  std::uint32_t left[Shape::edges];
  std::size_t crowded = 0;
  for (unsigned j = 0; j < Shape::edges; ++j) crowded += left[j] = count_polys(adj_p2e(p)[j]) - 1;
  reserve_removal({});
  crowds_.reserve_rows(Shape::edges, crowded);
  sides_.unlink(p.raw());
  for (const face_id f : sides_.facets(p))
    if (!sides_.is_owned(f)) faces_.remove(f);
  for (const vert_id v : adj_p2v(p)) v2p_.remove(v.raw(), p);
  polys_.remove(p);
  for (unsigned j = 0; j < Shape::edges; ++j) refan(adj_p2e(p)[j], left[j]);
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::remove_vert(vert_id v) {
  assert(v2p_[v.raw()].empty());
  verts_.reserve_removal();
  verts_.remove(v);
}

template<class Shape, class Lists>
face_id cell_tables<Shape, Lists>::face_on(std::span<const vert_id> corners, unsigned k) const {
  constexpr unsigned n = Shape::face_verts;
  const auto corner = [&](unsigned i) { return corners[Shape::face_vert[k][i % n]]; };
  for (const poly_id q : adj_v2p(corner(0)))
    for (unsigned j = 0; j < Shape::faces; ++j) {
      const auto other = [&](unsigned i) { return p2v_.begin(q.raw())[Shape::face_vert[j][i % n]]; };
      unsigned at = 0;
      while (at < n && other(at) != corner(0)) ++at;
      if (at == n) continue;
      bool along = true, against = true;
      for (unsigned i = 1; i < n; ++i) {
        along = along && corner(i) == other(at + i);
        against = against && corner(i) == other(at + n - i);
      }
      if (along || against) return adj_p2f(q)[j];
    }
  return {};
}

template<class Shape, class Lists>
std::uint32_t cell_tables<Shape, Lists>::count_polys(edge_id e) const {
  std::uint32_t n = 0;
  for_each_poly_at(e, [&](poly_id) { ++n; });
  return n;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::refan(edge_id e, std::uint32_t n) {
  const bool was_crowded = is_crowded(e);
  const std::size_t crowd = was_crowded ? crowd_number(e) : crowds_.size();
  if (was_crowded) crowds_.clear_row(crowd);
  if (n == 0) {
    detail::remove_edge(edges_, e2v_, v2v_, v2e_, e);
    return;
  }
  poly_id first;
  for_each_poly_at(e, [&](poly_id p) { first = first.is_none() ? p : first; });
  e2p_[e.raw()] = first.raw();
  check_fan(e, n);
  if (e2p_[e.raw()] != detail::across::special) return;
  e2p_[e.raw()] |= static_cast<std::uint32_t>(crowd);
  if (!was_crowded) crowds_.add_row(&first, &first, n);
  for_each_poly_at(e, [&](poly_id p) { crowds_.push(crowd, p); });
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::build(std::size_t vert_count) {
  constexpr unsigned nv = Shape::verts;
  const auto poly_count = static_cast<std::uint32_t>(p2v_.size());
  const vert_id* const corner_vert = p2v_.begin(0);

  // Corners by vert; they become the polys of the vert at the end.
  detail::offsets counts(vert_count + 1, 0);
  for (std::uint32_t p = 0; p < poly_count; ++p) {
    if (!are_distinct_verts(p2v_.begin(p), vert_count)) {
      std::vector<std::uint32_t> met;
      detail::check_verts(p2v_[p], vert_count, "poly", p, met);
    }
    for (unsigned i = 0; i < nv; ++i) ++counts[p2v_.begin(p)[i].raw() + 1];
  }
  v2p_ = detail::make_rows<poly_id>(std::move(counts));
  core::flat_array<std::uint32_t> edge_to(vert_count);
  std::copy_n(v2p_.shape()->begin(), vert_count, edge_to.data());
  poly_id* const corners = v2p_.begin(0);
  for (std::size_t c = 0; c < p2v_.num_values(); ++c) corners[edge_to[corner_vert[c].raw()]++] = poly_id{c};

  // Every edge and face is met at its smallest vert a. edge_to[b] is the edge between a and b if that was met at a already. A face is
  // found among those of a at the same edge, the one to the smaller of its two neighbours of a.
  p2e_ = detail::rows<edge_id, Shape::edges>(poly_count, edge_id{});
  sides_ = {detail::rows<face_id, Shape::faces>(poly_count, face_id{}), detail::rows<detail::across, Shape::faces>(poly_count)};
  std::fill_n(edge_to.data(), vert_count, ~0u);
  core::flat_array<vert_id> ends, v2v;
  core::flat_array<edge_id> v2e;
  core::flat_array<std::uint8_t> uses;     // of each edge, by polys; `many` or more
  std::vector<std::uint32_t> faces_to;       // per edge of a: the first of the faces met there whose smaller neighbour it leads to
  std::vector<met_face> met_faces;
  further_faces further;
  std::vector<edge_use> used_often;          // sorted by edge
  const std::size_t guess = std::min(vert_count + (Shape::faces / 2 - 1) * std::size_t{poly_count} + poly_count / 8 + 64, std::size_t{poly_count} * Shape::edges);
  ends.reserve(2 * guess);
  v2v.reserve(2 * guess);
  v2e.reserve(2 * guess);
  e2p_.reserve(guess);
  uses.reserve(guess);
  sides_.reserve_facets(Shape::faces / 2 * std::size_t{poly_count} + poly_count / 8 + 64);
  detail::offsets star(vert_count + 1, 0);
  std::uint32_t edge_count = 0, face_count = 0;
  for (std::uint32_t a = 0; a < vert_count; ++a) {
    const std::uint32_t first_edge = edge_count, first_face = face_count;
    faces_to.clear();
    met_faces.clear();
    further.clear();
    const std::size_t most = std::size_t{valence} * v2p_.length(a);
    vert_id* end = ends.room_for(2 * most);
    vert_id* near = v2v.room_for(most);
    edge_id* near_edge = v2e.room_for(most);
    e2p_.room_for(most);
    uses.room_for(most);
    for (poly_id *c = v2p_.begin(a), *last = c + v2p_.length(a); c != last; ++c) {
      const std::uint32_t p = c->raw() / nv, i = c->raw() % nv;
      const vert_id* const pv = p2v_.begin(p);
      edge_id* const pe = p2e_.begin(p);
      std::uint32_t far[valence], met[valence];  // the neighbours of a in p, and which of the edges of a leads there if they are larger
      for (unsigned j = 0; j < valence; ++j) {
        const std::uint32_t b = far[j] = pv[shape.vert_far[i][j]].raw();
        edge_id& named = pe[shape.vert_edge[i][j]];
        std::uint32_t e = edge_to[b];
        if (b < a) {
          if (e == named.raw()) continue;
          e = edge_to[b] = named.raw();
        } else if (e - first_edge < edge_count - first_edge) {
          met[j] = e - first_edge;
          named = edge_id{e};
          uses.data()[e] += uses.data()[e] < many;
          continue;
        } else {
          e = edge_to[b] = edge_count++;
          met[j] = e - first_edge;
          named = edge_id{e};
          *end++ = vert_id{a};
          *end++ = vert_id{b};
          e2p_.data()[e] = p;
          uses.data()[e] = 1;
          faces_to.push_back(~0u);
        }
        *near++ = vert_id{b};
        *near_edge++ = edge_id{e};
      }
      for (unsigned k = 0; k < valence; ++k) {
        // The neighbours of a in the face, the smaller first, and what lies between them: the same for every poly at the face.
        const std::uint8_t* const along = shape.vert_face_vert[i][k];
        unsigned x = shape.vert_face_edge[i][k][0], y = shape.vert_face_edge[i][k][1];
        if (far[x] < a || far[y] < a) continue;
        if constexpr (Shape::face_verts == 4)
          if (pv[along[1]].raw() < a) continue;
        if (far[x] > far[y]) std::swap(x, y);
        met_face wanted;
        wanted.other[0] = far[y];
        if constexpr (Shape::face_verts == 4) wanted.other[1] = pv[along[1]].raw();
        std::uint32_t& first = faces_to[met[x]];
        std::uint32_t f = first, listed = 0;
        for (; f != ~0u && !std::equal(wanted.other, std::end(wanted.other), met_faces[f].other); ++listed) f = met_faces[f].next;
        if (f == ~0u && listed == longest_list) f = further.find(met[x], wanted, met_faces);
        if (f == ~0u) {
          wanted.next = first;
          if (listed < longest_list) first = static_cast<std::uint32_t>(met_faces.size());
          met_faces.push_back(wanted);
          if (listed == longest_list) further.add(met[x], met_faces);
          sides_.add_facet(p, shape.vert_face[i][k], face_id{face_count++});
        } else {
          sides_.link(p, shape.vert_face[i][k], face_id{first_face + f});
        }
      }
      *c = poly_id{p};
    }
    ends.resize(2 * std::size_t{edge_count});
    e2p_.resize(edge_count);
    uses.resize(edge_count);
    v2v.resize(static_cast<std::size_t>(near - v2v.data()));
    v2e.resize(v2v.size());
    if (v2v.size() >= ~0u) throw unsupported("the mesh has more than 2^32 adjacencies of one kind");
    star[a + 1] = static_cast<std::uint32_t>(v2v.size());
    // All faces at these edges are linked by now, since a is the smallest vert of each or was passed before.
    if (std::find(uses.begin() + first_edge, uses.end(), many) != uses.end()) {
      std::vector<std::uint32_t> polys(edge_count - first_edge);
      for (const poly_id p : v2p_[a])
        for (const edge_id e : adj_p2e(p))
          if (e.raw() - first_edge < polys.size()) ++polys[e.raw() - first_edge];
      for (std::uint32_t e = first_edge; e < edge_count; ++e)
        if (uses[e] == many) used_often.push_back({e, polys[e - first_edge]});
    }
    for (std::uint32_t e = first_edge; e < edge_count; ++e)
      if (uses[e] > 5 && closes_early(edge_id{e}, polys_at(e, uses[e], used_often))) e2p_[e] = detail::across::special;
  }
  ends.give_back_spare_room();
  v2v.give_back_spare_room();
  v2e.give_back_spare_room();
  e2p_.give_back_spare_room();
  e2v_ = detail::rows<vert_id, 2>(std::move(ends));
  v2v_ = {std::make_shared<const detail::offsets>(std::move(star)), std::move(v2v)};
  v2e_ = {v2v_.shape(), std::move(v2e)};
  verts_ = detail::live<vert_id>(vert_count);
  edges_ = detail::live<edge_id>(edge_count);
  faces_ = detail::live<face_id>(face_count);
  polys_ = detail::live<poly_id>(poly_count);

  // What closes_early() takes for granted does not hold at the boundary, in crowds, and of polys that share two faces.
  // Each edge is checked once, though each of its many faces comes by.
  const auto check = [&](edge_id e) {
    const std::uint8_t met = std::exchange(uses.data()[e.raw()], 0);
    if (met > 0 && !is_crowded(e)) check_fan(e, polys_at(e.raw(), met, used_often));
  };
  sides_.finish();
  for (std::uint32_t f = 0; f < face_count; ++f)
    if (!sides_.has_two_polys_once(face_id{f}))
      for (const edge_id e : adj_f2e(face_id{f})) check(e);
  crowd_edges();
}

template<class Shape, class Lists>
bool cell_tables<Shape, Lists>::are_distinct_verts(const vert_id* v, std::size_t vert_count) {
  bool good = v[0].raw() < vert_count;
  for (unsigned i = 1; i < Shape::verts; ++i) {
    good &= v[i].raw() < vert_count;
    for (unsigned j = 0; j < i; ++j) good &= v[i] != v[j];
  }
  return good;
}

template<class Shape, class Lists>
std::uint32_t cell_tables<Shape, Lists>::polys_at(std::uint32_t e, std::uint8_t met, const std::vector<edge_use>& used_often) {
  if (met != many) return met;
  return std::lower_bound(used_often.begin(), used_often.end(), e, [](const edge_use& x, std::uint32_t y) { return x.edge < y; })->polys;
}

template<class Shape, class Lists>
bool cell_tables<Shape, Lists>::closes_early(edge_id e, std::uint32_t n) const {
  const poly_id first = first_poly(e);
  poly_id p = first;
  std::uint32_t by = faces_at(p, e)[0];
  for (std::uint32_t steps = 3; steps < n; ++steps) {
    const poly_id next = across(p, by);
    if (next.is_none()) return false;
    if (next == first) return true;
    const face_id f = adj_p2f(p)[by];
    const auto two = faces_at(next, e);
    by = adj_p2f(next)[two[0]] == f ? two[1] : two[0];
    p = next;
  }
  return across(p, by) == first;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::check_fan(edge_id e, std::uint32_t uses) {
  std::uint32_t n = 0;
  const auto around = adj_e2p(e);
  for (auto it = around.begin(), last = around.end(); it != last; ++it) ++n;
  if (n != uses) e2p_[e.raw()] = detail::across::special;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::crowd_edges() {
  std::uint32_t num = 0;
  for (std::uint32_t *e = e2p_.data(), *last = e + e2p_.size(); e != last; ++e)
    if (*e & detail::across::special) *e = detail::across::special | num++;
  if (num == 0) return;
  const auto for_each_use = [&](auto&& use) {
    for (std::size_t p = 0; p < p2e_.size(); ++p)
      for (const edge_id e : p2e_[p])
        if (is_crowded(e)) use(crowd_number(e), poly_id{p});
  };
  detail::offsets sizes(num + std::size_t{1}, 0);
  for_each_use([&](std::size_t crowd, poly_id) { ++sizes[crowd + 1]; });
  crowds_ = detail::make_rows<poly_id>(std::move(sizes));
  detail::offsets next(crowds_.shape()->begin(), crowds_.shape()->end() - 1);
  poly_id* const polys = crowds_.begin(0);
  for_each_use([&](std::size_t crowd, poly_id p) { polys[next[crowd]++] = p; });
}

#ifdef CONCINO_COMPILED
#define CONCINO_DEFINE_CELL_TABLES(TABLES)                                                                         \
  template vert_id TABLES::add_vert(function_ref<void(const detail::index_bounds&)>);                              \
  template poly_id TABLES::add_poly(std::span<const vert_id>, function_ref<void(const detail::index_bounds&)>);    \
  template void TABLES::reserve_removal(std::span<const poly_id>);                                                 \
  template void TABLES::remove_poly(poly_id);                                                                      \
  template void TABLES::remove_vert(vert_id);                                                                      \
  template void TABLES::build(std::size_t)
CONCINO_DEFINE_CELL_TABLES(cell_tables<detail::tet_shape>);
CONCINO_DEFINE_CELL_TABLES(cell_tables<detail::hex_shape>);
#undef CONCINO_DEFINE_CELL_TABLES
#endif

}  // namespace concino

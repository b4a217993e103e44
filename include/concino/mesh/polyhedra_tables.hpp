// All adjacencies of a mesh of general polyhedra in flat arrays, built in linear time from faces (lists of verts) and polys (lists of faces).
// Derived by the way: edges of a face (from its verts), polys around an edge and faces at a vert (from the faces at edges).
#pragma once

#include <concino/core/message.hpp>
#include <concino/mesh/detail/checks.hpp>
#include <concino/mesh/detail/polyhedra_ranges.hpp>
#include <concino/mesh/detail/stars.hpp>

#include <numeric>

namespace concino {

/// Lists: where the verts of faces are read; rows of these tables' own, which can be edited, or lists in somebody else's array.
template<class Lists>
class basic_polyhedra_tables {
  template<class> friend class basic_polyhedra_tables;
  template<class T> using ragged = detail::rows<T, 0>;

  detail::live<vert_id> verts_;
  detail::live<edge_id> edges_;
  detail::live<face_id> faces_;
  detail::live<poly_id> polys_;
  Lists f2v_;
  ragged<vert_id> p2v_, v2v_;
  ragged<edge_id> v2e_, p2e_;
  ragged<face_id> e2f_;
  ragged<poly_id> v2p_;
  detail::sides<face_id, 0> sides_;
  detail::row_places face_places_;  // of verts in faces of many
  ragged<std::uint8_t> outward_;  // parallel to the faces of each poly
  detail::rows<vert_id, 2> e2v_;

 public:
  basic_polyhedra_tables() = default;
  basic_polyhedra_tables(const basic_polyhedra_tables&) = default;
  basic_polyhedra_tables(basic_polyhedra_tables&&) noexcept = default;
  basic_polyhedra_tables& operator=(const basic_polyhedra_tables& o) { return *this = basic_polyhedra_tables(o); }  // all or nothing
  basic_polyhedra_tables& operator=(basic_polyhedra_tables&&) noexcept = default;

  /// From the verts of every face in cyclic order, the faces of every poly, and whether each face is wound outward there.
  /// Errors: invalid_mesh that names the face or poly with a bad or repeated vert or face; unsupported if faces of many verts belong to so
  ///         many polys that the adjacencies would be far longer than these lists.
  basic_polyhedra_tables(std::size_t vert_count, std::vector<std::uint32_t> face_offsets, std::vector<vert_id> face_verts,
                         std::vector<std::uint32_t> poly_offsets, std::vector<face_id> poly_faces, std::vector<std::uint8_t> outward)
      : f2v_(detail::checked_rows(std::move(face_offsets), std::move(face_verts), "face")) {
    const ragged<face_id> given = detail::checked_rows(std::move(poly_offsets), std::move(poly_faces), "poly");
    if (outward.size() != given.num_values())
      core::throw_joined<invalid_mesh>({outward.size(), " outward flags were given for ", given.num_values(), " faces of polys; each needs one"});
    detail::drop_spare_room(outward);
    outward_ = {given.shape(), std::move(outward)};
    build(vert_count, given, check(vert_count, given));
  }
  /// The same for faces that are listed elsewhere, with what was built of a copy of those lists.
  basic_polyhedra_tables(basic_polyhedra_tables<ragged<vert_id>>&& built, Lists elsewhere)
    requires(!std::same_as<Lists, ragged<vert_id>>)
      : verts_(std::move(built.verts_)), edges_(std::move(built.edges_)), faces_(std::move(built.faces_)), polys_(std::move(built.polys_)),
        f2v_(std::move(elsewhere)), p2v_(std::move(built.p2v_)), v2v_(std::move(built.v2v_)), v2e_(std::move(built.v2e_)),
        p2e_(std::move(built.p2e_)), e2f_(std::move(built.e2f_)), v2p_(std::move(built.v2p_)), sides_(std::move(built.sides_)),
        face_places_(std::move(built.face_places_)), outward_(std::move(built.outward_)), e2v_(std::move(built.e2v_)) {}

  const detail::live<vert_id>& verts() const { return verts_; }
  const detail::live<edge_id>& edges() const { return edges_; }
  const detail::live<face_id>& faces() const { return faces_; }
  const detail::live<poly_id>& polys() const { return polys_; }

  id_span<vert_id> adj_v2v(vert_id v) const { return v2v_[v.raw()]; }
  id_span<edge_id> adj_v2e(vert_id v) const { return v2e_[v.raw()]; }
  detail::faces_at_edges<basic_polyhedra_tables> adj_v2f(vert_id v) const { return {this, v}; }
  id_span<poly_id> adj_v2p(vert_id v) const { return v2p_[v.raw()]; }
  id_span<vert_id> adj_e2v(edge_id e) const { return e2v_[e.raw()]; }
  id_span<face_id> adj_e2f(edge_id e) const { return e2f_[e.raw()]; }
  detail::polys_of_faces<basic_polyhedra_tables> adj_e2p(edge_id e) const { return {this, adj_e2f(e)}; }
  auto adj_f2v(face_id f) const { return f2v_[f.raw()]; }
  auto adj_f2e(face_id f) const { return detail::edges_between(this, adj_f2v(f)); }
  detail::polys_of_facet adj_f2p(face_id f) const { return sides_.polys_of(f); }
  id_span<vert_id> adj_p2v(poly_id p) const { return p2v_[p.raw()]; }
  id_span<edge_id> adj_p2e(poly_id p) const { return p2e_[p.raw()]; }
  id_span<face_id> adj_p2f(poly_id p) const { return sides_.facets(p); }
  detail::polys_across adj_p2p(poly_id p) const { return sides_.polys(p); }

  bool face_is_outward(poly_id p, face_id f) const {
    const std::uint32_t k = sides_.side_of(p, f);
    return k < outward_.length(p.raw()) && outward_.begin(p.raw())[k] != 0;
  }

  // Edits find their memory first, which changes nothing, and then cannot fail: each is done as a whole or not at all. `grow` is called in
  // between, with the bounds of indices that the edit leads to; it may fail too.

  /// A vert without edges.
  template<class Grow = detail::nothing_else_grows>
  vert_id add_vert(const Grow& grow = {}) {
    detail::stage_star(v2v_, v2e_, v2p_);
    verts_.reserve(1);
    grow(detail::index_bounds{verts_.bound() + 1, edges_.bound(), faces_.bound(), polys_.bound()});
    detail::add_star(v2v_, v2e_, v2p_);
    return verts_.add();
  }

  /// A face on verts that are there, of no poly yet. A second face on the same verts is another face.
  /// Errors: invalid_mesh as in the constructor; nothing has changed then.
  template<class Grow = detail::nothing_else_grows>
  face_id add_face(std::span<const vert_id> corners, const Grow& grow = {}) {
    const face_id f{faces_.bound()};
    detail::check_new_verts(corners, verts_, "face", f.raw());
    const std::size_t n = corners.size();
    const vert_id* const c = f2v_.stage_row(corners.data(), n);  // corners may have lain in a row that moved
    const auto next = [&](std::size_t i) { return c[i + 1 == n ? 0 : i + 1]; };
    bool last_is_new = edge_between(c[n - 1], c[0]).is_none();
    std::size_t more = 0;
    e2f_.loosen();
    for (std::size_t i = 0; i < n; ++i) {
      const edge_id e = edge_between(c[i], next(i));
      if (!e.is_none()) e2f_.reserve_in_row(e.raw(), 1);
      detail::reserve_edges_at(v2v_, v2e_, c[i], (e.is_none() ? 1u : 0u) + (last_is_new ? 1u : 0u));
      last_is_new = e.is_none();
      more += last_is_new;
    }
    e2f_.reserve_rows(more, more * faces_of_new_edge);
    e2v_.reserve_rows(more);
    edges_.reserve(more);
    faces_.reserve(1);
    sides_.reserve_links(nullptr, 0, 1);
    grow(detail::index_bounds{verts_.bound(), edges_.bound() + more, faces_.bound() + 1, polys_.bound()});

    f2v_.commit_row(n);
    sides_.add_facet();
    for (std::size_t i = 0; i < n; ++i) {
      edge_id e = edge_between(c[i], next(i));
      if (e.is_none()) {
        e = detail::add_edge(edges_, e2v_, v2v_, v2e_, c[i], next(i));
        e2f_.add_row(&f, &f, faces_of_new_edge);
      }
      e2f_.push(e.raw(), f);
    }
    return faces_.add();
  }

  /// A poly of faces that are there; outward[k] as in the constructor. Cost: at most the square of the corners of its faces.
  /// Errors: invalid_mesh as in the constructor; nothing has changed then.
  template<class Grow = detail::nothing_else_grows>
  poly_id add_poly(std::span<const face_id> list, std::span<const std::uint8_t> outward, const Grow& grow = {}) {
    const poly_id p{polys_.bound()};
    const std::string name = core::joined({"poly ", p.raw()});
    if (list.empty() || list.size() != outward.size()) core::throw_joined<invalid_mesh>({name, " needs at least one face and an outward flag for each"});
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (!faces_.contains(list[k])) core::throw_joined<invalid_mesh>({name, " names face ", list[k].raw(), ", which is not a face of the mesh"});
      if (std::find(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(k), list[k]) != list.begin() + static_cast<std::ptrdiff_t>(k))
        core::throw_joined<invalid_mesh>({name, " has face ", list[k].raw(), " twice; its faces must differ"});
    }
    const auto n = static_cast<std::uint32_t>(list.size());
    const face_id* const faces = sides_.stage_poly(n, list.data());  // list may have lain in a row that moved
    outward_.stage_row(outward.data(), n);
    std::vector<vert_id> corners;
    std::vector<edge_id> around;
    for (std::uint32_t k = 0; k < n; ++k) {
      for (const vert_id v : adj_f2v(faces[k]))
        if (std::find(corners.begin(), corners.end(), v) == corners.end()) corners.push_back(v);
      for (const edge_id e : adj_f2e(faces[k]))
        if (std::find(around.begin(), around.end(), e) == around.end()) around.push_back(e);
    }
    p2v_.stage_row(corners.data(), corners.size());
    p2e_.stage_row(around.data(), around.size());
    for (const vert_id v : corners) v2p_.reserve_in_row(v.raw(), 1);
    polys_.reserve(1);
    auto scratch = sides_.reserve_links(faces, n, 0);
    grow(detail::index_bounds{verts_.bound(), edges_.bound(), faces_.bound(), polys_.bound() + 1});

    sides_.commit_poly(n);
    outward_.commit_row(n);
    p2v_.commit_row(corners.size());
    p2e_.commit_row(around.size());
    for (std::uint32_t k = 0; k < n; ++k) sides_.link(p.raw(), k, faces[k]);
    for (const vert_id v : corners) v2p_.push(v.raw(), p);
    sides_.remark(p.raw(), std::move(scratch));
    return polys_.add();
  }

  /// Finds the memory that removing these polys one after another, and faces and verts that no poly has any more, takes: none of it can fail then.
  void reserve_removal(std::span<const poly_id>) {
    v2v_.loosen();
    v2e_.loosen();
    v2p_.loosen();
    e2f_.loosen();
    sides_.reserve_removal();
    verts_.reserve_removal();
    edges_.reserve_removal();
    faces_.reserve_removal();
    polys_.reserve_removal();
  }

  /// Takes p away, and with it the faces that no other poly has and the edges that no other face has; verts stay. No other element changes
  /// its name.
  void remove_poly(poly_id p) {
    reserve_removal({&p, 1});
    sides_.unlink(p.raw());
    for (const vert_id v : adj_p2v(p)) v2p_.remove(v.raw(), p);
    polys_.remove(p);
    for (const face_id f : sides_.facets(p))
      if (!sides_.is_owned(f)) remove_face(f);
  }

  /// Takes away a face that no poly has.
  void remove_face(face_id f) {
    assert(!sides_.is_owned(f));
    reserve_removal({});
    const id_span<vert_id> corners = adj_f2v(f);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const edge_id e = edge_between(corners[i], corners[i + 1 == corners.size() ? 0 : i + 1]);
      e2f_.remove(e.raw(), f);
      if (adj_e2f(e).empty()) detail::remove_edge(edges_, e2v_, v2v_, v2e_, e);
    }
    faces_.remove(f);
  }

  /// Takes away a vert that no poly has any more, and faces at it that no poly has either.
  void remove_vert(vert_id v) {
    assert(v2p_[v.raw()].empty());
    reserve_removal({});
    while (!adj_v2e(v).empty()) remove_face(adj_e2f(adj_v2e(v)[0])[0]);
    verts_.remove(v);
  }

  // What the ranges above look up with.
  edge_id edge_between(vert_id a, vert_id b) const {
    const auto [smaller, larger] = std::minmax({a, b});
    if (v2v_.length(larger.raw()) > detail::row_places::longest_scan) [[unlikely]]
      if (const edge_id e = edge_to_smaller(larger, smaller); !e.is_none()) return e;
    return detail::edge_between(v2v_, v2e_, larger, smaller);
  }
  vert_id next_in_face(face_id f, vert_id v) const {
    const auto corners = adj_f2v(f);
    const std::size_t n = corners.size();
    std::size_t i = 0;
    if (n > detail::row_places::longest_scan) [[unlikely]] i = face_places_.find(f.raw(), corners, v);
    else
      while (i < n && corners[i] != v) ++i;
    return i == n ? vert_id{} : corners[i + 1 == n ? 0 : i + 1];
  }

 private:
  static constexpr std::size_t faces_of_new_edge = 4;  // what there is room for

  /// Result: the verts of the faces of all polys, a face counted for every poly that has it.
  std::size_t check(std::size_t vert_count, const ragged<face_id>& polys) const {
    detail::check_counts(vert_count, polys.size(), f2v_.num_values());
    std::vector<std::uint32_t> met;
    for (std::size_t f = 0; f < f2v_.size(); ++f) detail::check_verts(f2v_[f], vert_count, "face", f, met);
    met.assign(f2v_.size(), ~0u);
    std::size_t poly_corners = 0;
    for (std::size_t p = 0; p < polys.size(); ++p) {
      if (polys.length(p) == 0) core::throw_joined<invalid_mesh>({"poly ", p, " has no faces; it needs at least 1"});
      for (const face_id f : polys[p]) {
        if (f.raw() >= f2v_.size())
          core::throw_joined<invalid_mesh>({"poly ", p, " names face ", f.raw(), ", but the mesh has ", f2v_.size(), " faces, numbered from 0"});
        if (met[f.raw()] == p) core::throw_joined<invalid_mesh>({"poly ", p, " has face ", f.raw(), " twice; its faces must differ"});
        met[f.raw()] = static_cast<std::uint32_t>(p);
        poly_corners += f2v_.length(f.raw());
      }
    }
    check_poly_corners(poly_corners, f2v_.num_values(), polys.num_values());
    return poly_corners;
  }

  /// The smaller neighbours of a vert come before the larger, and ascend, until edges are added or removed there.
  [[gnu::noinline]] edge_id edge_to_smaller(vert_id v, vert_id smaller) const {
    const id_span<vert_id> near = v2v_[v.raw()];
    const vert_id* const at = std::lower_bound(near.begin(), near.end(), smaller);
    return at != near.end() && *at == smaller ? v2e_.begin(v.raw())[at - near.begin()] : edge_id{};
  }

  void build(std::size_t vert_count, const ragged<face_id>& polys, std::size_t poly_corners) {
    face_places_ = detail::row_places(f2v_);
    core::flat_array<edge_id> f2e(f2v_.num_values());  // parallel to f2v_
    core::flat_array<std::uint32_t> scratch = build_edges(vert_count, f2e);
    const std::size_t edge_count = e2v_.size();

    detail::offsets counts(edge_count + 1, 0);
    for (const edge_id e : f2e) ++counts[e.raw() + 1];
    e2f_ = detail::make_rows<face_id>(std::move(counts));
    {
      core::flat_array<std::uint32_t> next(edge_count);
      std::copy_n(e2f_.shape()->begin(), edge_count, next.data());
      face_id* const faces = e2f_.begin(0);
      const edge_id* e = f2e.begin();
      for (std::size_t f = 0; f < f2v_.size(); ++f)
        for (std::uint32_t n = f2v_.length(f); n > 0; --n) faces[next[(e++)->raw()]++] = face_id{f};
    }

    sides_ = {{polys.shape(), core::flat_array<face_id>(polys.num_values(), face_id{})}, {polys.shape(), core::flat_array<detail::across>(polys.num_values())}};
    sides_.set_facets(f2v_.size());
    core::flat_array<detail::sides<face_id, 0>::side> met_first(f2v_.size());
    for (std::uint32_t p = 0; p < polys.size(); ++p)
      for (std::uint32_t k = 0; k < polys.length(p); ++k) {
        const face_id f = polys.begin(p)[k];
        if (sides_.is_owned(f)) {
          sides_.link(p, k, f, met_first[f.raw()]);
        } else {
          met_first[f.raw()] = {p, k};
          sides_.link(p, k, f);
        }
      }
    sides_.finish();

    build_corners(vert_count, f2e, std::move(scratch), poly_corners);
    verts_ = detail::live<vert_id>(vert_count);
    edges_ = detail::live<edge_id>(edge_count);
    faces_ = detail::live<face_id>(f2v_.size());
    polys_ = detail::live<poly_id>(polys.size());
  }

  /// Edges as in a surface whose polys are the faces; f2e[i] is the edge that begins at the i-th corner. Returns scratch of one number a vert.
  core::flat_array<std::uint32_t> build_edges(std::size_t vert_count, core::flat_array<edge_id>& f2e) {
    const std::size_t corner_count = f2v_.num_values();
    core::flat_array<std::uint32_t> first(vert_count + 1, 0), edge_to(vert_count);
    // Corners by the smaller end of the edge that leaves them, with the other end beside.
    struct half { std::uint32_t corner, far; };
    const auto for_each_half = [&](auto&& use) {
      std::uint32_t c = 0;
      for (std::size_t f = 0; f < f2v_.size(); ++f) {
        const id_span<vert_id> v = f2v_[f];
        for (std::size_t i = 0; i < v.size(); ++i, ++c) {
          const std::uint32_t a = v[i].raw(), b = v[i + 1 == v.size() ? 0 : i + 1].raw();
          use(c, std::min(a, b), std::max(a, b));
        }
      }
    };
    for_each_half([&](std::uint32_t, std::uint32_t a, std::uint32_t) { ++first[a + 1]; });
    std::partial_sum(first.begin(), first.end(), first.data());
    core::flat_array<half> halves(corner_count);
    std::copy_n(first.begin(), vert_count, edge_to.data());
    for_each_half([&](std::uint32_t c, std::uint32_t a, std::uint32_t b) { halves[edge_to[a]++] = {c, b}; });

    std::fill_n(edge_to.data(), vert_count, ~0u);
    core::flat_array<vert_id> ends;
    ends.reserve(corner_count * 2 / 3);
    detail::offsets degrees(vert_count + 1, 0);
    std::uint32_t num = 0;
    for (std::uint32_t a = 0; a < vert_count; ++a) {
      const std::uint32_t first_edge = num;
      for (std::uint32_t i = first[a]; i < first[a + 1]; ++i) {
        std::uint32_t e = edge_to[halves[i].far];
        if (e == ~0u || e < first_edge) {
          edge_to[halves[i].far] = e = num++;
          ends.push_back(vert_id{a});
          ends.push_back(vert_id{halves[i].far});
          ++degrees[a + 1];
          ++degrees[halves[i].far + 1];
        }
        f2e[halves[i].corner] = edge_id{e};
      }
    }
    ends.give_back_spare_room();
    e2v_ = detail::rows<vert_id, 2>(std::move(ends));
    detail::fill_stars(std::move(degrees), e2v_, edge_to, v2v_, v2e_);
    return edge_to;
  }

  /// Verts and edges of every poly, in the order in which its faces meet them, and polys of every vert.
  void build_corners(std::size_t vert_count, const core::flat_array<edge_id>& f2e, core::flat_array<std::uint32_t> vert_met, std::size_t poly_corners) {
    const std::size_t poly_count = sides_.num_polys();
    const vert_id* const corner_vert = f2v_.begin(0);
    core::flat_array<std::uint32_t> edge_met(e2v_.size(), ~0u);
    std::fill_n(vert_met.data(), vert_count, ~0u);

    // In a closed poly every edge is met twice, and verts and faces are two more than edges: room that most meshes fill exactly.
    const std::size_t sides = outward_.num_values();
    core::flat_array<vert_id> verts;
    core::flat_array<edge_id> edges;
    edges.reserve(poly_corners / 2);
    if (poly_corners / 2 + 2 * poly_count > sides) verts.reserve(poly_corners / 2 + 2 * poly_count - sides);

    detail::offsets v_first{0}, e_first{0}, degrees(vert_count + 1, 0);
    v_first.reserve(poly_count + 1);
    e_first.reserve(poly_count + 1);
    for (std::uint32_t p = 0; p < poly_count; ++p) {
      for (const face_id f : sides_.facets(poly_id{p})) {
        const auto at = static_cast<std::size_t>(f2v_.begin(f.raw()) - corner_vert);
        for (std::size_t c = at; c < at + f2v_.length(f.raw()); ++c) {
          const vert_id v = corner_vert[c];
          const edge_id e = f2e[c];
          if (vert_met[v.raw()] != p) {
            vert_met[v.raw()] = p;
            verts.push_back(v);
            ++degrees[v.raw() + 1];
          }
          if (edge_met[e.raw()] != p) {
            edge_met[e.raw()] = p;
            edges.push_back(e);
          }
        }
      }
      v_first.push_back(static_cast<std::uint32_t>(verts.size()));
      e_first.push_back(static_cast<std::uint32_t>(edges.size()));
    }
    if (edges.size() >= ~0u) throw unsupported("the mesh has more than 2^32 adjacencies of one kind");
    verts.give_back_spare_room();
    edges.give_back_spare_room();
    p2v_ = {std::make_shared<const detail::offsets>(std::move(v_first)), std::move(verts)};
    p2e_ = {std::make_shared<const detail::offsets>(std::move(e_first)), std::move(edges)};

    v2p_ = detail::make_rows<poly_id>(std::move(degrees));
    std::copy_n(v2p_.shape()->begin(), vert_count, vert_met.data());
    poly_id* const polys = v2p_.begin(0);
    for (std::uint32_t p = 0; p < poly_count; ++p)
      for (const vert_id v : p2v_[p]) polys[vert_met[v.raw()]++] = poly_id{p};
    if (*v2p_.shape() == *v2v_.shape()) v2p_.share_shape(v2v_);
  }
};

using polyhedra_tables = basic_polyhedra_tables<detail::rows<vert_id, 0>>;

}  // namespace concino

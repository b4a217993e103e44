// Every operator of edits compiles on the archetype of the concept that it names, and edits the mesh to which the archetype refers as it edits the mesh itself.
#include <concino/concepts/archetypes.hpp>
#include <concino/edit.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/mesh.hpp>
#include <concino/remesh.hpp>

#include <support/soups.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <type_traits>
#include <vector>

namespace cn = concino;
using cn::testing::whole;

namespace {

template<class M> using archetype_of = decltype(cn::only_editable_mesh(std::declval<M&>()));
template<class A>
constexpr bool is_editable_and_no_more = cn::EditableMesh<A> && cn::MutablePoints<A> && !cn::requirement::has_add_vert<A> && !cn::requirement::has_remove_vert<A> &&
    !cn::requirement::has_add_poly<A> && !cn::requirement::has_remove_poly<A> && !cn::requirement::has_garbage_collect<A> && !cn::requirement::has_edits<A> &&
    !cn::HasProperties<A>;
static_assert(is_editable_and_no_more<archetype_of<cn::trimesh>> && is_editable_and_no_more<archetype_of<cn::tetmesh>>);
static_assert(cn::arity_v<archetype_of<cn::trimesh>> == 3 && cn::arity_v<archetype_of<cn::tetmesh>> == 4);  // see cavity
static_assert(cn::EditableSurfaceMesh<archetype_of<cn::trimesh>> && !cn::EditableVolumeMesh<archetype_of<cn::trimesh>>);
static_assert(cn::EditableVolumeMesh<archetype_of<cn::tetmesh>> && !cn::EditableSurfaceMesh<archetype_of<cn::tetmesh>>);
template<class M> concept strips_temporary = requires { cn::only_editable_mesh(std::declval<M>()); };
template<class M> concept strips_to_volume = requires(M& m) { cn::only_editable_volume_mesh(m); };
template<class M> concept strips_to_surface = requires(M& m) { cn::only_editable_surface_mesh(m); };
static_assert(strips_to_volume<cn::tetmesh> && !strips_to_volume<cn::trimesh> && strips_to_surface<cn::trimesh> && !strips_to_surface<cn::hexmesh>);
template<class M> concept strips_const = requires(const M& m) { cn::only_editable_mesh(m); };
static_assert(!strips_temporary<cn::trimesh> && !strips_const<cn::trimesh>);

template<class M>
auto named(const M&, cn::vert_id x) { return x; }
template<class M>
auto named(const M&, cn::edge_id x) { return x; }
template<class M>
auto named(const M&, cn::face_id x) { return x; }
template<class M>
auto named(const M&, cn::poly_id x) { return x; }
template<class M>
auto named(const cn::archetypes::editable<M>& a, cn::vert_id x) { return a.vert(x); }
template<class M>
auto named(const cn::archetypes::editable<M>& a, cn::edge_id x) { return a.edge(x); }
template<class M>
auto named(const cn::archetypes::editable<M>& a, cn::face_id x) { return a.face(x); }
template<class M>
auto named(const cn::archetypes::editable<M>& a, cn::poly_id x) { return a.poly(x); }

/// Edits m by `edit`, and another copy through the archetype, and compares both.
template<class M, class Edit>
void edits_alike(const M& start, const Edit& edit) {
  M m = start, other = start;
  auto a = cn::only_editable_mesh(other);
  const cn::permission made = edit(m), through = edit(a);
  CHECK(made.reason == through.reason);
  CHECK(made);
  CHECK(whole(m) == whole(other));
  CHECK(whole(m) != whole(start));
}

/// The options of an edit with every invariant.
template<class M>
std::vector<cn::invariant> all_invariants(const M& m) {
  const auto none = [](const auto&) { return false; };
  std::vector<cn::invariant> keep{cn::no_inversion, cn::min_quality(1e-6), cn::protect_edges(m, none), cn::keep_labels(m, [](const auto&) { return 0; })};
  if constexpr (cn::VolumeMesh<M>) keep.push_back(cn::protect_faces(m, none));
  return keep;
}

/// The first edge that can be collapsed.
template<class M>
cn::edge_id collapsible(const M& m) {
  for (const auto e : cn::edges(m))
    if (cn::can_edge_collapse(m, e)) return e;
  return {};
}

}  // namespace

TEST_CASE_TEMPLATE("editable archetypes: operators on meshes of any dimension", M, cn::trimesh, cn::tetmesh) {
  const M start = cn::testing::grid<M>(cn::dimension_v<M> == 2 ? 4 : 2);
  const cn::edge_id e = collapsible(start);
  const cn::poly_id p{3};
  edits_alike(start, [&](auto& m) -> cn::permission {
    CHECK(cn::can_edge_split(m, named(m, e), 0.5, {.keep = all_invariants(m)}));
    return cn::edge_split(m, named(m, e), 0.5, {.keep = all_invariants(m)});
  });
  edits_alike(start, [&](auto& m) -> cn::permission {
    CHECK(cn::can_edge_collapse(m, named(m, e)));
    return cn::edge_collapse(m, named(m, e));
  });
  edits_alike(start, [&](auto& m) -> cn::permission {
    CHECK(cn::can_poly_split(m, named(m, p)));
    return cn::poly_split(m, named(m, p));
  });
  edits_alike(start, [&](auto& m) {
    cn::flip_winding(m, named(m, p));
    cn::flip_winding(m);
    return cn::permission{};
  });
  edits_alike(start, [&](auto& m) -> cn::permission {
    const auto v = named(m, cn::end_verts(start, e).first);
    std::vector<cn::poly_t<std::remove_cvref_t<decltype(m)>>> moved;
    if constexpr (cn::dimension_v<M> == 3) {
      for (const auto q : cn::adj_e2p(m, named(m, e))) moved.push_back(q);
    } else {
      for (const auto q : cn::adj_v2p(m, v))
        if (moved.empty()) moved.push_back(q);
    }
    CHECK(cn::can_vert_split(m, v, moved, {0.1, 0.2, 0.3}));
    return cn::vert_split(m, v, moved, {0.1, 0.2, 0.3});
  });
}

TEST_CASE_TEMPLATE("editable archetypes: merging and splitting of verts", M, cn::trimesh, cn::tetmesh, cn::polyhedralmesh) {
  const M start = cn::testing::grid<M>(3);
  const cn::vert_id first{0}, last(cn::num_verts(start) - 1);
  edits_alike(start, [&](auto& m) -> cn::permission {
    CHECK(cn::can_merge_verts(m, named(m, first), {named(m, last)}));
    const auto made = cn::merge_verts(m, named(m, first), {named(m, last)});
    CHECK(cn::split_vert_fans(m, named(m, first)).size() == 1);
    CHECK(cn::split_vert_fans(m).empty());
    return made;
  });
}

TEST_CASE("editable archetypes: polygons and polyhedra") {
  const auto surface = cn::testing::grid<cn::polygonmesh>(3);
  const cn::poly_id p{0};
  const auto corner = [](const auto& m, const auto& x, std::size_t k) {
    auto i = cn::adj_p2v(m, x).begin();
    for (; k > 0; --k) ++i;
    return *i;
  };
  const auto cut = [&](auto& m) { return cn::poly_cut(m, named(m, p), corner(m, named(m, p), 1), corner(m, named(m, p), 4)); };
  edits_alike(surface, [&](auto& m) -> cn::permission {
    CHECK(cn::can_poly_cut(m, named(m, p), corner(m, named(m, p), 1), corner(m, named(m, p), 4)));
    return cut(m);
  });
  edits_alike(surface, [&](auto& m) -> cn::permission {
    const auto made = cut(m);
    CHECK(cn::can_merge_polys(m, made.edge));
    cn::merge_polys(m, made.edge);
    return cn::merge_polys(m, *cn::adj_p2e(m, named(m, cn::poly_id{1})).begin());
  });
  const auto volume = cn::testing::grid<cn::polyhedralmesh>(1);
  const auto in_both = [&](const auto& start) {
    edits_alike(start, [&](auto& m) -> cn::permission {
      const auto made = cn::edge_split(m, named(m, cn::edge_id{0}));
      CHECK(cn::can_edge_merge(m, made.vert));
      cn::edge_merge(m, made.vert);
      return cn::edge_split(m, named(m, cn::edge_id{0}));
    });
    edits_alike(start, [&](auto& m) -> cn::permission { return cn::edge_collapse(m, named(m, collapsible(start)), {.keep = {cn::no_inversion}}); });
    edits_alike(start, [&](auto& m) -> cn::permission {
      const auto all = cn::make_poly_map<int>(m, 0);
      return cn::merge_polys(m, all);
    });
  };
  in_both(surface);
  in_both(volume);
  edits_alike(volume, [&](auto& m) -> cn::permission {
    const auto f = *cn::adj_p2f(m, named(m, cn::poly_id{1})).begin();
    std::vector<cn::vert_t<std::remove_cvref_t<decltype(m)>>> v;
    for (const auto x : cn::adj_f2v(m, f)) v.push_back(x);
    CHECK(cn::can_face_cut(m, f, v[0], v[2]));
    const auto made = cn::face_cut(m, f, v[0], v[2]);
    CHECK(cn::can_face_merge(m, made.faces[0], made.faces[1]));
    cn::face_merge(m, made.faces[0], made.faces[1]);
    std::vector<cn::edge_t<std::remove_cvref_t<decltype(m)>>> loop;
    for (const auto e : cn::adj_f2e(m, *cn::adj_p2f(m, named(m, cn::poly_id{0})).begin())) loop.push_back(e);
    CHECK_FALSE(cn::can_poly_cut(m, named(m, cn::poly_id{0}), loop));
    CHECK_FALSE(cn::poly_cut(m, named(m, cn::poly_id{0}), loop));
    return cn::face_cut(m, *cn::adj_p2f(m, named(m, cn::poly_id{1})).begin(), v[1], v[3]);
  });
}

TEST_CASE("editable archetypes: flips") {
  const auto surface = cn::testing::grid<cn::trimesh>(3);
  cn::edge_id e{0};
  while (!cn::can_edge_flip(surface, e)) e = cn::edge_id(e.raw() + 1);
  edits_alike(surface, [&](auto& m) -> cn::permission {
    CHECK(cn::can_edge_flip(m, named(m, e)));
    return cn::edge_flip(m, named(m, e));
  });
  edits_alike(surface, [](auto& m) -> cn::permission {
    std::vector<cn::edge_t<std::remove_cvref_t<decltype(m)>>> list;
    for (const auto x : cn::edges(m)) list.push_back(x);
    for (const auto& x : list) cn::edge_flip(m, x);
    return {};
  });
  const auto volume = cn::testing::grid<cn::tetmesh>(2);
  cn::face_id f{0};
  while (!cn::can_face_flip(volume, f)) f = cn::face_id(f.raw() + 1);
  edits_alike(volume, [&](auto& m) -> cn::permission {
    CHECK(cn::can_face_flip(m, named(m, f)));
    const auto made = cn::face_flip(m, named(m, f));
    CHECK(cn::can_edge_flip(m, made.edge));
    return made;
  });
  edits_alike(volume, [&](auto& m) -> cn::permission {
    const auto made = cn::face_flip(m, named(m, f));
    return cn::edge_flip(m, made.edge);
  });
  edits_alike(volume, [&](auto& m) -> cn::permission {
    CHECK(cn::can_face_split(m, named(m, f), {0.3, 0.3, 0.3}));
    return cn::face_split(m, named(m, f), {0.3, 0.3, 0.3});
  });
}

TEST_CASE("editable archetypes: decimation") {
  edits_alike(cn::icosphere(1), [](auto& m) -> cn::permission {
    const auto d = cn::decimate(m, {.target_polys = 40});
    CHECK(d.num_collapses == 20);
    CHECK(cn::decimate(m, {.max_error = 0.5, .memoryless = true, .keep = all_invariants(m)}).stopped_by == cn::decimation_end::refused);
    return {};
  });
}

TEST_CASE("editable archetypes: remeshing") {
  edits_alike(cn::icosphere(1), [](auto& m) -> cn::permission {
    CHECK(cn::remesh(m, {.edge_length = 0.4}).num_splits > 0);
    auto sizes = cn::make_vert_map<double>(m, 0.5);
    CHECK(cn::remesh(m, sizes).share_of_lengths > 0.9);
    return {};
  });
}

TEST_CASE("editable archetypes: improvement of tets") {
  auto start = cn::testing::grid<cn::tetmesh>(3);
  for (const auto v : cn::verts(start))
    if (!cn::is_boundary(start, v)) cn::set_point(start, v, cn::point(start, v) + cn::vec3{0.05, 0.1, -0.1});
  edits_alike(start, [](auto& m) -> cn::permission {
    CHECK(cn::smooth_points(m, {.max_rounds = 1}).num_moves > 0);
    const auto r = cn::improve(m, {.min_dihedral_deg = 50, .max_rounds = 3});
    CHECK(r.num_flips + r.num_moves + r.num_collapses > 0);
    CHECK(r.num_new_verts > 0);
    using A = std::remove_cvref_t<decltype(m)>;
    const auto is_fixed = [](const cn::vert_t<A>&) { return false; };
    const auto is_feature = [](const cn::edge_t<A>&) { return false; };
    CHECK(cn::smooth_points(m, {.max_rounds = 1, .slides = true}, is_fixed, is_feature, [](const cn::poly_t<A>&) { return 1; }).num_moves > 0);
    return {};
  });
}

#include "call.hpp"

#include <concino/edit.hpp>
#include <concino/edit/connected_verts.hpp>
#include <concino/edit/min_stability.hpp>
#include <concino/edit/replace_polys.hpp>
#include <concino/geometry/bounding_tree.hpp>

namespace {

template<class M>
auto inner_edge(const M& m) {
  for (const auto e : cn::edges(m))
    if (!cn::is_boundary(m, e)) return e;
  return first(cn::edges(m));
}

template<class M>
auto corners_of_first(const M& m) {
  std::vector<cn::vert_t<M>> corners;
  for (const auto v : cn::adj_p2v(m, first(cn::polys(m)))) corners.push_back(v);
  return corners;
}

void call_elements() {
  call("add_vert", [](auto& m) { cn::add_vert(m, {5, 5, 5}); }, all);
  call("add_poly", [](auto& m) {
    const auto corners = corners_of_first(m);
    cn::remove_poly(m, first(cn::polys(m)));
    cn::add_poly(m, corners);
  }, kinds<cn::trimesh, cn::quadmesh, cn::polygonmesh, cn::tetmesh, cn::hexmesh>());
  call("add_face", [](auto& m) {
    std::array<cn::vert_id, 4> v;
    for (double x = 5; auto& w : v) w = cn::add_vert(m, {x, x * x, 30 - x * x * x / 7}), ++x;
    cn::add_face(m, {v[0], v[1], v[2]});
  }, kinds<cn::polyhedralmesh>());
  call("add_poly", [](auto& m) {
    std::array<cn::vert_id, 4> v;
    for (double x = 5; auto& w : v) w = cn::add_vert(m, {x, x * x, 30 - x * x * x / 7}), ++x;
    cn::add_poly(m, {{cn::add_face(m, {v[0], v[2], v[1]}), true}, {cn::add_face(m, {v[0], v[1], v[3]}), true}, {cn::add_face(m, {v[1], v[2], v[3]}), true},
                     {cn::add_face(m, {v[2], v[0], v[3]}), true}});
  }, kinds<cn::polyhedralmesh>());
  call("remove_poly", [](auto& m) { cn::remove_poly(m, first(cn::polys(m))); }, all);
  call("remove_face", [](auto& m) { cn::remove_face(m, first(cn::faces(m))); }, volumes);
  call("remove_vert", [](auto& m) { cn::remove_vert(m, first(cn::verts(m))); }, all);
  call("remove_unreferenced", [](auto& m) { cn::remove_unreferenced(m); }, all);
  call("garbage_collect", [](auto& m) {
    cn::remove_poly(m, first(cn::polys(m)));
    cn::garbage_collect(m);
  }, all);
}

void call_edge_edits() {
  call("can_edge_collapse", [](auto& m) { cn::can_edge_collapse(m, inner_edge(m)); }, all);
  call("edge_collapse", [](auto& m) {
    for (const auto e : cn::edges(m))
      if (cn::can_edge_collapse(m, e)) {
        cn::edge_collapse(m, e);
        break;
      }
  }, all);
  call("can_edge_flip", [](auto& m) { cn::can_edge_flip(m, inner_edge(m)); }, all);
  call("edge_flip", [](auto& m) {
    if (const auto e = inner_edge(m); cn::can_edge_flip(m, e)) cn::edge_flip(m, e);
  }, all);
  constexpr kinds<cn::trimesh, cn::polygonmesh, cn::tetmesh, cn::polyhedralmesh> split;
  call("can_edge_split", [](auto& m) { cn::can_edge_split(m, inner_edge(m)); }, split);
  call("edge_split", [](auto& m) {
    if (const auto e = inner_edge(m); cn::can_edge_split(m, e)) cn::edge_split(m, e);
  }, split);
  call("can_face_flip", [](auto& m) { cn::can_face_flip(m, first(cn::faces(m))); }, volumes);
  call("face_flip", [](auto& m) {
    for (const auto f : cn::faces(m))
      if (cn::can_face_flip(m, f)) {
        cn::face_flip(m, f);
        break;
      }
  }, volumes);
  const cn::vec3 x{0.3, 0.4, 0.2};
  call("can_face_split", [&](auto& m) { cn::can_face_split(m, first(cn::faces(m)), x); }, volumes);
  call("face_split", [&](auto& m) {
    if (const auto f = first(cn::faces(m)); cn::can_face_split(m, f, x)) cn::face_split(m, f, x);
  }, volumes);
  call("can_poly_split", [](auto& m) { cn::can_poly_split(m, first(cn::polys(m))); }, all);
  call("poly_split", [](auto& m) {
    if (const auto p = first(cn::polys(m)); cn::can_poly_split(m, p)) cn::poly_split(m, p);
  }, all);
}

/// Polygons and polyhedra.
void call_poly_edits() {
  constexpr auto general = kinds<cn::polygonmesh, cn::polyhedralmesh>();
  constexpr auto polygons = kinds<cn::polygonmesh>();
  constexpr auto polyhedra = kinds<cn::polyhedralmesh>();
  call("can_edge_merge", [](auto& m) { cn::can_edge_merge(m, first(cn::verts(m))); }, general);
  call("edge_merge", [](auto& m) { cn::edge_merge(m, first(cn::verts(m))); }, general);
  call("can_merge_polys", [](auto& m) { cn::can_merge_polys(m, first(cn::facets(m))); }, general);
  call("merge_polys", [](auto& m) { cn::merge_polys(m, first(cn::facets(m))); }, general);
  call("merge_polys", [](auto& m) {
    const auto labels = cn::make_poly_map<int>(m);
    cn::merge_polys(m, labels);
  }, general);
  call("agglomerate_while", [](auto& m) { cn::agglomerate_while(m, cn::min_stability(0.1), {.target = 3}); }, general);
  call("can_poly_cut", [](auto& m) {
    const auto corners = corners_of_first(m);
    cn::can_poly_cut(m, first(cn::polys(m)), corners[0], corners[2]);
  }, polygons);
  call("poly_cut", [](auto& m) {
    const auto corners = corners_of_first(m);
    cn::poly_cut(m, first(cn::polys(m)), corners[0], corners[2]);
  }, polygons);
  call("can_poly_cut", [](auto& m) { cn::can_poly_cut(m, first(cn::polys(m)), {first(cn::edges(m))}); }, polyhedra);
  call("poly_cut", [](auto& m) { cn::poly_cut(m, first(cn::polys(m)), {first(cn::edges(m))}); }, polyhedra);
  call("can_face_cut", [](auto& m) {
    const auto f = first(cn::faces(m));
    cn::can_face_cut(m, f, first(cn::adj_f2v(m, f)), first(cn::verts(m)));
  }, polyhedra);
  call("face_cut", [](auto& m) {
    const auto f = first(cn::faces(m));
    cn::face_cut(m, f, first(cn::adj_f2v(m, f)), first(cn::verts(m)));
  }, polyhedra);
  call("can_face_merge", [](auto& m) { cn::can_face_merge(m, first(cn::faces(m)), first(cn::faces(m))); }, polyhedra);
  call("face_merge", [](auto& m) { cn::face_merge(m, first(cn::faces(m)), first(cn::faces(m))); }, polyhedra);
}

void call_vert_edits() {
  call("can_merge_verts", [](auto& m) { cn::can_merge_verts(m, cn::vert_id{0}, {cn::vert_id{1}}); }, all);
  call("merge_verts", [](auto& m) {
    if (cn::can_merge_verts(m, cn::vert_id{0}, {cn::vert_id{1}})) cn::merge_verts(m, cn::vert_id{0}, {cn::vert_id{1}});
  }, all);
  call("split_vert_fans", [](auto& m) { cn::split_vert_fans(m); }, all);
  call("inverse_of_collapse", [](auto& m) { cn::inverse_of_collapse(m, inner_edge(m)); }, all);
  call("can_vert_split", [](auto& m) {
    const auto p = first(cn::polys(m));
    cn::can_vert_split(m, first(cn::adj_p2v(m, p)), std::vector{p}, {0.4, 0.4, 0.1});
  }, all);
  call("vert_split", [](auto& m) {
    for (const auto p : cn::polys(m))
      for (const auto v : cn::adj_p2v(m, p))
        if (cn::can_vert_split(m, v, std::vector{p}, {0.4, 0.4, 0.1})) {
          cn::vert_split(m, v, std::vector{p}, {0.4, 0.4, 0.1});
          return;
        }
  }, all);
  call("flip_winding", [](auto& m) { cn::flip_winding(m); }, all);
  call("are_joined", [](auto& m) { cn::are_joined(m, cn::vert_id{0}, cn::vert_id{1}); }, all);
  call("are_joined", [](auto& m) { cn::are_joined(m, cn::vert_id{0}, cn::vert_id{1}, cn::vert_id{2}); }, volumes);
  call("can_replace_polys", [](auto& m) { cn::can_replace_polys(m, cn::cavity<std::remove_reference_t<decltype(m)>>()); }, all);
  call("replace_polys", [](auto& m) {
    using M = std::remove_reference_t<decltype(m)>;
    cn::cavity_result<M> made;
    cn::replace_polys(m, cn::cavity<M>(), made, {}, {}, [] {});
  }, all);
}

void call_invariants() {
  call("keep_labels", [](auto& m) {
    const auto labels = cn::make_poly_map<int>(m);
    if (const auto e = inner_edge(m); cn::can_edge_split(m, e)) cn::edge_split(m, e, 0.5, {.keep = {cn::keep_labels(m, labels)}});
  }, kinds<cn::trimesh, cn::tetmesh>());
  call("protect_edges", [](auto& m) {
    const auto none = cn::make_edge_map<bool>(m);
    if (const auto e = inner_edge(m); cn::can_edge_split(m, e)) cn::edge_split(m, e, 0.5, {.keep = {cn::protect_edges(m, none)}});
  }, kinds<cn::trimesh, cn::tetmesh>());
  call("protect_faces", [](auto& m) {
    const auto none = cn::make_face_map<bool>(m);
    if (const auto e = inner_edge(m); cn::can_edge_split(m, e)) cn::edge_split(m, e, 0.5, {.keep = {cn::protect_faces(m, none)}});
  }, tets);
  call("max_distance", [](auto& m) {
    const auto original = m;
    const auto tree = cn::bounding_tree(original);
    cn::edge_split(m, inner_edge(m), 0.5, {.keep = {cn::max_distance(tree, 1.0)}});
  }, triangles);
}

}  // namespace

void call_edit() {
  call_elements();
  call_edge_edits();
  call_poly_edits();
  call_vert_edits();
  call_invariants();
}

// Agglomeration: merges polys with the same label into larger polys of any shape.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/error.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/generate/detail/common/merged_boundary.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/correspondence.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace concino {

struct agglomerate_options {
  bool properties = true;                            // whether named properties are transferred, if m has any
  concino::correspondence* correspondence = nullptr;  // unless null, filled with the elements of m of which those of
                                                      // the result were made
};

namespace requirement {

template<class L, class M>
concept is_label_map = ReadableMap<L, poly_t<M>> && requires(const L& labels, const poly_t<M>& p) {
  { labels[p] } -> std::convertible_to<long long>;
  requires std::integral<std::remove_cvref_t<decltype(labels[p])>>;
};

}  // namespace requirement

namespace detail {

/// Calls take(label, polys) for every label in ascending order. The polys of a label are in the order of polys(m).
template<AnyMesh M, class L, class Take>
void for_each_label(const M& m, const L& labels, const Take& take) {
  using value = std::remove_cvref_t<decltype(labels[std::declval<const poly_t<M>&>()])>;
  std::vector<poly_t<M>> all, sorted;
  std::vector<std::pair<value, std::uint32_t>> order;
  for (const poly_t<M> p : polys(m)) {
    order.emplace_back(labels[p], static_cast<std::uint32_t>(all.size()));
    all.push_back(p);
  }
  std::sort(order.begin(), order.end());
  sorted.reserve(all.size());
  for (const auto& [label, k] : order) sorted.push_back(all[k]);
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && order[last].first == order[first].first) ++last;
    take(order[first].first, std::span<const poly_t<M>>(sorted).subspan(first, last - first));
  }
}

/// Numbers the marked elements of a range in its order. The result is by index of the element.
template<class M, class R>
std::vector<std::uint32_t> numbered_marked(const M& m, const R& elements, std::vector<std::uint32_t> mark) {
  std::uint32_t n = 0;
  for (const auto x : elements)
    if (std::uint32_t& number = mark[index_of(m, x)]; number != ~0u) number = n++;
  return mark;
}

/// The origins of the elements of merged polys: verts and faces are copies; the polys of a union are weighted by their
/// measures.
template<EmbeddedMesh M>
class merge_origins {
  const M& m_;
  const agglomerate_options& options_;
  bool is_wanted_ = false, has_properties_ = false;
  correspondence c_;
  std::vector<origin> merged_;

  static element_origins inverse(const std::vector<std::uint32_t>& number) {
    std::vector<std::uint32_t> single;
    for (std::uint32_t i = 0; i < number.size(); ++i) {
      if (number[i] == element_origins::none) continue;
      if (single.size() <= number[i]) single.resize(number[i] + std::size_t{1});
      single[number[i]] = i;
    }
    return element_origins(std::move(single));
  }

 public:
  merge_origins(const M& m, const agglomerate_options& options) : m_(m), options_(options) {
    if constexpr (ShowsProperties<M>) has_properties_ = options.properties && traits<M>::properties(m).size() > 0;
    is_wanted_ = has_properties_ || options.correspondence;
  }

  void add_poly(std::span<const poly_t<M>> group) {
    if (!is_wanted_) return;
    merged_.clear();
    for (const poly_t<M>& p : group) {
      const double size = std::abs(measure(m_, p));
      merged_.push_back({static_cast<std::uint32_t>(index_of(m_, p)), std::isfinite(size) ? size : 0});
    }
    c_.polys.add(merged_);
  }
  /// Sets the correspondence and transfers the properties of m. The new numbers of verts and faces are by index of m.
  template<class To>
  void finish(To& result, const std::vector<std::uint32_t>& vert_number,
              const std::vector<std::uint32_t>& face_number) {
    if (!is_wanted_) return;
    c_.verts = inverse(vert_number);
    c_.faces = inverse(face_number);
    match_edges_and_faces(m_, result, c_);
    if constexpr (ShowsProperties<M>)
      if (has_properties_) transfer_properties(m_, result, c_);
    if (options_.correspondence) *options_.correspondence = std::move(c_);
  }
};

template<AnyMesh M, class V>
[[noreturn]] void throw_not_mergeable(const M& m, V label, const poly_t<M>& p, const merge_fault& fault) {
  const std::string which = ~fault.index != 0 ? core::joined({" ", fault.index}) : std::string();
  core::throw_joined<invalid_mesh>({"agglomerate: the polys with label ",
                                    core::number_text(static_cast<long long>(label)), ", poly ", index_of(m, p),
                                    " among them, do not form a ", std::string(SurfaceMesh<M> ? "disk: " : "ball: "),
                                    fault.text, which, "; random_labels() gives labels that can be merged"});
}

}  // namespace detail

/// Merges all polys of one label into one poly, convex or not.
/// Needs:  EmbeddedMesh; labels[p] is an integer. The polys of one label are oriented consistently and form a disk
///         (surfaces) or a ball (volumes). They are connected through edges or faces. Their boundary is one cycle of
///         verts, or one sphere of faces, that does not touch itself.
/// Result: a polygonmesh or polyhedralmesh with a poly for each label, numbered by ascending label. Faces and verts
///         inside a union, or of no poly, are left out; the others keep the order of m. All verts and all faces on the
///         boundary of a union stay: a polygon may have flat corners where only two polys meet, and two polyhedra may
///         share several faces in one plane. Named properties are transferred by their rules, and polys that become one
///         are weighted by their measures.
/// Cost:   O(elements + P log P) time, O(elements) memory.
/// Errors: invalid_mesh that names the label, one of its polys and where it is not a disk or ball. A union of one poly
///         is not checked.
/// Source: agglomerated meshes as in Bassi, Botti, Colombo, Di Pietro, Tesini 2012.
template<SurfaceMesh M, class L>
  requires Embedded<M> && requirement::is_label_map<L, M>
polygonmesh agglomerate(const M& m, const L& labels, const agglomerate_options& options = {}) {
  surface_arrays a;
  a.offsets.push_back(0);
  std::vector<std::uint32_t> used(vert_index_bound(m), ~0u);
  detail::merged_boundary<M> border(m);
  detail::merge_origins<M> origins(m, options);
  detail::for_each_label(m, labels, [&](const auto& label, std::span<const poly_t<M>> group) {
    if (const auto fault = border.read(group)) detail::throw_not_mergeable(m, label, group.front(), fault);
    origins.add_poly(group);
    for (const vert_t<M>& v : border.ring()) {
      used[index_of(m, v)] = 0;
      a.verts.push_back(vert_id{index_of(m, v)});
    }
    a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  });
  const auto number = detail::numbered_marked(m, verts(m), std::move(used));
  for (vert_id& v : a.verts) v = vert_id{number[v.raw()]};
  for (const vert_t<M> v : verts(m))
    if (number[index_of(m, v)] != ~0u) a.points.push_back(to_vec3(point(m, v)));
  polygonmesh result(std::move(a));
  origins.finish(result, number, {});
  return result;
}

template<VolumeMesh M, class L>
  requires Embedded<M> && requirement::is_label_map<L, M>
polyhedralmesh agglomerate(const M& m, const L& labels, const agglomerate_options& options = {}) {
  polyhedra_arrays a;
  a.face_offsets.push_back(0);
  a.poly_offsets.push_back(0);
  std::vector<std::uint32_t> used_vert(vert_index_bound(m), ~0u), used_face(face_index_bound(m), ~0u);
  detail::merged_boundary<M> border(m);
  detail::merge_origins<M> origins(m, options);
  detail::for_each_label(m, labels, [&](const auto& label, std::span<const poly_t<M>> group) {
    if (const auto fault = border.read(group)) detail::throw_not_mergeable(m, label, group.front(), fault);
    origins.add_poly(group);
    for (const auto& [f, outward] : border.boundary_faces()) {
      used_face[index_of(m, f)] = 0;
      a.poly_faces.push_back(face_id{index_of(m, f)});
      a.outward.push_back(outward);
    }
    a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
  });
  const auto face_number = detail::numbered_marked(m, faces(m), std::move(used_face));
  for (face_id& f : a.poly_faces) f = face_id{face_number[f.raw()]};
  for (const face_t<M> f : faces(m)) {
    if (face_number[index_of(m, f)] == ~0u) continue;
    for (const vert_t<M> v : adj_f2v(m, f)) {
      used_vert[index_of(m, v)] = 0;
      a.face_verts.push_back(vert_id{index_of(m, v)});
    }
    a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
  }
  const auto number = detail::numbered_marked(m, verts(m), std::move(used_vert));
  for (vert_id& v : a.face_verts) v = vert_id{number[v.raw()]};
  for (const vert_t<M> v : verts(m))
    if (number[index_of(m, v)] != ~0u) a.points.push_back(to_vec3(point(m, v)));
  polyhedralmesh result(std::move(a));
  origins.finish(result, number, face_number);
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void agglomerate(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void agglomerate(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class U, class R = mistake::remedy<mistake::give_labels_at_polys>>
  requires(EmbeddedMesh<M> && !requirement::is_label_map<U, M>)
void agglomerate(M&&, const U&, ...) = delete;  // an int at each poly: make_poly_map<int>(m)

}  // namespace concino

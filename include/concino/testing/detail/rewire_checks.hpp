// Edits a mesh by `rewire`, and checks the laws of editable meshes, ED1 .. ED5: it is the mesh that the cavity
// describes afterwards.
#pragma once

#include <concino/core/message.hpp>
#include <concino/edit/replace_polys.hpp>
#include <concino/testing/detail/adjacencies.hpp>
#include <concino/testing/detail/described_mesh.hpp>
#include <concino/testing/detail/sample_cavities.hpp>
#include <concino/validate/broken_law.hpp>

#include <exception>
#include <new>
#include <string>
#include <vector>

namespace concino::testing::detail {

/// What cavity c makes of the mesh that `before` describes. The new elements have the names that rewire returned.
template<class M>
described_mesh<M> as_cavity_describes(const M& m, described_mesh<M> before, const built_cavity<M>& c) {
  const auto index = [&](unsigned i) {
    return index_of(m, i < c.verts.size() ? c.verts[i] : c.new_verts[i - c.verts.size()]);
  };
  for (const auto& p : c.polys) before.polys.erase(index_of(m, p));
  for (std::size_t i = c.verts.size() - c.removed; i < c.verts.size(); ++i) before.verts.erase(index_of(m, c.verts[i]));
  for (std::size_t i = 0; i < c.points.size(); ++i)
    before.verts[index_of(m, c.new_verts[i])] = {c.new_verts[i], c.points[i], true};
  for (std::size_t i = 0; i < c.new_polys.size(); ++i) {
    poly_shape shape;
    for (const auto& loop : c.loops_of(i)) {
      shape.emplace_back();
      for (const unsigned v : loop) shape.back().push_back(index(v));
    }
    before.polys[index_of(m, c.new_polys[i])] = {c.new_polys[i], in_normal_form<M>(std::move(shape)), true};
  }
  return before;
}

/// ED3: an edge or face on the same verts as before has the same descriptor.
template<class Map>
void compare_lower(const Map& before, const Map& after, char letter, concino::detail::law_log& log) {
  for (const auto& [verts, x] : before) {
    const auto at = after.find(verts);
    if (at == after.end() || x.count != 1 || at->second.count != 1) continue;
    if (!(at->second.element == x.element) || at->second.index != x.index)
      log.add(
          "ED3",
          core::joined(
              {name(letter, x.index),
               " remains, as old and new polys share it or it is not in the cavity, but it has another descriptor after rewire"}),
          name(letter, x.index));
  }
}

/// Reports where `found` is not `expected`: new elements break ED1, others ED2 and ED3.
template<class M>
void compare(const described_mesh<M>& expected, const described_mesh<M>& found, concino::detail::law_log& log) {
  const auto count = [&](const char* kind, std::size_t wanted, std::size_t there) {
    if (wanted != there)
      log.add("ED1", core::joined({"rewire leaves ", there, " ", kind, ", but the cavity describes ", wanted}), "");
  };
  count("polys", expected.polys.size(), found.polys.size());
  count("verts", expected.verts.size(), found.verts.size());
  for (const auto& [i, p] : expected.polys) {
    const auto at = found.polys.find(i);
    const std::string witness = name('p', i);
    if (at == found.polys.end() || !(at->second.poly == p.poly))
      log.add(p.is_new ? "ED1" : "ED2",
              core::joined({witness, p.is_new ? ", a poly that rewire returned, does not exist"
                                              : " is not in the cavity, but rewire removes it"}),
              witness);
    else if (at->second.shape != p.shape)
      log.add(p.is_new ? "ED1" : "ED2",
              core::joined({witness, p.is_new ? " does not have the verts that the cavity lists, in this order"
                                              : " is not in the cavity, but rewire changes its verts"}),
              witness);
    else if (at->second.value != p.value && !p.is_new)
      log.add("ED2", core::joined({witness, " is not in the cavity, but rewire changes its value of a named property"}),
              witness);
  }
  for (const auto& [i, v] : expected.verts) {
    const auto at = found.verts.find(i);
    const std::string witness = name('v', i);
    if (at == found.verts.end() || !(at->second.vert == v.vert))
      log.add(v.is_new ? "ED1" : "ED2",
              core::joined({witness, v.is_new ? ", a vert that rewire returned, does not exist"
                                              : " is not removed by the cavity, but by rewire"}),
              witness);
    else if (at->second.point != v.point)
      log.add(v.is_new ? "ED1" : "ED2",
              core::joined({"point(", witness, ") is not the point that ",
                            v.is_new ? "the cavity lists for this new vert" : "this vert had before rewire"}),
              witness);
    else if (at->second.value != v.value && !v.is_new)
      log.add("ED2", core::joined({witness, " is an old vert, but rewire changes its value of a named property"}),
              witness);
  }
  compare_lower(expected.edges, found.edges, 'e', log);
  if constexpr (VolumeMesh<M>) compare_lower(expected.faces, found.faces, 'f', log);  // surfaces have no faces
}

/// Applies the cavity. ED1, ED2, ED3 and ED5: the mesh is as the cavity describes. Returns whether it was applied.
template<class M>
bool check_rewire(M& m, built_cavity<M>& c, concino::detail::law_log& log) {
  if (!can_replace_polys(m, c.lists())) return false;
  const described_mesh<M> before = describe(m);
  c.apply(m);
  for (std::size_t i = 0; i < c.kept; ++i)
    if (!(c.new_polys[i] == c.polys[i]))
      log.add("ED5",
              core::joined({"new poly ", i, " of the cavity does not have the descriptor of old poly ", i,
                            ", though kept is ", c.kept}),
              name('p', index_of(m, c.polys[i])));
  compare(as_cavity_describes(m, before, c), describe(m), log);
  return log.empty();
}

/// ED4: a cavity with a poly that lists a vert twice is refused, and leaves the mesh as before.
template<class M>
void check_refused_rewire(M& m, built_cavity<M> c, concino::detail::law_log& log) {
  c.corners[1] = c.corners[0];
  const described_mesh<M> before = describe(m);
  try {
    c.apply(m);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    concino::detail::law_log changes;
    compare(before, describe(m), changes);
    for (const broken_law& b : changes.take())
      log.add("ED4", core::joined({"rewire throws, but the mesh is not as before: ", b.what}), b.witness);
    return;
  }
  log.add("ED4", "rewire accepts a new poly that lists a vert twice; it has to throw before it changes anything",
          name('p', index_of(m, c.polys[0])));
}

/// Rewires some polys: turns each, divides it at new verts, and joins the parts again. ED1 .. ED5.
template<EditableMesh M>
void rewire_polys(M& m, concino::detail::law_log& log) {
  label_elements(m);
  std::vector<poly_t<M>> all;
  for (const poly_t<M> p : polys(m)) all.push_back(p);
  for (std::size_t i = 0; i < all.size() && i < 12 && log.empty(); i += 2) {
    built_cavity<M> turned = turned_poly(m, all[i]);
    if (turned.polys.empty()) continue;
    check_rewire(m, turned, log);
    if (!log.empty()) return;
    if (i == 0) check_refused_rewire(m, turned_poly(m, all[i]), log);
    built_cavity<M> parts = divided_poly(m, all[i]);
    if (parts.polys.empty() || !log.empty() || !check_rewire(m, parts, log)) continue;
    built_cavity<M> whole = joined_parts(m, parts, turned);
    check_rewire(m, whole, log);
    if (i % 4 == 0 && log.empty()) {
      built_cavity<M> again = divided_poly(m, all[i]);
      check_rewire(m, again, log);
    }
  }
}

}  // namespace concino::testing::detail

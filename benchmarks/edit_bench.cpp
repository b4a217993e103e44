// Measures edits of triangles and tets, with and without a transaction, and of polygons and polyhedra. The programs of peers measure the same edits of theirs
// beside ours.
#include "support/edits.hpp"

#include <concino/generate/dual_mesh.hpp>

#include <stdexcept>

namespace {

template<class M, class Arrays>
void edits(const bench::program& p, const std::string& name, const Arrays& arrays) {
  const M m = bench::editable<M>(arrays);
  const auto run = [&](const char* edit, auto f) {
    const std::string work = std::string("edit.") + edit + "." + name;
    if (!p.wants(work)) return;
    const auto edges = bench::edges_to_edit(concino::num_edges(m), false);
    M check = m;
    std::size_t done = 0;
    for (const bench::u32 e : edges) done += f(check, e);
    if (done == 0) throw std::runtime_error(work + ": no edit was possible");
    const auto recorded = [&, f] {
      auto copy = std::make_unique<M>(m);
      return bench::seconds_of([&] {
        concino::transaction t(*copy);
        for (const bench::u32 e : edges) f(*copy, e);
        return t.commit();
      });
    };
    p.print(bench::compare(work, p.rounds, {{"recorded", recorded}, {"concino", [&, f] { return bench::seconds_of_edits(m, edges, f); }}}));
  };
  run("split", bench::split<M>);
  run("flip", bench::flip<M>);
  run("collapse", bench::collapse<M>);
}

/// The edges around the faces of p at its first vert: a loop along which p is cut.
template<class M>
std::vector<concino::edge_t<M>> loop_of(const M& m, const concino::poly_t<M>& p) {
  const auto v = *concino::adj_p2v(m, p).begin();
  const auto has_v = [&](const auto& range) { return std::find(range.begin(), range.end(), v) != range.end(); };
  std::vector<concino::edge_t<M>> loop;
  for (const auto f : concino::adj_p2f(m, p))
    if (has_v(concino::adj_f2v(m, f)))
      for (const auto e : concino::adj_f2e(m, f))
        if (!has_v(concino::adj_e2v(m, e))) loop.push_back(e);
  return loop;
}

/// Cuts a poly in two: a polygon between two corners, a polyhedron along a loop.
template<class M>
bool cut(M& m, const concino::poly_t<M>& p) {
  if constexpr (concino::VolumeMesh<M>) {
    return bool(concino::poly_cut(m, p, loop_of(m, p)));
  } else {
    const std::vector<concino::vert_t<M>> corners(concino::adj_p2v(m, p).begin(), concino::adj_p2v(m, p).end());
    return bool(concino::poly_cut(m, p, corners[0], corners[corners.size() / 2]));
  }
}

/// Cuts a face between two corners, and merges the halves again.
template<class M>
bool cut_and_merge_face(M& m, const concino::face_t<M>& f) {
  const std::vector<concino::vert_t<M>> corners(concino::adj_f2v(m, f).begin(), concino::adj_f2v(m, f).end());
  const auto made = concino::face_cut(m, f, corners[0], corners[corners.size() / 2]);
  return made && concino::face_merge(m, made.faces[0], made.faces[1]);
}

/// Edits of 5,000 edges, facets, polys or faces of polygons or polyhedra, and 5,000 merges of the smallest polys.
template<class M>
void poly_edits(const bench::program& p, const std::string& name, const M& m) {
  const auto run = [&](const char* edit, const auto& range, auto f) {
    const std::string work = std::string("edit.polys.") + edit + "." + name;
    if (!p.wants(work)) return;
    std::vector<std::remove_cvref_t<decltype(*range.begin())>> all;
    for (const auto x : range) all.push_back(x);
    std::shuffle(all.begin(), all.end(), std::mt19937(7));  // in order, merges would make one poly that grows
    if (all.size() > 5'000) all.resize(5'000);
    p.print(bench::compare(work, p.rounds, {{"concino", [&, f] {
      auto copy = std::make_unique<M>(m);
      return bench::seconds_of([&] {
        std::size_t done = 0;
        for (const auto x : all)
          if (concino::contains(*copy, x)) done += f(*copy, x);
        if (done == 0) throw std::runtime_error(work + ": no edit was possible");
        return done;
      });
    }}}));
  };
  run("split", concino::edges(m), [](M& x, auto e) { return bool(concino::edge_split(x, e)); });
  run("merge", concino::facets(m), [](M& x, auto f) { return bool(concino::merge_polys(x, f)); });
  run("collapse", concino::edges(m), [](M& x, auto e) { return bool(concino::edge_collapse(x, e)); });
  run("split-merge", concino::edges(m), [](M& x, auto e) { return bool(concino::edge_merge(x, concino::edge_split(x, e).vert)); });
  run("cut", concino::polys(m), [](M& x, auto q) { return cut(x, q); });
  if constexpr (concino::VolumeMesh<M>) run("face-cut-merge", concino::faces(m), [](M& x, auto f) { return cut_and_merge_face(x, f); });
  const std::string work = "edit.polys.agglomerate." + name;
  if (!p.wants(work)) return;
  const std::size_t merges = std::min<std::size_t>(5'000, concino::num_polys(m) / 2);
  p.print(bench::compare(work, p.rounds, {{"concino", [&] {
    auto copy = std::make_unique<M>(m);
    return bench::seconds_of([&] {
      return concino::agglomerate_while(*copy, concino::min_quality(0, concino::metric::star_shapedness), {.target = concino::num_polys(m) - merges}).num_merges;
    });
  }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    edits<concino::trimesh>(p, "bunny16", p.data.bunny16());
    edits<concino::tetmesh>(p, "tet200k", p.data.tet200k());
    poly_edits(p, "bunny16", concino::dual_mesh(concino::trimesh(p.data.bunny16())));
    poly_edits(p, "tet200k", concino::dual_mesh(concino::tetmesh(p.data.tet200k())));
  });
}

// What can be wrong with the connectivity of a volume.
#pragma once

#include <concino/core/message.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/validate/detail/surface_checks.hpp>

namespace concino::detail {

/// How often the faces of one poly run along an edge, valid where `poly` is that poly.
struct edge_in_poly {
  std::uint32_t poly = ~0u;  // number in the walk over polys
  std::uint32_t faces = 0;
  std::uint32_t forward = 0;
};

/// Result: facts of the volume, and in `sound` by index of polys whether they are closed and wound consistently, so that they have a volume.
template<VolumeMesh M>
mesh_facts check_volume(const M& m, std::vector<std::uint8_t>& sound, defect_log<M>& log) {
  mesh_facts facts;
  log.stage(0.3, num_polys(m) + num_faces(m));
  disjoint_sets pieces(poly_index_bound(m));
  std::vector<shared_by> face_use(face_index_bound(m));
  std::vector<edge_in_poly> edge_use(edge_index_bound(m));
  std::vector<std::uint8_t> vert_used(vert_index_bound(m)), told_edges(edge_index_bound(m));
  std::vector<edge_t<M>> touched;
  rim_walker<M> rims(m);
  std::uint32_t number = 0;
  for (const poly_t<M> p : polys(m)) {
    log.step();
    const std::size_t poly_index = index_of(m, p);
    std::uint32_t face_count = 0;
    touched.clear();
    for (const face_t<M> f : adj_p2f(m, p)) {
      ++face_count;
      const bool outward = face_is_outward(m, p, f);
      shared_by& use = face_use[index_of(m, f)];
      if (use.polys > 0) pieces.unite(use.poly[0], poly_index);
      use.add(poly_index, outward);
      rims.walk(
          m, adj_f2v(m, f), adj_f2e(m, f), [&](const vert_t<M>&, std::size_t i) { vert_used[i] = 1; },
          [&](const edge_t<M>& e, std::uint32_t, std::uint32_t, bool forward) {
            edge_in_poly& here = edge_use[index_of(m, e)];
            if (here.poly != number) {
              here = {number, 0, 0};
              touched.push_back(e);
            }
            ++here.faces;
            here.forward += forward == outward;
          });
    }
    std::vector<edge_t<M>> open;
    const edge_t<M>* clash = nullptr;
    bool pinched = false;
    for (const edge_t<M>& e : touched) {
      const edge_in_poly& here = edge_use[index_of(m, e)];
      if (here.faces == 1) open.push_back(e);
      else if (here.faces == 2 && here.forward != 1) clash = clash ? clash : &e;
      else if (here.faces > 2) {
        pinched = true;
        told_edges[index_of(m, e)] = 1;
        if (defect<M>* d = log.add(defect_kind::non_manifold_edge, e)) {
          d->what = core::joined({log.edge_name(e), " lies in ", here.faces, " faces of ", log.name(p),
                            "; in the surface of a poly it lies in 2"});
          d->others.push_back(p);
        }
      }
    }
    if (!open.empty())
      if (defect<M>* d = log.add(defect_kind::open_cell, p)) {
        const std::string list = log.list(*d, open);
        d->what = core::joined({log.name(p), " is open: only one of its faces lies at ", list});
      }
    if (clash)
      if (defect<M>* d = log.add(defect_kind::inconsistent_winding, p)) {
        d->what = core::joined({log.name(p), " has two faces that, turned outward, run in the same sense along ", log.edge_name(*clash)});
        d->others.push_back(*clash);
      }
    if (face_count < 4)
      if (defect<M>* d = log.add(defect_kind::degenerate_element, p))
        d->what = core::joined({log.name(p), " has ", face_count, " faces; a polyhedron has at least 4"});
    sound[poly_index] = open.empty() && !clash && !pinched && face_count >= 4;
    facts.closed = facts.closed && open.empty();
    facts.manifold = facts.manifold && sound[poly_index];
    ++number;
  }

  std::size_t used_faces = 0, used_edges = 0, used_verts = 0;
  for (const face_t<M> f : faces(m)) {
    log.step();
    const auto rim = rims.walk(m, adj_f2v(m, f), adj_f2e(m, f), [](const vert_t<M>&, std::size_t) {}, [](const edge_t<M>&, std::uint32_t, std::uint32_t, bool) {});
    if (rim.is_degenerate())
      if (defect<M>* d = log.add(defect_kind::degenerate_element, f))
        d->what = rim.repeats ? core::joined({log.name(f), " has a vert twice"}) : core::joined({log.name(f), " has ", rim.verts, " verts; a face has at least 3"});
    const shared_by& use = face_use[index_of(m, f)];
    used_faces += use.polys > 0;
    if (use.polys == 0) {
      if (defect<M>* d = log.add(defect_kind::unreferenced_face, f)) d->what = core::joined({log.name(f), " belongs to no poly"});
    } else if (use.polys > 2) {
      facts.manifold = false;
      for (const edge_t<M> e : adj_f2e(m, f)) told_edges[index_of(m, e)] = 1;  // more than two boundary faces there follow from this
      if (defect<M>* d = log.add(defect_kind::non_manifold_face, f)) {
        const std::string list = log.list(*d, adj_f2p(m, f));
        d->what = core::joined({log.name(f), " has ", use.polys, " polys (", list, "); at most 2 fit"});
      }
    }
  }
  for (const edge_t<M> e : edges(m)) {
    used_edges += edge_use[index_of(m, e)].poly != ~0u;
    check_edge_ends(m, e, log);
  }
  for (const vert_t<M> v : verts(m)) {
    used_verts += vert_used[index_of(m, v)];
    if (!vert_used[index_of(m, v)])
      if (defect<M>* d = log.add(defect_kind::isolated_vert, v)) d->what = core::joined({log.name(v), " belongs to no poly"});
  }
  for (const poly_t<M> p : polys(m)) facts.components += pieces.root(index_of(m, p)) == index_of(m, p);
  facts.euler_characteristic = static_cast<std::ptrdiff_t>(used_verts + used_faces) - static_cast<std::ptrdiff_t>(used_edges + number);
  facts.orientable = check_windings(
      m, faces(m), [&](const face_t<M>& f) -> decltype(auto) { return adj_f2p(m, f); }, face_use, poly_index_bound(m), " have their outside on the same side of ", log);

  const auto surface = boundary(m);
  const mesh_facts skin = check_surface<M>(surface, surface_scope<M, std::remove_const_t<decltype(surface)>>{&told_edges}, log);
  facts.manifold = facts.manifold && skin.manifold;
  facts.boundary_loops = skin.boundary_loops;
  if (facts.manifold && facts.orientable) facts.genus = skin.genus;
  return facts;
}

}  // namespace concino::detail

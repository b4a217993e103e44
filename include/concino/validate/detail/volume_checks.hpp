// Checks of the connectivity of a volume.
#pragma once

#include <concino/core/message.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/validate/detail/surface_checks.hpp>

namespace concino::detail {

/// How often the faces of one poly traverse an edge; valid if `poly` is that poly.
struct edge_in_poly {
  std::uint32_t poly = ~0u;  // number in the order of polys
  std::uint32_t faces = 0;
  std::uint32_t forward = 0;
};

/// Checks a volume, and finally its boundary as a surface.
template<VolumeMesh M>
class volume_checker {
  const M& m_;
  std::vector<std::uint8_t>& encloses_volume_;  // by poly index
  defect_log<M>& log_;
  disjoint_sets pieces_;  // of polys that share faces
  std::vector<shared_by> face_use_;
  std::vector<edge_in_poly> edge_use_;
  std::vector<std::uint8_t> vert_used_, reported_edges_;  // by index
  oriented_edge_walker<M> edge_walker_;
  std::vector<edge_t<M>> touched_;  // edges of the current poly
  std::uint32_t number_ = 0;        // of that poly in the order of polys
  mesh_facts facts_;

  /// Counts the faces of p at each of its edges.   Result: the number of faces of p.
  std::uint32_t count_edge_uses(const poly_t<M>& p) {
    const std::size_t poly_index = index_of(m_, p);
    std::uint32_t face_count = 0;
    touched_.clear();
    for (const face_t<M> f : adj_p2f(m_, p)) {
      ++face_count;
      const bool outward = face_is_outward(m_, p, f);
      shared_by& use = face_use_[index_of(m_, f)];
      if (use.polys > 0) pieces_.unite(use.poly[0], poly_index);
      use.add(poly_index, outward);
      edge_walker_.walk(
          m_, adj_f2v(m_, f), adj_f2e(m_, f), [&](const vert_t<M>&, std::size_t i) { vert_used_[i] = 1; },
          [&](const edge_t<M>& e, std::uint32_t, std::uint32_t, bool forward) {
            edge_in_poly& here = edge_use_[index_of(m_, e)];
            if (here.poly != number_) {
              here = {number_, 0, 0};
              touched_.push_back(e);
            }
            ++here.faces;
            here.forward += forward == outward;
          });
    }
    return face_count;
  }

  void check_polys() {
    for (const poly_t<M> p : polys(m_)) {
      log_.step();
      const std::uint32_t face_count = count_edge_uses(p);
      check_poly(p, face_count);
      --facts_.euler_characteristic;
      ++number_;
    }
  }

  /// Checks that p, whose edges are touched_, is closed, wound consistently and has enough faces.
  void check_poly(const poly_t<M>& p, std::uint32_t face_count) {
    std::vector<edge_t<M>> open;
    const edge_t<M>* clash = nullptr;
    bool pinched = false;
    for (const edge_t<M>& e : touched_) {
      const edge_in_poly& here = edge_use_[index_of(m_, e)];
      if (here.faces == 1) open.push_back(e);
      else if (here.faces == 2 && here.forward != 1) clash = clash ? clash : &e;
      else if (here.faces > 2) {
        pinched = true;
        add_pinched_edge(e, here.faces, p);
      }
    }
    if (!open.empty()) add_open_poly(p, open);
    if (clash) add_clash_in_poly(p, *clash);
    if (face_count < 4)
      if (defect<M>* d = log_.add(defect_kind::degenerate_element, p))
        d->what = core::joined({log_.name(p), " has ", face_count, " faces; a polyhedron has at least 4"});
    const bool is_valid = open.empty() && !clash && !pinched && face_count >= 4;
    encloses_volume_[index_of(m_, p)] = is_valid;
    facts_.closed = facts_.closed && open.empty();
    facts_.manifold = facts_.manifold && is_valid;
  }

  void add_pinched_edge(const edge_t<M>& e, std::uint32_t face_count, const poly_t<M>& p) {
    reported_edges_[index_of(m_, e)] = 1;
    if (defect<M>* d = log_.add(defect_kind::non_manifold_edge, e)) {
      d->what = core::joined({log_.edge_name(e), " lies in ", face_count, " faces of ", log_.name(p),
                        "; each edge of a poly lies in 2 of its faces"});
      d->others.push_back(p);
    }
  }
  void add_open_poly(const poly_t<M>& p, const std::vector<edge_t<M>>& open) {
    if (defect<M>* d = log_.add(defect_kind::open_cell, p)) {
      const std::string list = log_.list(*d, open);
      d->what = core::joined({log_.name(p), " is open: only one of its faces lies at ", list});
    }
  }
  void add_clash_in_poly(const poly_t<M>& p, const edge_t<M>& clash) {
    if (defect<M>* d = log_.add(defect_kind::inconsistent_winding, p)) {
      d->what = core::joined(
          {log_.name(p), " has two faces that, turned outward, run in the same sense along ", log_.edge_name(clash)});
      d->others.push_back(clash);
    }
  }

  void check_faces() {
    for (const face_t<M> f : faces(m_)) {
      log_.step();
      check_boundary_cycle(f);
      const std::uint32_t poly_count = face_use_[index_of(m_, f)].polys;
      facts_.euler_characteristic += poly_count > 0;
      if (poly_count == 0) {
        if (defect<M>* d = log_.add(defect_kind::unreferenced_face, f))
          d->what = core::joined({log_.name(f), " belongs to no poly"});
      } else if (poly_count > 2) {
        facts_.manifold = false;
        add_non_manifold_face(f, poly_count);
      }
    }
  }

  void check_boundary_cycle(const face_t<M>& f) {
    const auto cycle = edge_walker_.walk(
        m_, adj_f2v(m_, f), adj_f2e(m_, f), [](const vert_t<M>&, std::size_t) {},
        [](const edge_t<M>&, std::uint32_t, std::uint32_t, bool) {});
    if (cycle.is_degenerate())
      if (defect<M>* d = log_.add(defect_kind::degenerate_element, f))
        d->what = cycle.repeats ? core::joined({log_.name(f), " has a vert twice"})
                                : core::joined({log_.name(f), " has ", cycle.verts, " verts; a face has at least 3"});
  }

  void add_non_manifold_face(const face_t<M>& f, std::uint32_t poly_count) {
    // more than two boundary faces there are a consequence of this
    for (const edge_t<M> e : adj_f2e(m_, f)) reported_edges_[index_of(m_, e)] = 1;
    if (defect<M>* d = log_.add(defect_kind::non_manifold_face, f)) {
      const std::string list = log_.list(*d, adj_f2p(m_, f));
      d->what = core::joined({log_.name(f), " has ", poly_count, " polys (", list, "); a face has at most 2"});
    }
  }

  void check_edges() {
    for (const edge_t<M> e : edges(m_)) {
      facts_.euler_characteristic -= edge_use_[index_of(m_, e)].poly != ~0u;
      check_edge_ends(m_, e, log_);
    }
  }

  void check_verts() {
    for (const vert_t<M> v : verts(m_)) {
      const bool is_used = vert_used_[index_of(m_, v)];
      facts_.euler_characteristic += is_used;
      if (!is_used)
        if (defect<M>* d = log_.add(defect_kind::isolated_vert, v))
          d->what = core::joined({log_.name(v), " belongs to no poly"});
    }
  }

  std::size_t count_components() {
    std::size_t count = 0;
    for (const poly_t<M> p : polys(m_)) count += pieces_.root(index_of(m_, p)) == index_of(m_, p);
    return count;
  }

  bool check_face_windings() {
    return check_windings(
        m_, faces(m_), [&](const face_t<M>& f) -> decltype(auto) { return adj_f2p(m_, f); }, face_use_,
        poly_index_bound(m_), " have their outside on the same side of ", log_);
  }

  /// Checks the boundary. The genus of a volume is that of its boundary.
  void check_boundary() {
    const auto surface = boundary(m_);
    const mesh_facts surface_facts =
        check_surface<M>(surface, surface_scope<M, std::remove_const_t<decltype(surface)>>{&reported_edges_}, log_);
    facts_.manifold = facts_.manifold && surface_facts.manifold;
    facts_.boundary_loops = surface_facts.boundary_loops;
    if (facts_.manifold && facts_.orientable) facts_.genus = surface_facts.genus;
  }

 public:
  volume_checker(const M& m, std::vector<std::uint8_t>& encloses_volume, defect_log<M>& log)
      : m_(m), encloses_volume_(encloses_volume), log_(log), pieces_(poly_index_bound(m)),
        face_use_(face_index_bound(m)), edge_use_(edge_index_bound(m)), vert_used_(vert_index_bound(m)),
        reported_edges_(edge_index_bound(m)), edge_walker_(m) {}

  mesh_facts check() {
    log_.begin_stage(0.3, num_polys(m_) + num_faces(m_));
    check_polys();
    check_faces();
    check_edges();
    check_verts();
    facts_.components = count_components();
    facts_.orientable = check_face_windings();
    check_boundary();
    return facts_;
  }
};

/// Result: the facts about the volume. Sets `encloses_volume`, by index: polys that are closed and wound consistently,
///         so that they have a volume.
template<VolumeMesh M>
mesh_facts check_volume(const M& m, std::vector<std::uint8_t>& encloses_volume, defect_log<M>& log) {
  return volume_checker<M>(m, encloses_volume, log).check();
}

}  // namespace concino::detail

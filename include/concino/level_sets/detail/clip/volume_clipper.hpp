// Cuts a volume along a level set.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/level_sets/clip_options.hpp>
#include <concino/level_sets/detail/clip/clip_verts.hpp>
#include <concino/level_sets/detail/clip/convex_cells.hpp>
#include <concino/level_sets/detail/cut/cell_parts.hpp>
#include <concino/level_sets/detail/cut/crossed_volume_reader.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// The polys of the result are those that are kept whole, in the order of m, and then parts of polys. Likewise faces.
template<class M, class U>
class volume_clipper {
  static constexpr std::uint32_t none = ~0u;

  const M& m_;
  double level_;
  bool both_;
  std::vector<unsigned char> states_;
  crossed_volume_reader<M> crossed_;
  cell_cuts cuts_;
  std::vector<poly_t<M>> whole_;
  std::vector<std::uint32_t> cut_;          // parts
  std::vector<std::uint32_t> face_number_;  // by index of the face in m
  std::vector<std::uint32_t> new_face_;     // by face of the parts
  clipped_volume<M> result_;

 public:
  volume_clipper(const M& m, const U& u, double level, bool both, const char* caller)
      : m_(m), level_(level), both_(both), states_(level_states(m, u, level, caller)),
        crossed_(m, u, level, crossed_polys(m, states_)),
        cuts_(crossed_.arrays, arity_v<M> > 0 ? cell_cuts::cells_are::spheres : cell_cuts::cells_are::unknown, caller,
              crossed_.poly_indices),
        face_number_(face_index_bound(m), none) {}

  clipped_volume<M> run(const clip_options& options, const char* caller) {
    report_concave_polys(options, caller);
    const cell_parts parts(cuts_);
    for (const std::uint32_t v : parts.moved_verts) result_.report.moved_verts.push_back(crossed_.verts[v]);
    report_progress(options.progress, 0.3, "clipping");
    clip_verts<M, crossed_volume> verts_of(m_, crossed_.arrays, parts.places, level_);
    choose_polys(parts, verts_of);
    choose_faces(parts, verts_of);
    number_faces(parts, verts_of);
    verts_of.number();
    verts_of.list([&](const level_place& x) { return crossed_.origins_of(x); });
    report_progress(options.progress, 0.5, "clipping");
    build(parts, verts_of);
    report_progress(options.progress, 0.8, "clipping");
    list_edge_origins();
    if (options.properties) transfer_if_any(m_, result_.mesh, result_.from);
    report_progress(options.progress, 1, "clipping");
    return std::move(result_);
  }

 private:
  /// A poly that no loop cuts does not count.
  void report_concave_polys(const clip_options& options, const char* caller) {
    std::vector<unsigned char> is_cut(crossed_.polys.size(), 0);
    for (const cell_cuts::loop& l : cuts_.loops()) is_cut[l.cell] |= l.cuts;
    for (std::uint32_t c = 0; c < is_cut.size(); ++c) {
      if (!is_cut[c]) continue;
      ++result_.report.cut_polys;
      if (is_convex_cell(crossed_.arrays, c)) continue;
      if (options.convex_only) throw_not_convex(caller, crossed_.poly_indices[c]);
      ++result_.report.concave_polys;
    }
  }

  void choose_polys(const cell_parts& parts, clip_verts<M, crossed_volume>& verts_of) {
    const auto keep = [&](const poly_t<M>& p, bool above) {
      if (!above && !both_) return;
      for (const vert_t<M> v : adj_p2v(m_, p)) verts_of.mark(v);
      for (const face_t<M> f : adj_p2f(m_, p)) face_number_[index_of(m_, f)] = 0;
      whole_.push_back(p);
      result_.above.push_back(above);
    };
    std::size_t next = 0, part = 0;
    for (const poly_t<M> p : polys(m_)) {
      if (next == crossed_.polys.size() || !(crossed_.polys[next] == p)) {
        const auto& all = adj_p2v(m_, p);
        const vert_t<M> first = *all.begin();
        keep(p, states_[index_of(m_, first)] != below_level);
        continue;
      }
      for (; part < parts.parts.size() && parts.parts[part].cell == next; ++part) {
        const cell_parts::part& x = parts.parts[part];
        if (x.is_whole) keep(p, x.is_above);
        else if (x.is_above || both_) cut_.push_back(static_cast<std::uint32_t>(part));
      }
      ++next;
    }
  }

  /// Marks the faces of parts, and their verts.
  void choose_faces(const cell_parts& parts, clip_verts<M, crossed_volume>& verts_of) {
    new_face_.assign(parts.faces.size(), none);
    for (const std::uint32_t i : cut_)
      for (std::uint32_t k = parts.parts[i].first; k < parts.parts[i].last; ++k) {
        const cell_parts::face& f = parts.faces[parts.part_faces[k]];
        if (f.is_whole) face_number_[f.origin] = 0;
        else new_face_[parts.part_faces[k]] = 0;
        for (std::uint32_t j = f.first; j < f.last; ++j) verts_of.mark_place(parts.face_places[j]);
      }
  }

  void number_faces(const cell_parts& parts, clip_verts<M, crossed_volume>& verts_of) {
    std::uint32_t n = 0;
    for (const face_t<M> f : faces(m_)) {
      std::uint32_t& number = face_number_[index_of(m_, f)];
      if (number == none) continue;
      number = n++;
      for (const vert_t<M> v : adj_f2v(m_, f)) verts_of.mark(v);
    }
    for (std::size_t i = 0; i < parts.faces.size(); ++i) {
      const cell_parts::face& f = parts.faces[i];
      if (f.is_whole) new_face_[i] = face_number_[f.origin];
      else if (new_face_[i] != none) new_face_[i] = n++;
      if (f.is_cut && new_face_[i] != none) result_.cut_faces.push_back(face_id{new_face_[i]});
    }
  }

  void build(const cell_parts& parts, clip_verts<M, crossed_volume>& verts_of) {
    polyhedra_arrays a;
    reserve(parts, a);
    a.face_offsets.push_back(0), a.poly_offsets.push_back(0);
    const auto end_face = [&](std::uint32_t origin) {
      a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
      result_.from.faces.add(origin);
    };
    for (const face_t<M> f : faces(m_)) {
      if (face_number_[index_of(m_, f)] == none) continue;
      for (const vert_t<M> v : adj_f2v(m_, f)) a.face_verts.push_back(verts_of.of(v));
      end_face(static_cast<std::uint32_t>(index_of(m_, f)));
    }
    for (std::size_t i = 0; i < parts.faces.size(); ++i) {
      const cell_parts::face& f = parts.faces[i];
      if (new_face_[i] == none || f.is_whole) continue;
      for (std::uint32_t k = f.first; k < f.last; ++k) a.face_verts.push_back(verts_of.of_place(parts.face_places[k]));
      end_face(f.origin);
    }
    const auto end_poly = [&] { a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size())); };
    for (const poly_t<M>& p : whole_) {
      for (const face_t<M> f : adj_p2f(m_, p)) {
        a.poly_faces.push_back(face_id{face_number_[index_of(m_, f)]});
        a.outward.push_back(face_is_outward(m_, p, f));
      }
      end_poly();
    }
    for (const std::uint32_t i : cut_) {
      const cell_parts::part& x = parts.parts[i];
      for (std::uint32_t k = x.first; k < x.last; ++k) {
        a.poly_faces.push_back(face_id{new_face_[parts.part_faces[k]]});
        a.outward.push_back(parts.outward[k]);
      }
      end_poly();
      result_.above.push_back(x.is_above);
    }
    a.points = std::move(verts_of.points);
    result_.mesh = polyhedralmesh(std::move(a));
    result_.from.verts = std::move(verts_of.origins);
    result_.from.polys = origins_of(m_, whole_);
    for (std::size_t i = 0; i < cut_.size(); ++i) {
      const double size = volume(result_.mesh, poly_id{whole_.size() + i});
      if (!(size > 0)) ++result_.report.inverted_parts;
      result_.from.polys.add({origin{crossed_.poly_indices[parts.parts[cut_[i]].cell], size > 0 ? size : 0}});
    }
  }

  void reserve(const cell_parts& parts, polyhedra_arrays& a) const {
    std::size_t num_faces = 0, num_corners = 0, num_poly_faces = parts.part_faces.size();
    for (const face_t<M> f : faces(m_))
      if (face_number_[index_of(m_, f)] != none) ++num_faces, num_corners += num_elements(adj_f2v(m_, f));
    for (const poly_t<M>& p : whole_) num_poly_faces += num_elements(adj_p2f(m_, p));
    a.face_offsets.reserve(num_faces + parts.faces.size() + 1),
        a.face_verts.reserve(num_corners + parts.face_places.size());
    a.poly_offsets.reserve(whole_.size() + cut_.size() + 1), a.poly_faces.reserve(num_poly_faces),
        a.outward.reserve(num_poly_faces);
  }

  /// As match_edges_and_faces does it. Most edges have two verts of m, and are found at once.
  void list_edge_origins() {
    const elements_by_index<vert_t<M>> by_index(m_, verts(m_), vert_index_bound(m_));
    single_origins found(edge_index_bound(result_.mesh));
    for (const edge_id e : edges(result_.mesh)) {
      const auto ends = end_verts(result_.mesh, e);
      const std::uint32_t a = result_.from.verts.only(ends.first.raw()), b = result_.from.verts.only(ends.second.raw());
      if (a != none && b != none && a != b) found.set(e.raw(), find_edge(m_, by_index, a, b));
      else found.set(e.raw(), match_edge(m_, result_.mesh, result_.from.verts, by_index, e));
    }
    result_.from.edges = std::move(found).collect();
  }
};

}  // namespace concino::detail

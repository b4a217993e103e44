// Cuts a volume along a level set.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/core/large_pages.hpp>
#include <concino/core/parallel.hpp>
#include <concino/core/precompiled.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/level_sets/clip_options.hpp>
#include <concino/level_sets/detail/clip_edges.hpp>
#include <concino/level_sets/detail/clip_parts.hpp>
#include <concino/level_sets/detail/clip_verts.hpp>
#include <concino/level_sets/detail/whole_polys.hpp>

#include <algorithm>
#include <concepts>
#include <optional>
#include <utility>
#include <vector>

namespace concino::detail {

/// Whether M is stored as a polyhedralmesh is, so that lists of its tables can be copied.
template<class M>
concept has_polyhedra_tables = core::is_native<M> && requires(const M& m) { { traits<M>::tables(m) } -> std::same_as<const polyhedra_tables&>; };

/// The polys of the result are those that are kept whole, in the order of m, and then parts of polys. Likewise faces.
template<class M, class U>
class volume_clipper {
  static constexpr unsigned char of_part_only = 2;  // in whole_.has_face: a face of a part, and of no poly that is kept
  const M& m_;
  double level_;
  bool both_;
  std::vector<std::uint32_t> face_number_;  // by index of the face in m
  std::optional<clip_parts<M>> crossed_;    // uses face_number_ until it is destroyed
  whole_polys<M> whole_;
  std::vector<std::uint32_t> cut_;          // parts
  std::vector<std::uint32_t> cut_origins_;  // by entry of cut_: the index of the poly in m
  kept_polyhedra kept_;                     // what the result has in common with m; without lists unless extends_tables()
  std::vector<std::uint32_t> new_face_;     // by face of the parts
  std::size_t num_faces_ = 0, num_corners_ = 0, num_poly_faces_ = 0;  // of the result
  polyhedra_arrays a_;
  clipped_volume<M> result_;

 public:
  volume_clipper(const M& m, const U& u, double level, bool both, const char* caller) : m_(m), level_(level), both_(both), whole_(m, both) {
    const state_array of_verts = level_states(m, u, level, caller), of_polys = poly_states(m, of_verts);
    face_number_ = core::large_vector(face_index_bound(m), ~0u);
    crossed_.emplace(m, u, level, of_verts.data(), of_polys.data(), face_number_.data(), crossed_by_state(m, of_polys));
    core::run_both(has_many_polys(m), [&] { crossed_->cut(m, u, both, caller); }, [&] { whole_.list(of_polys); });
  }

  clipped_volume<M> run(const clip_options& options, const char* caller) {
    report_concave_polys(options, caller);
    result_.report.moved_verts = std::move(crossed_->moved_verts);
    report_progress(options.progress, 0.3, "clipping");
    const std::vector<level_place> places = std::move(crossed_->lists.places);
    choose_parts(crossed_->lists);
    clip_verts<M, place_ends> verts_of(m_, crossed_->ends, places, level_, std::move(whole_.vert_numbers));
    choose_faces(crossed_->lists, verts_of);
    number_faces(crossed_->lists, verts_of);
    verts_of.number();
    const auto list_faces = [&] { build_faces(crossed_->lists, verts_of); };
    const auto list_polys = [&] { build_polys(crossed_->lists); };
    const auto list_verts = [&] {
      verts_of.list([&](const level_place& x, std::vector<origin>& list) { crossed_->list_origins(x, list); });
    };
    const auto number_polys = [&] { number_whole_polys(); };
    core::run_all(has_many_polys(m_), {list_faces, list_polys, list_verts, number_polys});
    a_.points = std::move(verts_of.points);
    result_.from.verts = std::move(verts_of.origins);
    crossed_.reset();  // its memory can be used for the mesh
    core::release(new_face_), core::release(whole_.polys);
    report_progress(options.progress, 0.5, "clipping");
    build_mesh(verts_of);
    report_progress(options.progress, 0.8, "clipping");
    const auto list_edge_origins = [&] { result_.from.edges = clip_edges<M>(m_, result_.mesh, result_.from.verts, verts_of).list(kept_.edges); };
    core::run_both(has_many_polys(m_), list_edge_origins, [&] { list_poly_origins(); });
    if (options.properties) transfer_if_any(m_, result_.mesh, result_.from);
    report_progress(options.progress, 1, "clipping");
    return std::move(result_);
  }

 private:
  void report_concave_polys(const clip_options& options, const char* caller) {
    for (std::size_t c = 0; c < crossed_->is_cut.size(); ++c) {
      if (!crossed_->is_cut[c]) continue;
      ++result_.report.cut_polys;
      if (crossed_->is_convex[c]) continue;
      if (options.convex_only) throw_not_convex(caller, crossed_->poly_indices[c]);
      ++result_.report.concave_polys;
    }
  }

  /// The index of a face of a part that is a face of m; ~0 if it is not.
  static std::uint32_t whole_face(const part_lists& parts, std::uint32_t f) {
    if (f & part_lists::of_mesh) return f & ~part_lists::of_mesh;
    return parts.faces[f].is_whole ? parts.faces[f].origin : ~0u;
  }

  void choose_parts(const part_lists& parts) {
    std::vector<typename whole_polys<M>::inserted_poly> whole;
    for (std::size_t i = 0; i < parts.parts.size(); ++i) {
      const part_lists::part& x = parts.parts[i];
      if (!x.is_above && !both_) continue;
      if (x.is_whole) whole.push_back({x.cell, x.is_above});
      else cut_.push_back(static_cast<std::uint32_t>(i));
    }
    whole_.insert(whole);
    result_.above = std::move(whole_.above);
  }

  void choose_faces(const part_lists& parts, clip_verts<M, place_ends>& verts_of) {
    num_poly_faces_ = whole_.num_faces;
    new_face_ = core::large_vector(parts.faces.size(), ~0u);
    for (const std::uint32_t i : cut_)
      for (std::uint32_t k = parts.parts[i].first; k < parts.parts[i].last; ++k, ++num_poly_faces_) {
        const std::uint32_t f = parts.part_faces[k];
        if (const std::uint32_t whole = whole_face(parts, f); whole != ~0u) {
          if (!whole_.has_face[whole]) whole_.has_face[whole] = of_part_only;
          continue;
        }
        if (new_face_[f] == ~0u) ++num_faces_, num_corners_ += parts.faces[f].last - parts.faces[f].first;
        new_face_[f] = 0;
        for (std::uint32_t j = parts.faces[f].first; j < parts.faces[f].last; ++j) verts_of.mark_place(parts.face_places[j]);
      }
  }

  void number_faces(const part_lists& parts, clip_verts<M, place_ends>& verts_of) {
    std::uint32_t n = 0;
    for (const face_t<M> f : faces(m_)) {
      const std::size_t index = index_of(m_, f);
      if (!whole_.has_face[index]) continue;
      face_number_[index] = n++;
      const auto& ring = adj_f2v(m_, f);
      num_corners_ += num_elements(ring);
      if (whole_.has_face[index] == of_part_only)
        for (const vert_t<M> v : ring) verts_of.mark(v);
    }
    num_faces_ += n;
    kept_.num_faces = n;
    for (std::size_t i = 0; i < parts.faces.size(); ++i) {
      const part_lists::face& f = parts.faces[i];
      if (new_face_[i] != ~0u) new_face_[i] = n++;
      else if (f.is_whole && f.is_cut) new_face_[i] = face_number_[f.origin];
      if (f.is_cut && new_face_[i] != ~0u) result_.cut_faces.push_back(face_id{new_face_[i]});
    }
  }

  /// Lists the verts and the origins of the faces.
  void build_faces(const part_lists& parts, const clip_verts<M, place_ends>& verts_of) {
    core::reserve_exact(a_.face_offsets, num_faces_ + 1), core::reserve_exact(a_.face_verts, num_corners_);
    a_.face_offsets.resize(num_faces_ + 1), a_.face_verts.resize(num_corners_);
    std::vector<std::uint32_t> origins;
    core::reserve_exact(origins, num_faces_);
    origins.resize(num_faces_);
    std::uint32_t n = 0, end = 0;
    std::uint32_t *const ends = a_.face_offsets.data() + 1, *const from = origins.data();
    vert_id* const corners = a_.face_verts.data();
    const auto end_face = [&](std::uint32_t origin) {
      ends[n] = end;
      from[n++] = origin;
    };
    for (const face_t<M> f : faces(m_)) {
      const auto index = static_cast<std::uint32_t>(index_of(m_, f));
      if (face_number_[index] == ~0u) continue;
      for (const vert_t<M> v : adj_f2v(m_, f)) corners[end++] = verts_of.of(v);
      end_face(index);
    }
    for (std::size_t i = 0; i < parts.faces.size(); ++i) {
      const part_lists::face& f = parts.faces[i];
      if (new_face_[i] == ~0u || new_face_[i] < kept_.num_faces) continue;
      for (std::uint32_t k = f.first; k < f.last; ++k) corners[end++] = verts_of.of_place(parts.face_places[k]);
      end_face(f.origin);
    }
    result_.from.faces = element_origins(std::move(origins));
  }

  /// Calls use(f, whether f is outward) for each face of p.
  template<class Use>
  void for_each_face(const poly_t<M>& p, const Use& use) const {
    if constexpr (has_polyhedra_tables<M>) {
      const std::uint8_t* is_outward = traits<M>::tables(m_).outward_flags(p).begin();
      for (const face_t<M> f : adj_p2f(m_, p)) use(f, *is_outward++ != 0);
    } else {
      for (const face_t<M> f : adj_p2f(m_, p)) use(f, face_is_outward(m_, p, f));
    }
  }

  void build_polys(const part_lists& parts) {
    const std::size_t num_polys = whole_.polys.size() + cut_.size();
    core::reserve_exact(a_.poly_offsets, num_polys + 1), core::reserve_exact(a_.poly_faces, num_poly_faces_), core::reserve_exact(a_.outward, num_poly_faces_);
    a_.poly_offsets.resize(num_polys + 1), a_.poly_faces.resize(num_poly_faces_), a_.outward.resize(num_poly_faces_);
    std::uint32_t end = 0, *next_end = a_.poly_offsets.data() + 1;
    face_id* const faces_of = a_.poly_faces.data();
    unsigned char* const outward = a_.outward.data();
    for (const poly_t<M>& p : whole_.polys) {
      for_each_face(p, [&](const face_t<M>& f, bool is_outward) {
        faces_of[end] = face_id{face_number_[index_of(m_, f)]};
        outward[end++] = is_outward;
      });
      *next_end++ = end;
    }
    for (const std::uint32_t i : cut_) {
      for (std::uint32_t k = parts.parts[i].first; k < parts.parts[i].last; ++k) {
        const std::uint32_t f = parts.part_faces[k], whole = whole_face(parts, f);
        faces_of[end] = face_id{whole != ~0u ? face_number_[whole] : new_face_[f]};
        outward[end++] = parts.outward[k];
      }
      *next_end++ = end;
      result_.above.push_back(parts.parts[i].is_above);
      cut_origins_.push_back(crossed_->poly_indices[parts.parts[i].cell]);
    }
  }

  void number_whole_polys() {
    result_.from.polys = origins_of(m_, whole_.polys);
    if (!extends_tables()) return;
    kept_.num_polys = static_cast<std::uint32_t>(whole_.polys.size());
    kept_.polys = core::large_vector(poly_index_bound(m_), ~0u);
    for (std::size_t i = 0; i < whole_.polys.size(); ++i) kept_.polys[index_of(m_, whole_.polys[i])] = static_cast<std::uint32_t>(i);
  }

  /// Whether most adjacencies of the result are those of m with other numbers, and can be copied.
  bool extends_tables() const {
    if constexpr (has_polyhedra_tables<M>) return traits<M>::tables(m_).can_be_extended();
    else return false;
  }
  void build_mesh(clip_verts<M, place_ends>& verts_of) {
    if constexpr (has_polyhedra_tables<M>)
      if (extends_tables()) {
        kept_.verts = verts_of.take_numbers();
        kept_.faces = std::move(face_number_);
        kept_.num_verts = verts_of.num_kept();
        result_.mesh.tables() = polyhedra_tables(traits<M>::tables(m_), kept_, a_.points.size(), std::move(a_.face_offsets), std::move(a_.face_verts),
                                                 std::move(a_.poly_offsets), std::move(a_.poly_faces), std::move(a_.outward));
        result_.mesh.points() = std::move(a_.points);
        kept_.verts = {}, kept_.faces = {}, kept_.polys = {};
        return;
      }
    core::release(face_number_);
    result_.mesh = polyhedralmesh(std::move(a_));
  }

  void list_poly_origins() {
    const std::size_t num_whole = result_.from.polys.size();
    for (std::size_t i = 0; i < cut_origins_.size(); ++i) {
      const double size = volume(result_.mesh, poly_id{num_whole + i});
      if (!(size > 0)) ++result_.report.inverted_parts;
      result_.from.polys.add({origin{cut_origins_[i], size > 0 ? size : 0}});
    }
  }
};

}  // namespace concino::detail

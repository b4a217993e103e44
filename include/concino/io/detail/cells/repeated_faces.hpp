// Collapses or skips polyhedra of which a face has a vert twice, in arrays of verts, faces and polyhedra.
#pragma once

#include <concino/io/detail/cells/repeated_verts.hpp>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// Replaces faces with a vert twice by what stays of them, and drops polys as repeated.policy says. Faces that only
/// dropped polys have had are dropped too. The other faces and polys keep their order.
template<std::same_as<polyhedra_arrays> Arrays>  // a template only so that programs without volumes need not compile it
class faces_mender {
  Arrays& m_;
  polys_with_repeats& repeated_;
  std::vector<std::vector<std::vector<vert_id>>> parts_;  // of each face with a vert twice, what stays; by number_
  std::vector<std::uint32_t> number_;                     // of each face in parts_; ~0u: it stays as it is
  std::vector<face_id> list_;                             // the faces of a poly, and whether they are outward
  std::vector<std::uint8_t> outward_;

  static std::vector<vert_id> verts_of(const polyhedra_arrays& m, std::size_t f) {
    return {m.face_verts.data() + m.face_offsets[f], m.face_verts.data() + m.face_offsets[f + 1]};
  }

  void collapse_face(std::size_t f) {
    std::vector<std::uint64_t> scratch;
    cycle_collapser collapse;
    const std::vector<vert_id> given = verts_of(m_, f);
    number_[f] = static_cast<std::uint32_t>(parts_.size());
    std::vector<std::vector<vert_id>>& parts = parts_.emplace_back();
    if (repeated_.policy == repeated_verts::skip) return;
    std::vector<vert_id> face;
    for (const std::uint32_t i : collapse(given.data(), given.size())) face.push_back(given[i]);
    if (face.size() < 3) return;
    if (first_repeated(face.data(), face.size(), scratch) == face.size()) return parts.push_back(std::move(face));
    const std::vector<vert_id> triangles = cut_cycle(std::move(face), m_.points);
    for (std::size_t i = 0; i < triangles.size(); i += 3)
      parts.push_back({triangles[i], triangles[i + 1], triangles[i + 2]});
  }

  /// Removes pairs of faces with the same verts, between which nothing is left.
  void cancel_equal_faces(const polyhedra_arrays& out) {
    std::vector<std::vector<vert_id>> sorted;
    for (std::size_t k = 0; k < list_.size();) {
      std::vector<vert_id> ids = verts_of(out, list_[k].raw());
      std::sort(ids.begin(), ids.end());
      const auto same = std::find(sorted.begin(), sorted.end(), ids);
      if (same == sorted.end()) {
        sorted.push_back(std::move(ids));
        ++k;
        continue;
      }
      const auto first = same - sorted.begin(), second = static_cast<std::ptrdiff_t>(k);
      sorted.erase(same);
      for (const std::ptrdiff_t i : {second, first})
        list_.erase(list_.begin() + i), outward_.erase(outward_.begin() + i);
      --k;
    }
  }

  /// Drops the faces of which `keeps` is false.
  static void drop_faces(polyhedra_arrays& out, const std::vector<bool>& keeps) {
    std::vector<std::uint32_t> face_ends{0}, number(keeps.size(), 0);
    std::vector<vert_id> ids;
    for (std::size_t f = 0; f < keeps.size(); ++f) {
      if (!keeps[f]) continue;
      number[f] = static_cast<std::uint32_t>(face_ends.size() - 1);
      for (std::uint32_t i = out.face_offsets[f]; i < out.face_offsets[f + 1]; ++i) ids.push_back(out.face_verts[i]);
      face_ends.push_back(static_cast<std::uint32_t>(ids.size()));
    }
    for (face_id& f : out.poly_faces) f = face_id{number[f.raw()]};
    out.face_offsets = std::move(face_ends);
    out.face_verts = std::move(ids);
  }

 public:
  faces_mender(Arrays& m, polys_with_repeats& repeated) : m_(m), repeated_(repeated), number_(m.num_faces(), ~0u) {}

  void mend() {
    std::vector<std::uint64_t> scratch;
    polyhedra_arrays out;
    std::vector<std::uint32_t> first_part;  // the number in `out` of each face, or of what stays of it
    out.face_offsets.push_back(0);
    for (std::size_t f = 0; f < m_.num_faces(); ++f) {
      const std::vector<vert_id> face = verts_of(m_, f);
      if (first_repeated(face.data(), face.size(), scratch) != face.size()) collapse_face(f);
      first_part.push_back(static_cast<std::uint32_t>(out.num_faces()));
      const auto push = [&](const std::vector<vert_id>& ids) {
        out.face_verts.insert(out.face_verts.end(), ids.begin(), ids.end());
        out.face_offsets.push_back(static_cast<std::uint32_t>(out.face_verts.size()));
      };
      if (number_[f] == ~0u) push(face);
      else
        for (const std::vector<vert_id>& part : parts_[number_[f]]) push(part);
    }
    out.poly_offsets.push_back(0);
    std::vector<bool> was_used(out.num_faces()), is_used(out.num_faces());
    for (std::size_t p = 0; p < m_.num_polys(); ++p) {
      bool is_changed = false;
      list_.clear();
      outward_.clear();
      for (std::uint32_t i = m_.poly_offsets[p]; i < m_.poly_offsets[p + 1]; ++i) {
        const std::size_t f = m_.poly_faces[i].raw(), n = number_[f] == ~0u ? 1 : parts_[number_[f]].size();
        is_changed = is_changed || number_[f] != ~0u;
        for (std::size_t k = first_part[f]; k < first_part[f] + n; ++k)
          list_.push_back(face_id{k}), outward_.push_back(m_.outward[i]), was_used[k] = true;
      }
      if (is_changed) {
        repeated_.add(p, [] { return std::string(); });
        const bool is_skipped = repeated_.policy == repeated_verts::skip;
        if (!is_skipped) cancel_equal_faces(out);
        if (is_skipped || list_.size() < 4) {
          if (!is_skipped) repeated_.add_vanished();
          repeated_.dropped.push_back(static_cast<std::uint32_t>(p));
          continue;
        }
      }
      for (const face_id f : list_) is_used[f.raw()] = true;
      out.poly_faces.insert(out.poly_faces.end(), list_.begin(), list_.end());
      out.outward.insert(out.outward.end(), outward_.begin(), outward_.end());
      out.poly_offsets.push_back(static_cast<std::uint32_t>(out.poly_faces.size()));
    }
    for (std::size_t f = 0; f < is_used.size(); ++f) is_used[f] = is_used[f] || !was_used[f];
    drop_faces(out, is_used);
    out.points = std::move(m_.points);
    m_ = std::move(out);
  }
};

}  // namespace concino::detail

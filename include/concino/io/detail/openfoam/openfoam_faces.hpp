// Reads the points and faces of a polyMesh folder.
#pragma once

#include <concino/io/detail/cells/repeated_verts.hpp>
#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/openfoam/foam_entries.hpp>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

namespace concino::detail {

/// Fills the points and faces of arrays. A template only so that programs that read no volumes need not compile it.
template<std::same_as<polyhedra_arrays> Arrays>
class openfoam_faces {
  const read_context& context_;

  void end_face(foam_cursor& in, const char* position, std::size_t first, std::vector<std::uint64_t>& scratch) {
    const std::size_t size = mesh.face_verts.size() - first;
    if (size < 3) in.reject(position, {"a face of at least three points"}, {"one of ", size});
    if (mesh.face_verts.size() > max_ids) in.fail_to_count("corners of faces");
    const vert_id* const v = mesh.face_verts.data() + first;
    if (const std::size_t i = first_repeated(v, size, scratch); i != size) {
      if (context_.repeated_verts == repeated_verts::refuse)
        in.reject(position, {"different points at the corners of a face", repeated_verts_hint},
                  {"point ", v[i].raw(), " twice"});
      has_repeated = true;
    }
    mesh.face_offsets.push_back(static_cast<std::uint32_t>(mesh.face_verts.size()));
  }

  void add_corner(const foam_cursor& in, const char* position, std::int64_t v) {
    if (static_cast<std::uint64_t>(v) >= mesh.points.size())
      in.reject(position, {"the number of a point, below ", mesh.points.size()}, {v});
    mesh.face_verts.push_back(vert_id{static_cast<std::uint32_t>(v)});
  }

  /// A list of lists of points.
  void listed_faces(foam_cursor& in) {
    std::vector<std::uint64_t> scratch;
    const std::uint64_t n = in.next_count("the number of faces", max_ids);
    mesh.face_offsets.reserve(n + 1);
    if (n == 0 && in.at_end()) return;
    in.require('(', "the '(' of the list of faces");
    for (std::uint64_t f = 0; f < n; ++f) {
      in.skip();
      const char* const position = in.at;
      const std::size_t first = mesh.face_verts.size();
      in.read_labels(
          "the number of points of a face", max_ids, [](std::uint64_t) {},
          [&](const char* at, std::int64_t v) { add_corner(in, at, v); });
      end_face(in, position, first, scratch);
      in.report_progress();
    }
    in.require(')', "the ')' after the last face");
  }

  /// The list of the first corner of each face, then that of all corners.
  void compact_faces(foam_cursor& in) {
    std::vector<std::uint64_t> scratch;
    std::vector<std::uint32_t> begins;
    in.skip();
    const char* const offsets_at = in.at;
    in.read_labels(
        "the number of faces and 1", max_ids, [&](std::uint64_t n) { begins.reserve(n); },
        [&](const char* position, std::int64_t i) {
          if (i < (begins.empty() ? 0 : begins.back()) || i > std::int64_t{max_ids} || (begins.empty() && i != 0))
            in.reject(position, {"the first corner of a face, which begins with 0 and does not decrease"}, {i});
          begins.push_back(static_cast<std::uint32_t>(i));
        });
    in.skip();
    const char* const corners_at = in.at;
    if (begins.empty()) begins.push_back(0);
    mesh.face_offsets.reserve(begins.size());
    std::size_t first = 0;
    in.read_labels(
        "the number of corners of all faces", begins.back(),
        [&](std::uint64_t n) {
          if (n != begins.back()) in.fail(corners_at, {"as many corners as the faces have, ", begins.back()}, {n});
          for (std::size_t f = 0; f + 1 < begins.size(); ++f)
            if (begins[f + 1] - begins[f] < 3)
              in.fail(offsets_at, {"faces of at least three points"}, {"face ", f, " of ", begins[f + 1] - begins[f]});
          mesh.face_verts.reserve(n);
        },
        [&](const char* position, std::int64_t v) {
          add_corner(in, position, v);
          if (mesh.face_verts.size() == begins[mesh.face_offsets.size()])
            end_face(in, position, first, scratch), first = mesh.face_verts.size();
        });
  }

 public:
  Arrays mesh;
  bool has_repeated = false;  // a face has a vert twice

  explicit openfoam_faces(const read_context& c) : context_(c) {
    mesh.face_offsets.push_back(0);
    mesh.poly_offsets.push_back(0);
  }

  void read_points(foam_cursor& in) {
    read_foam_header(in);
    in.read_vectors(
        "the number of points", max_ids, [&](std::uint64_t n) { mesh.points.reserve(std::min(n, in.left() / 6 + 1)); },
        [&](double x, double y, double z) {
          mesh.points.push_back({x, y, z});
        });
    in.require_end("the end of the file after the list");
  }

  void read_faces(foam_cursor& in) {
    const std::string class_name = read_foam_header(in);
    if (class_name == "faceCompactList") compact_faces(in);
    else if (class_name == "faceList") listed_faces(in);
    else in.fail(in.at, {"the class faceList or faceCompactList"}, {"'", class_name, "'"});
    in.require_end("the end of the file after the list");
  }
};

}  // namespace concino::detail

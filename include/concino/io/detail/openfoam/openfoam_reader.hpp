// Builds a mesh from the files of a polyMesh folder, one after another.
#pragma once

#include <concino/io/detail/cells/repeated_faces.hpp>
#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/openfoam/foam_entries.hpp>
#include <concino/io/detail/openfoam/openfoam_cells.hpp>
#include <concino/io/detail/openfoam/openfoam_faces.hpp>
#include <concino/io/label_names.hpp>
#include <concino/mesh/support/limits.hpp>

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace concino::detail {

/// Reads the files in the order points, faces, owner, neighbour, boundary, cellZones. Contents is volume_contents; a
/// template only so that programs that read no volumes need not compile it.
template<std::same_as<volume_contents> Contents>
class openfoam_reader {
  const read_context& context_;
  openfoam_faces<polyhedra_arrays> faces_;
  polyhedra_arrays& mesh_ = faces_.mesh;
  std::vector<std::uint32_t> owner_, neighbour_;  // of each face, and of each inner face
  std::size_t num_cells_ = 0;
  std::vector<int> face_labels_, cell_labels_;
  label_names names_;
  polys_with_repeats repeated_;

  load_report& report() const { return *context_.report; }

  /// The cells of each face of a file owner or neighbour. The label -1 is passed on.
  void cells_of_faces(foam_cursor& in, const char* what, std::vector<std::uint32_t>& cells) {
    const std::size_t num_faces = mesh_.num_faces(), bound = 2 * num_faces;
    in.read_labels(
        what, num_faces, [&](std::uint64_t n) { cells.reserve(n); },
        [&](const char* position, std::int64_t c) {
          if (c < -1 || c >= static_cast<std::int64_t>(bound))
            in.reject(position, {"the number of a cell that has a face, from 0 to ", bound - 1}, {c});
          check_cell(in, position, cells.size(), c);
          cells.push_back(static_cast<std::uint32_t>(c));
          in.report_progress();
        });
    in.require_end("the end of the file after the list");
  }
  /// For owner: there is a cell. For neighbour: it is another one than the owner, or -1 after the last inner face.
  void check_cell(const foam_cursor& in, const char* position, std::size_t f, std::int64_t c) const {
    if (owner_.size() < mesh_.num_faces()) {
      if (c < 0) in.reject(position, {"the number of a cell"}, {c});
    } else if (c == std::int64_t{owner_[f]}) {
      in.reject(position, {"a cell that is not the owner of the face"}, {c});
    } else if (c >= 0 && !neighbour_.empty() && neighbour_.back() == ~0u) {
      in.reject(position, {"-1 for all faces after the first one with -1"}, {c});
    }
  }

 public:
  explicit openfoam_reader(const read_context& c) : context_(c), faces_(c) { repeated_.policy = c.repeated_verts; }
  openfoam_reader(const openfoam_reader&) = delete;
  openfoam_reader& operator=(const openfoam_reader&) = delete;

  void read_points(foam_cursor& in) { faces_.read_points(in); }
  void read_faces(foam_cursor& in) { faces_.read_faces(in); }

  void read_owner(foam_cursor& in) {
    read_foam_header(in);
    in.skip();
    const char* const list = in.at;
    cells_of_faces(in, "the number of faces", owner_);
    if (owner_.size() != mesh_.num_faces())
      in.fail(list, {"the owner of each of the ", mesh_.num_faces(), " faces"}, {owner_.size(), " owners"});
  }

  /// Needs: the owners. Counts the cells.
  void read_neighbour(foam_cursor& in) {
    read_foam_header(in);
    in.skip();
    const char* const list = in.at;
    cells_of_faces(in, "the number of inner faces", neighbour_);
    while (!neighbour_.empty() && neighbour_.back() == ~0u) neighbour_.pop_back();
    std::vector<std::uint32_t> num_faces_of;  // of each cell
    const auto count = [&](const std::vector<std::uint32_t>& cells) {
      for (const std::uint32_t c : cells) {
        if (c >= num_faces_of.size()) num_faces_of.resize(std::size_t{c} + 1);
        ++num_faces_of[c];
      }
    };
    count(owner_);
    count(neighbour_);
    num_cells_ = num_faces_of.size();
    for (std::size_t c = 0; c < num_cells_; ++c)
      if (num_faces_of[c] == 0)
        in.fail(list, {"an owner or neighbour that is cell ", c, ", as there is a cell ", num_cells_ - 1}, {"none"});
    if (owner_.size() + neighbour_.size() > max_ids) in.fail_to_count("faces of polyhedra");
    make_polys(num_faces_of);
    std::uint64_t corners = 0;
    for (const face_id f : mesh_.poly_faces)
      corners += mesh_.face_offsets[f.raw() + std::size_t{1}] - mesh_.face_offsets[f.raw()];
    check_poly_corners(corners, mesh_.face_verts.size(), mesh_.poly_faces.size(), core::joined({in.name(), ": "}));
  }

  /// The patches: ranges of faces after the inner ones.
  void read_boundary(foam_cursor& in) {
    read_foam_header(in);
    int label = 0;
    std::size_t covered = 0;
    const std::size_t num_faces = mesh_.num_faces(), num_inner = neighbour_.size();
    for_each_foam_dictionary(in, "the number of patches", [&](std::string_view name, const char* position) {
      concino::label_name patch{element_kind::face, ++label, std::string(name)};
      std::int64_t first = -1, size = -1;
      for_each_foam_entry(in, [&](std::string_view key, const char*) {
        if (key != "nFaces" && key != "startFace") return patch.lines.push_back(foam_line(key, next_foam_value(in)));
        (key == "nFaces" ? size : first) = in.next_integer("a number of faces");
        in.require(';', "the ';' of an entry");
      });
      if (first < 0 || size < 0) in.fail(position, {"a patch with nFaces and startFace"}, {"'", name, "'"});
      const auto inner = static_cast<std::int64_t>(num_inner), all = static_cast<std::int64_t>(num_faces);
      if (size > 0 && (first < inner || first > all || size > all - first))
        in.fail(position, {"a patch of faces from ", num_inner, " to below ", num_faces},
                {"'", name, "' of ", size, " faces from ", first, " on"});
      if (size > 0 && face_labels_.empty()) face_labels_.resize(num_faces);
      for (std::int64_t f = first; f < first + size; ++f) {
        int& of_face = face_labels_[static_cast<std::size_t>(f)];
        if (of_face != 0) in.fail(position, {"a patch of faces that no other has"}, {"'", name, "', with face ", f});
        of_face = label;
      }
      covered += static_cast<std::size_t>(size);
      names_.names.push_back(std::move(patch));
    });
    in.require_end("the end of the file after the list");
    if (covered < num_faces - num_inner)
      report().notes.push_back(core::joined({num_faces - num_inner - covered, " boundary faces belong to no patch"}));
  }

  void read_cell_zones(foam_cursor& in) {
    read_foam_header(in);
    int label = 0;
    std::size_t num_repeated = 0;
    for_each_foam_dictionary(in, "the number of zones", [&](std::string_view name, const char*) {
      concino::label_name zone{element_kind::poly, ++label, std::string(name)};
      bool is_found = false;
      for_each_foam_entry(in, [&](std::string_view key, const char*) {
        if (key != "cellLabels") return zone.lines.push_back(foam_line(key, next_foam_value(in)));
        is_found = true;
        in.read_labels(
            "the number of cells", num_cells_,
            [&](std::uint64_t n) {
              if (n) cell_labels_.resize(num_cells_);
            },
            [&](const char* position, std::int64_t c) {
              if (c < 0 || c >= static_cast<std::int64_t>(num_cells_))
                in.reject(position, {"the number of a cell, below ", num_cells_}, {c});
              int& of_cell = cell_labels_[static_cast<std::size_t>(c)];
              if (of_cell == 0) of_cell = label;
              else ++num_repeated;
            });
        in.require(';', "the ';' of an entry");
      });
      if (!is_found) report().skipped.push_back(core::joined({"the zone ", name, ", which lists no cellLabels"}));
      names_.names.push_back(std::move(zone));
    });
    if (num_repeated)
      report().skipped.push_back(core::joined(
          {num_repeated, " entries of cellZones: these cells are in several zones, and have the label of the first"}));
  }

  /// Moves the mesh and its labels into the contents.
  /// Errors: parse_error if the wanted mesh cannot hold a cell; its file is called `name`.
  void finish(std::string_view name, Contents& out) {
    const bool may_be_cells = context_.wanted.cells, may_be_polyhedra = context_.wanted.polyhedra;
    const bool in_order = !faces_.has_repeated && may_be_polyhedra;
    if (!in_order || may_be_cells) list_labelled_faces(out);
    if (faces_.has_repeated) faces_mender<polyhedra_arrays>(mesh_, repeated_).mend();
    report().reoriented_polys = orient_polyhedra(mesh_);
    if (report().reoriented_polys)
      report().notes.push_back(
          core::joined({report().reoriented_polys, " of ", mesh_.num_polys(),
                        " cells were wound inconsistently or inside out: their faces were turned outward"}));
    out.filled = arrays_kind::polyhedra;
    if (may_be_cells) {
      const std::size_t equal = num_equal_faces(mesh_);
      const cells_of_polyhedra found(mesh_, context_.wanted.arity);
      const bool fits = found.num_fitting == mesh_.num_polys();
      if (!fits && !may_be_polyhedra) found.fail(name, mesh_);
      if (fits && !(may_be_polyhedra && (equal != 0 || mesh_.num_polys() == 0))) {
        out.filled = arrays_kind::cells;
        out.cells = {std::move(mesh_.points), std::move(found.verts), found.arity};
        report().skipped.push_back("the numbering of the faces");
        if (equal)
          report().skipped.push_back(core::joined({equal, " faces with the points of another face, which become one"}));
      }
    }
    if (out.filled == arrays_kind::polyhedra) {
      if (in_order) out.faces = {};
      out.lists_all_faces = in_order;
      out.polyhedra = std::move(mesh_);
    }
    store_labels(out);
    out.repeated = std::move(repeated_);
  }

 private:
  void make_polys(const std::vector<std::uint32_t>& num_faces_of) {
    mesh_.poly_offsets.reserve(num_cells_ + 1);
    for (const std::uint32_t n : num_faces_of) mesh_.poly_offsets.push_back(mesh_.poly_offsets.back() + n);
    std::vector<std::uint32_t> next(mesh_.poly_offsets.begin(), mesh_.poly_offsets.end());
    mesh_.poly_faces.resize(mesh_.poly_offsets.back());
    mesh_.outward.resize(mesh_.poly_offsets.back());
    for (std::size_t f = 0; f < owner_.size(); ++f) {
      const auto add = [&](std::uint32_t cell, bool is_outward) {
        mesh_.poly_faces[next[cell]] = face_id{static_cast<std::uint32_t>(f)};
        mesh_.outward[next[cell]++] = is_outward;
      };
      add(owner_[f], true);
      if (f < neighbour_.size()) add(neighbour_[f], false);
    }
  }

  void list_labelled_faces(Contents& out) const {
    for (std::size_t f = 0; f < face_labels_.size(); ++f) {
      if (face_labels_[f] == 0) continue;
      out.faces.verts.insert(out.faces.verts.end(), mesh_.face_verts.begin() + mesh_.face_offsets[f],
                             mesh_.face_verts.begin() + mesh_.face_offsets[f + 1]);
      out.faces.end_element();
    }
  }

  void store_labels(Contents& out) {
    if (!face_labels_.empty()) {
      if (!out.lists_all_faces) std::erase(face_labels_, 0);
      int* const label = out.template add_property<int>(element_kind::face, "label", face_labels_.size());
      std::copy(face_labels_.begin(), face_labels_.end(), label);
    }
    out.poly_labels = std::move(cell_labels_);
    if (!names_.names.empty())
      *out.template add_property<label_names>(element_kind::mesh, "label_names", 1) = std::move(names_);
  }
};

}  // namespace concino::detail

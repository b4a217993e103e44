// Reads and writes curve skeletons: .skel, .cg, .skc and .csv.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/options.hpp>
#include <concino/io/skeleton_graph.hpp>

#include <string>
#include <string_view>

namespace concino {

namespace file_format {

/// The names of the formats of skeletons, for messages and options.
struct cg_format {
  static constexpr std::string_view name = "cg";
  static constexpr std::string_view extensions[] = {".cg", ".cgr"};
  static constexpr std::string_view signature = "# D:";
  static bool has_signature(std::string_view text) { return text.starts_with(signature); }
};
struct skc_format {
  static constexpr std::string_view name = "skc";
  static constexpr std::string_view extensions[] = {".skc"};
  static constexpr bool is_read_only = true;
};
struct skel_format {
  static constexpr std::string_view name = "skel";
  static constexpr std::string_view extensions[] = {".skel"};
  static constexpr std::string_view signature = "ID Cx";
  static bool has_signature(std::string_view text) { return text.starts_with(signature); }
};
struct csv_format {
  static constexpr std::string_view name = "csv";
  static constexpr std::string_view extensions[] = {".csv"};
  static constexpr bool is_read_only = true;
};
inline constexpr cg_format cg{};
inline constexpr skc_format skc{};
inline constexpr skel_format skel{};
inline constexpr csv_format csv{};

}  // namespace file_format

/// Reads a curve skeleton from a file. Files that begin with `ID Cx` are .skel and files that begin with `# D:` are
/// .cg, whatever their extension; otherwise the extension determines the format, and options.format overrides both.
///   .skel  (Livesu et al. 2012)       id, point, radius and neighbours of each node; ids are any integers
///   .cg    (Tagliasacchi et al. 2012) verts, with or without a radius, and edges; indices begin at 0 if one of them is
///   0, else at 1 .skc   (Dey and Sun 2006)         verts and edges; the other numbers of edges are skipped
///   .csv   one point in each line, joined to the next one; numbers are separated by blanks, commas or semicolons
/// Needs:  a file of one of these formats.
/// Result: the skeleton; verts in the order of the file, those without edges included. Radii are 0 where the file has
///         none. Edges from a vert to itself are skipped, and of equal edges all but the first. options.report says so,
///         and whether verts have been renumbered.
/// Cost:   O(size of the file); O(n log n) for n nodes of a .skel file with ids other than 0, 1, 2 ...
/// Errors: io_error if the file cannot be read. parse_error with the line if it breaks its format: a number that is not
///         finite, an edge or a neighbour that does not exist, an id twice, fewer elements than it states.
///         unsupported if the format cannot be determined. cancelled.
skeleton load_skeleton(const std::string& path, const load_options& options = {});

/// Reads a curve skeleton from a string in memory. Messages call the text `name`.
/// Needs:  as load_skeleton; options.format, unless the text begins like a .skel or .cg file.
/// Result: as load_skeleton.
/// Cost:   as load_skeleton.
/// Errors: as load_skeleton, except io_error.
skeleton load_skeleton_text(std::string_view text, const load_options& options = {}, std::string_view name = "text");

/// Writes a curve skeleton to a file. The extension, or options.format, determines whether it is .skel or .cg.
/// Needs:  finite points and radii.
/// Result: the complete file, which replaces an existing one; coordinates and radii read back as the same numbers. A
///         .skel file always has radii, and edges in the order of their verts. A .cg file has the radii, if there are
///         any, as fourth numbers of verts, which some programs ignore; indices begin at 1.
/// Cost:   O(size of the skeleton).
/// Errors: unsupported for .skc and .csv, which are only read, for other extensions, and for options.binary.
///         invalid_mesh if a coordinate or a radius is not finite. io_error if the file cannot be written. cancelled.
void save_skeleton(const skeleton& k, const std::string& path, const save_options& options = {});

/// The contents of the file that save_skeleton writes.
/// Needs:  as save_skeleton; options.format.
/// Result: as save_skeleton, in memory.
/// Cost:   as save_skeleton.
/// Errors: as save_skeleton, except io_error.
std::string save_skeleton_text(const skeleton& k, const save_options& options);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/io/detail/skeleton/skeleton.ipp>
#endif

// The concept of a file format: a type that names the format, says what it can hold, reads it and writes it. The
// formats of the library, such as that of <concino/io/off.hpp>, are such types. You define a format of your own in the
// same way:
//
//   struct triangle_soup {
//     static constexpr std::string_view name = "soup";               // in messages; different for each format
//     static constexpr std::string_view extensions[] = {".soup"};    // in lower case; the first is the usual one
//     static constexpr bool holds_surfaces = true, holds_volumes = false;
//     static void read(const read_context& in, file_contents& out);  // fills out.surface; volume_contents& where it
//     holds volumes static void write(write_context& out, flat_mesh& m);           // writes to out.out
//   };
//
// and pass it to a call:  load<trimesh>(path, triangle_soup{}),  save(m, path, standard_formats + triangle_soup{}).
// A format may also define
//     static bool has_signature(std::string_view text);  whether a file begins like files of this format, which then
//     decides against the extension static constexpr std::string_view signature = "SOUP";  what has_signature looks
//     for, for messages static constexpr bool is_read_only = true;         if it has no write: save then refuses it
//     static constexpr bool is_write_only = true;        if it has no read: load then refuses it
//     static constexpr bool has_binary = true;           if it has a binary form, for save_options::binary
//     static constexpr bool has_only_properties = true;  if its reader stores no values but by add_property, for verts,
//     faces, polys and the mesh static constexpr bool holds_faces = true;          if files list the faces of volumes;
//     else save reports equal faces, and faces of no poly, as lost
//     static constexpr bool is_folder = true;           if a mesh is a folder of files. Its extensions are then names
//     of folders, like "polyMesh"; folder_file is a file that each of them has, and folder_in_case the path of such a
//     folder inside of one that is passed instead. read gets the path of the folder as in.name; write writes to the
//     files of out.folder.
//     read as a template over the contents
//     so that programs that read only surfaces, into file_contents, need not compile volumes
//
// A reader stores a property of any name and type by out.add_property<double>(element_kind::poly, "temperature", n),
// and collects the cells of volumes of any shapes with cell_builder (<concino/io/cell_builder.hpp>). Values of edges
// and faces belong to out.edges and out.faces, which lists them by their verts. A writer finds all properties in
// m.property_list(), and passes those that it stores to context.declare_stored; all others are reported as lost, or an
// error if options.strict is set. What else is lost it adds to context.report.lost.
//
// Laws: read() fills the arrays in the order of the file and reports what it skips. Where the file breaks the format,
// it throws parse_error, by text_cursor::fail. Polys of surfaces with a vert twice it may leave as they are:
// load follows load_options::repeated_verts, and so does cell_builder. It checks indices, or leaves that to the mesh,
// which throws invalid_mesh. From what write() writes, read() reads the same mesh.
#pragma once

#include <concino/concepts/mesh_traits.hpp>
#include <concino/concepts/requirement.hpp>
#include <concino/io/file_contents.hpp>
#include <concino/io/flat_mesh.hpp>
#include <concino/io/format_id.hpp>
#include <concino/io/write_context.hpp>

#include <array>
#include <concepts>
#include <iterator>
#include <string_view>
#include <type_traits>

namespace concino {

namespace requirement {

template<class F> concept has_format_name = requires { { F::name } -> std::convertible_to<std::string_view>; };
struct format_name_requirement {
  template<class F> static constexpr bool holds = has_format_name<F>;
  template<class F> static consteval void explain() {
    static_assert(
        detail::missing<F>,
        "concino: Format needs name: static constexpr std::string_view name = \"soup\"; what messages call the format");
  }
};

template<class F> concept has_extensions = requires {
  { *std::begin(F::extensions) } -> std::convertible_to<std::string_view>;
  requires std::size(F::extensions)
  > 0;
};
struct extensions_requirement {
  template<class F> static constexpr bool holds = has_extensions<F>;
  template<class F> static consteval void explain() {
    static_assert(
        detail::missing<F>,
        "concino: Format needs extensions: static constexpr std::string_view extensions[] = {\".soup\"}; in lower case, the usual one first");
  }
};

template<class F> concept declares_mesh_kinds = requires {
  { F::holds_surfaces } -> std::convertible_to<bool>;
  { F::holds_volumes } -> std::convertible_to<bool>;
  requires F::holds_surfaces || F::holds_volumes;
};
struct holds_requirement {
  template<class F> static constexpr bool holds = declares_mesh_kinds<F>;
  template<class F> static consteval void explain() {
    static_assert(
        detail::missing<F>,
        "concino: Format needs holds_surfaces and holds_volumes: static constexpr bool holds_surfaces = true, holds_volumes = false; not both false");
  }
};

template<class F> concept is_write_only = requires { requires F::is_write_only; };
template<class F> concept has_reader = is_write_only<F> || requires(const read_context& in, volume_contents& out) {
  F::read(in, out);
};
struct reader_requirement {
  template<class F> static constexpr bool holds = has_reader<F>;
  template<class F> static consteval void explain() {
    static_assert(
        !requires { &F::read; } || detail::missing<F>,
        "concino: read is there, but is not static, or takes other arguments");
    static_assert(
        detail::missing<F>,
        "concino: Format needs read: static void read(const read_context&, file_contents&), or volume_contents&; fills flat arrays from the text of a file; or is_write_only = true");
  }
};

template<class F> concept is_folder = requires { requires F::is_folder; };
template<class F> concept is_read_only = requires { requires F::is_read_only; };
template<class F> concept has_writer = is_read_only<F> || requires(write_context& out, flat_mesh& m) {
  F::write(out, m);
};
struct writer_requirement {
  template<class F> static constexpr bool holds = has_writer<F>;
  template<class F> static consteval void explain() {
    static_assert(
        !requires { &F::write; } || detail::missing<F>,
        "concino: write is there, but is not static, or takes other arguments");
    static_assert(
        detail::missing<F>,
        "concino: Format needs write: static void write(write_context&, flat_mesh&); writes flat arrays to context.out; or is_read_only = true");
  }
};

using format_requirements =
    list<format_name_requirement, extensions_requirement, holds_requirement, reader_requirement, writer_requirement>;

}  // namespace requirement

template<class F>
concept Format = requirement::has_format_name<F> && requirement::has_extensions<F> &&
    requirement::declares_mesh_kinds<F> && requirement::has_reader<F> && requirement::has_writer<F>;

/// Fails to compile with one sentence that names the first thing F lacks to be a Format and what to write.
template<class F>
consteval void explain_format() {
  if constexpr (!Format<F>) requirement::first_missing<requirement::format_requirements, F>::template explain<F>();
}

/// The formats that a call knows: a list fixed at compile time. A file is read in a format with its extension whose
/// signature it has; else in any whose signature it has; else in a format with its extension. Of several, the last one
/// in the list is used.
template<Format... F>
struct format_list {
  static_assert(sizeof...(F) <= 64);

  constexpr format_list() = default;
  constexpr explicit format_list(F...)
    requires(sizeof...(F) > 0)
  {}

  /// The id of each format.
  static constexpr std::array<format_id, sizeof...(F)> ids() { return {format_id(F{})...}; }

  template<Format G>
  friend constexpr format_list<F..., G> operator+(format_list, G) { return {}; }
};

namespace detail {

template<class T> inline constexpr bool is_format_list = false;
template<class... F> inline constexpr bool is_format_list<format_list<F...>> = true;

/// A list of one format.
template<Format F>
constexpr format_list<F> list_of(F) { return {}; }
template<class... F>
constexpr format_list<F...> list_of(format_list<F...> all) { return all; }

}  // namespace detail

namespace mistake {

/// A class that is passed where a format is expected, and is neither a format nor options.
template<class F>
concept is_no_format =
    std::is_class_v<F> && !Format<F> && !detail::is_format_list<F> && !std::convertible_to<F, load_options> &&
    !std::convertible_to<F, save_options> && !std::convertible_to<F, format_id>;
inline constexpr sentence complete_the_format(
    "this type is not a Format: explain_format<F>() names what it lacks, and <concino/io/format.hpp> describes formats");

}  // namespace mistake

/// A format or a list of formats, for load and save. With one format, the file is in this format, whatever its
/// extension.
template<class F>
concept Formats = Format<F> || detail::is_format_list<F>;

}  // namespace concino

// The type of the .ovm format. Its reader is defined in read_ovm.hpp, its writer in write_ovm.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

namespace detail {

/// Whether the first word is "OVM", in upper or lower case.
inline bool has_ovm_signature(std::string_view text) {
  text_cursor in(text.substr(0, 4096), {});
  in.skip_space('#');
  const std::string_view w = in.word();
  return w.size() == 3 && (w[0] | 0x20) == 'o' && (w[1] | 0x20) == 'v' && (w[2] | 0x20) == 'm';
}

}  // namespace detail

/// The text format of OpenVolumeMesh: volumes of any polyhedra, with properties of verts, edges, faces, polys and the
/// mesh. Its binary format, .ovmb, is another one.
struct ovm_format {
  static constexpr std::string_view name = "ovm";
  static constexpr std::string_view extensions[] = {".ovm"};
  static constexpr bool holds_surfaces = false, holds_volumes = true;
  static constexpr bool holds_faces = true;
  static constexpr std::string_view signature = "OVM";

  static bool has_signature(std::string_view text) { return detail::has_ovm_signature(text); }
  template<std::same_as<volume_contents> Contents>  // a template only so that programs that read no volumes need not
                                                    // compile it
  static void read(const read_context& in, Contents& out);
  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<ovm_format>);

namespace file_format {

inline constexpr ovm_format ovm{};

}  // namespace file_format

}  // namespace concino

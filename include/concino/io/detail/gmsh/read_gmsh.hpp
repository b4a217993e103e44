// The reader of Gmsh files, versions 2 and 4.1, text and binary.
#pragma once

#include <concino/io/detail/gmsh/gmsh_format.hpp>
#include <concino/io/detail/gmsh/gmsh_mesh.hpp>

namespace concino::detail {

/// Reads a Gmsh file into a grid, and makes a mesh of it.
template<bool Volumes>
class gmsh_reader : gmsh_mesh<Volumes> {
  using base = gmsh_mesh<Volumes>;
  using base::at, base::at_end, base::begin_numbers, base::binary_, base::binary_line_, base::end_section, base::left,
      base::reject, base::report_, base::skip, base::skip_section, base::text_number, base::word;

 public:
  gmsh_reader(const read_context& c, contents_of<Volumes>& out) : base(c, out) {}

  void read() {
    header();
    for (;;) {
      skip();
      if (at_end() || (!binary_ && text_without_padding({at, left()}).empty())) break;
      section();
    }
    if (!this->has_nodes_) reject(this->end(), {"$Nodes"});
    if (!this->has_elements_) reject(this->end(), {"$Elements"});
    this->finish_elements();
    this->report_values();
    this->make();
  }

 private:
  /// Reads the name of a section, without the $.
  std::string_view section_name() {
    const char* const from = at;
    if (at_end() || *at != '$') reject(from, {"the name of a section, such as $Nodes"});
    return word().substr(1);
  }

  void header() {
    skip();
    if (at_end()) reject(at, {"$MeshFormat"}, {"an empty file"});
    const char* from = at;
    std::string_view section = section_name();
    while (section == "Comments") {
      report_.skipped.push_back("section $Comments");
      skip_section(section);
      skip();
      from = at;
      section = section_name();
    }
    if (section == "NOD")
      core::throw_joined<unsupported>({this->name(), ": version 1 of the format of Gmsh is not supported; ", advice_});
    if (section != "MeshFormat") reject(from, {"$MeshFormat"});
    skip();
    const char* const version_line = at;
    const double version = this->real("the version of the format, 2.2 or 4.1", 0);
    const std::string_view text(version_line, static_cast<std::size_t>(at - version_line));
    this->is_version_4_ = version >= 4;
    if (!(version >= 2 && version < 3) && version != 4.1)
      core::throw_joined<unsupported>(
          {this->name(), ": version ", text.substr(0, 40), " of the format of Gmsh is not supported; ", advice_});
    skip();
    const char* const type = at;
    const std::int64_t is_binary = text_number("0 for text or 1 for binary numbers");
    if (is_binary != 0 && is_binary != 1) reject(type, {"0 for text or 1 for binary numbers"});
    skip();
    const char* const size = at;
    const std::int64_t bytes = text_number("the size of numbers, 8");
    if (bytes != 8 && !(bytes == 4 && this->is_version_4_)) reject(size, {"the size of numbers, 8"});
    this->sizes_have_4_bytes_ = bytes == 4;
    if (is_binary) {
      binary_ = true;
      binary_line_ = version_line;
      begin_numbers();
      const char* const one = at;
      if (left() < 4) reject(this->end(), {"the number 1"});
      const auto x = this->template value<std::int32_t>();
      if (x == 0x01000000) this->swapped_ = true;
      else if (x != 1) reject(one, {"the number 1"}, {x});
    }
    end_section("MeshFormat");
  }

  void section() {
    const std::string_view s = section_name();
    if (s == "PhysicalNames") return this->physical_names();
    if (s == "Entities" && this->is_version_4_) return this->entities(false);
    if (s == "PartitionedEntities" && this->is_version_4_) return this->entities(true);
    if (s == "Nodes") return this->nodes();
    if (s == "Elements") return this->elements();
    if (s == "NodeData") return this->values(true);
    if (s == "ElementData") return this->values(false);
    if (s == "ParametricNodes")
      core::throw_joined<unsupported>({this->name(), ": $ParametricNodes is not supported; ", advice_});
    report_.skipped.push_back(core::joined({"section $", s.substr(0, 40)}));
    skip_section(s);
  }

  static constexpr std::string_view advice_ = "let Gmsh write version 4.1: gmsh FILE -0 -format msh41 -o NEW_FILE";
};

}  // namespace concino::detail

namespace concino {

/// Needs:  a file of Gmsh, version 2.0 to 2.2 or 4.1, as text or binary in either byte order, with sections in any
///         order but that $Entities is before $Elements, $Nodes before these, and values after both.
/// Result: a volume if there is any tet, hex, prism or pyramid, else a surface. Verts are the nodes in the order of the
///         file, whatever their tags, and polys the elements of the highest dimension in theirs. The verts of cells of
///         negative volume are put into the standard order, and these cells are counted. Physical groups become "label"
///         (int) of polys, and elements of lower dimension give it to faces, edges and verts; the names of groups are
///         the mesh property "label_names" (label_names). Tags of entities become "entity_tag" (int), unless each is
///         that with which a mesh without "entity_tag" is written: the label, or for elements without one the smallest
///         number that is no label. If the file lists faces, edges or verts without any of these, they and the others
///         listed have "entity" (int), 1. Values of nodes and elements become properties of verts, polys, faces and
///         edges by their names: double, vec3, or std::array<double, n> for 2, 4, 6 and 9 numbers; 0 where the file has
///         none. Elements of second or higher order are read by their corners, if load_options::corners_only is set;
///         points that are only their other nodes are reported as skipped. So are other sections, bounds of entities,
///         partitions, parameters of nodes, and groups of an element after the first, which version 2 lists again.
/// Cost:   O(size of the text); O(n log n) for n nodes whose tags do not follow each other.
/// Errors: parse_error naming the line (of binary files the byte) of a wrong number, a tag of no node, an element with
///         a vert twice, an element that the wanted mesh cannot hold, or the end of a file that is cut off; unsupported
///         for other versions and types of elements, if the file holds a volume and a surface was wanted, or the
///         reverse, if it has elements of second or higher order, or very many sections with values of few elements.
template<std::derived_from<file_contents> Contents>
void gmsh_format::read(const read_context& in, Contents& out) {
  detail::gmsh_reader<std::is_same_v<Contents, volume_contents>>(in, out).read();
}

}  // namespace concino

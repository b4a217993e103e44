// The results of validate: kinds of defects, one record per defect, facts about the whole mesh, and the report that
// contains them.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/message.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace concino {

enum class defect_kind : std::uint8_t {
  non_finite_point,      ///< a vert whose coordinates are not three finite numbers
  corner_order,          ///< a hex of a HexMesh whose corners look like a non-standard order, see hex_order
  isolated_vert,         ///< a vert of no poly
  unreferenced_face,     ///< volumes: a face of no poly
  degenerate_element,    ///< an edge from a vert to itself; a polygon with a vert twice or fewer than three verts; a
                         ///< polyhedron of fewer than four faces
  duplicated_element,    ///< two polys, or two faces of a volume, with the same verts
  non_manifold_face,     ///< volumes: a face of more than two polys
  non_manifold_edge,     ///< an edge of more than two polygons: of a surface, of the boundary of a volume, or of one
                         ///< polyhedron
  non_manifold_vert,     ///< a vert where several fans of polygons meet: of a surface, or of the boundary of a volume
  inconsistent_winding,  ///< two polygons traverse their edge in the same direction, or a face turns the same side to
                         ///< both its polyhedra
  not_orientable,        ///< connected polys that cannot be wound consistently (their windings are then not reported
                         ///< one by one)
  open_cell,             ///< volumes: a poly with an edge that lies in only one of its faces
  inverted_cell,         ///< volumes: a poly of negative volume; if all are, read the mesh with tet_order::mirrored or
                         ///< hex_order::mirrored
  zero_size,             ///< an edge without length, a polygon without area, a polyhedron without volume
  self_touching,         ///< a polygon whose boundary intersects or touches itself
  non_planar             ///< a polygon whose verts lie far off its plane
};
inline constexpr std::size_t num_defect_kinds = 16;

/// A short name of a kind of defect, such as "non-manifold edge".
/// Needs:  one of the kinds above.      Result: a text, never empty.      Cost: O(1).      Errors: none.
constexpr const char* defect_name(defect_kind kind) {
  constexpr std::array<const char*, num_defect_kinds> names = {
      "non-finite point",   "corner order",      "isolated vert",     "unreferenced face", "degenerate element",
      "duplicated element", "non-manifold face", "non-manifold edge", "non-manifold vert", "inconsistent winding",
      "not orientable",     "open cell",         "inverted cell",     "zero size",         "self-touching polygon",
      "non-planar polygon"};
  return names[static_cast<std::size_t>(kind)];
}

/// A set of kinds of defects: all, those in braces, or all but some.
class defect_kinds {
  std::uint32_t bits_ = (1u << num_defect_kinds) - 1;
  static constexpr std::uint32_t bit(defect_kind k) { return 1u << static_cast<unsigned>(k); }

 public:
  constexpr defect_kinds() = default;
  constexpr defect_kinds(std::initializer_list<defect_kind> some) : bits_(0) {
    for (const defect_kind k : some) bits_ |= bit(k);
  }
  constexpr defect_kinds without(std::initializer_list<defect_kind> some) const {
    defect_kinds r = *this;
    for (const defect_kind k : some) r.bits_ &= ~bit(k);
    return r;
  }
  constexpr bool holds(defect_kind k) const { return (bits_ & bit(k)) != 0; }
  constexpr bool holds_any(std::initializer_list<defect_kind> some) const {
    for (const defect_kind k : some)
      if (holds(k)) return true;
    return false;
  }
};

namespace detail {

template<class M, bool IsVolume> struct element_of { using type = std::variant<vert_t<M>, edge_t<M>, poly_t<M>>; };
template<class M> struct element_of<M, true> { using type = std::variant<vert_t<M>, edge_t<M>, face_t<M>, poly_t<M>>; };

}  // namespace detail

/// Any element of M, as its descriptor: a std::variant of vert_t<M>, edge_t<M>, face_t<M> (volumes) and poly_t<M>.
template<AnyMesh M> using mesh_element = typename detail::element_of<std::remove_cvref_t<M>, VolumeMesh<M>>::type;

template<class M>
struct defect {
  defect_kind kind;
  mesh_element<M> element;               ///< the defective element
  std::vector<mesh_element<M>> others;   ///< further elements involved; a few of them if there are many
  std::string what;                      ///< a sentence with the indices and numbers
};

/// Properties of the mesh as a whole. Verts, edges and faces of no poly do not count.
struct mesh_facts {
  bool manifold = true;    ///< surfaces: every edge has at most two polys and every vert one fan. Volumes: every poly
                           ///< is closed and wound
                           ///< consistently, every face has at most two polys, and the boundary is a manifold surface.
  bool orientable = true;  ///< the polys can be wound consistently
  bool closed = true;      ///< surfaces: no edge has only one poly. Volumes: no poly is open.
  std::size_t components = 0;           ///< surfaces: connected through shared verts. Volumes: polys connected through
                                        ///< shared faces.
  std::size_t boundary_loops = 0;       ///< borders of a surface, or connected components of the boundary of a volume
                                        ///< (0 if polys are closed)
  std::ptrdiff_t euler_characteristic = 0;  ///< verts - edges + faces (surfaces: polys), - polys in volumes
  std::optional<std::size_t> genus;     ///< sum over the components; for volumes, of the boundary. None if not manifold
                                        ///< and orientable.
};

/// The defects of a mesh, sorted by kind: `for (auto& defect : report)`. As text: report.text().
template<class M>
class validation_report {
 public:
  mesh_facts facts;
  std::vector<defect<M>> defects;  ///< at most as many records of each kind as validate_options allows

  auto begin() const { return defects.begin(); }
  auto end() const { return defects.end(); }
  std::size_t size() const { return defects.size(); }
  const defect<M>& operator[](std::size_t i) const { return defects[i]; }

  /// The number of defects of one kind, or of all, including those without a record.
  std::size_t count(defect_kind kind) const { return counts_[static_cast<std::size_t>(kind)]; }
  std::size_t count() const {
    std::size_t n = 0;
    for (const std::size_t k : counts_) n += k;
    return n;
  }
  /// Whether there are no defects.
  bool is_clean() const { return count() == 0; }

  /// The report as text: a line for each record, and for each kind the number of defects without a record.
  std::string text() const {
    if (is_clean()) return "no defects\n";
    std::string s = core::joined({count(), count() == 1 ? " defect\n" : " defects\n"});
    for (std::size_t k = 0; k < num_defect_kinds; ++k) {
      const char* const name = defect_name(static_cast<defect_kind>(k));
      std::size_t rest = counts_[k];
      for (const defect<M>& d : defects) {
        if (static_cast<std::size_t>(d.kind) != k) continue;
        s.append(core::joined({name, ": ", d.what, '\n'}));
        --rest;
      }
      if (rest > 0) s.append(core::joined({name, ": ", rest, " more\n"}));
    }
    return s;
  }

  /// Counts a defect, and adds a record if there are fewer than `most` of this kind.   Result: the record to fill in,
  /// or null.
  defect<M>* add(defect_kind kind, const mesh_element<M>& element, std::size_t most) {
    if (counts_[static_cast<std::size_t>(kind)]++ >= most) return nullptr;
    defects.push_back({kind, element, {}, {}});
    return &defects.back();
  }
  /// Sorts the records by kind. Records of one kind stay in the order in which they were found.
  void sort() {
    std::vector<defect<M>> sorted;
    sorted.reserve(defects.size());
    for (std::size_t k = 0; k < num_defect_kinds; ++k)
      for (defect<M>& d : defects)
        if (static_cast<std::size_t>(d.kind) == k) sorted.push_back(std::move(d));
    defects = std::move(sorted);
  }

 private:
  std::array<std::size_t, num_defect_kinds> counts_{};
};

}  // namespace concino

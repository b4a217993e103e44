// Converts any mesh to any other type of the same dimension: auto to = convert<To>(from). Properties are transferred.
// convert_with_correspondence<To>(from) also returns the correspondence between the elements.
#pragma once

#include <concino/convert/conversion.hpp>
#include <concino/mesh/support/arrays_of.hpp>
#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/edit/elements.hpp>
#include <concino/mesh/correspondence.hpp>
#include <concino/mesh/property.hpp>

#include <span>

namespace concino {

/// What convert() could not transfer.
struct convert_report {
  std::vector<std::string> lost;  // one sentence per property
};

struct convert_options {
  bool properties = true;                // whether named properties are transferred, if both meshes can have them
  convert_report* report = nullptr;      // unless null, cleared and then filled in
  concino::progress progress = nullptr;  // called with the fraction done and "converting"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

namespace requirement {

/// A mesh that convert() can construct: from flat arrays, or by adding verts and polys one by one.
template<class To>
concept is_constructible_from_arrays =
    concino::detail::from_surface<To> || concino::detail::from_cells<To> || concino::detail::from_polyhedra<To>;
template<class To>
concept is_built_by_adding = std::default_initializable<To> && has_add_vert<To> && has_add_poly<To> &&
    (dimension_v<To> == 2 || arity_v<To> == 4 || arity_v<To> == 8);
template<class To, class From> concept can_be_converted_from = AnyMesh<To> && EmbeddedMesh<From> && dimension_v<To>
== dimension_v<From> && (is_constructible_from_arrays<To> || is_built_by_adding<To>);

}  // namespace requirement

namespace detail {

/// Maps the elements of m, in the order of their range, to the elements 0, 1, 2, ... of a native mesh.
template<class Map, class R>
Map numbered_as_walked(Map names, const R& elements) {
  std::uint32_t n = 0;
  for (const auto x : elements) names[x] = typename Map::value_type(n++);
  return names;
}

template<class To, class From>
conversion<To, From> convert_by_arrays(const From& m) {
  const std::vector<std::uint32_t> vert_number = core::numbered(m, verts(m), vert_index_bound(m));
  std::vector<std::uint32_t> face_number;
  const auto construct = [&]() -> To {
    if constexpr (from_surface<To>) {
      return To(core::arrays_of(m, vert_number, static_cast<std::uint32_t>(arity_v<To>)));
    } else if constexpr (from_polyhedra<To>) {
      face_number = core::numbered(m, faces(m), face_index_bound(m));
      return To(core::polyhedra_of(m, vert_number, face_number));
    } else {
      cell_arrays a;
      a.arity = static_cast<std::uint32_t>(arity_v<To>);
      a.points = core::copy_points(m);
      a.verts.reserve(a.arity * num_polys(m));
      core::for_each_cell(m, vert_number, a.arity, [&](const poly_t<From>&, const vert_id* corners) {
        a.verts.insert(a.verts.end(), corners, corners + a.arity);
      });
      return To(std::move(a));
    }
  };
  To mesh = construct();
  return {std::move(mesh), numbered_as_walked(make_vert_map<vert_t<To>>(m), verts(m)),
          numbered_as_walked(make_poly_map<poly_t<To>>(m), polys(m)), std::move(face_number)};
}

template<class To, class From>
conversion<To, From> convert_by_adding(const From& m) {
  To mesh;
  auto vert_names = make_vert_map<vert_t<To>>(m);
  auto poly_names = make_poly_map<poly_t<To>>(m);
  std::vector<vert_t<To>> by_number, corners;
  for (const vert_t<From> v : verts(m)) by_number.push_back(vert_names[v] = add_vert(mesh, to_vec3(point(m, v))));
  const auto add = [&](const poly_t<From>& p) {
    try {
      poly_names[p] = add_poly(mesh, std::span<const vert_t<To>>(corners));
    } catch (const invalid_mesh& refused) {
      core::throw_joined<unsupported>(
          {"convert: the wanted mesh cannot hold poly ", index_of(m, p), ": ", refused.what()});
    }
  };
  constexpr auto arity = static_cast<std::uint32_t>(arity_v<To>);
  if constexpr (dimension_v<From> == 2) {  // a polygon is a list of verts, a polyhedron a list of faces
    for (const poly_t<From> p : polys(m)) {
      corners.clear();
      for (const vert_t<From> v : adj_p2v(m, p)) corners.push_back(vert_names[v]);
      if (arity != 0 && corners.size() != arity)
        core::throw_wrong_arity(false, index_of(m, p), core::joined({"has ", corners.size(), " verts"}), arity);
      add(p);
    }
  } else {
    core::for_each_cell(m, core::numbered(m, verts(m), vert_index_bound(m)), arity,
                  [&](const poly_t<From>& p, const vert_id* known) {
                    corners.clear();
                    for (std::uint32_t i = 0; i < arity; ++i) corners.push_back(by_number[known[i].raw()]);
                    add(p);
                  });
  }
  return {std::move(mesh), std::move(vert_names), std::move(poly_names)};
}

template<class To, class From>
void convert_properties(conversion<To, From>& c, convert_report& report) {
  if constexpr (ShowsProperties<From>) {
    const property_set& source = traits<From>::properties(c.from());
    if constexpr (HasProperties<To>) {
      correspondence of;  // only for the kinds of elements that have properties
      if (source.has(element_kind::vert)) of.verts = c.vert_origins();
      if (source.has(element_kind::edge)) of.edges = c.edge_origins();
      if (source.has(element_kind::face)) of.faces = c.face_origins();
      if (source.has(element_kind::poly)) of.polys = c.poly_origins();
      if constexpr (NumbersCorners<From> && NumbersCorners<To>)
        if (source.has(element_kind::corner))
          of.corners = match_corners(c.from(), c.mesh, c.vert_origins(), c.poly_origins());
      traits<To>::properties(c.mesh).transfer(source, of);
    } else {
      for (const property_info& p : property_list(c.from()))
        report.lost.push_back(
            core::joined({to_string(p.kind), " property \"", p.name,
                          "\": the wanted mesh holds no named properties; transfer() takes values to a map"}));
    }
  }
}

}  // namespace detail

/// Converts m to a mesh of type To, and returns the correspondence between the elements too.
/// Needs:  as convert; m is not a temporary, and stays in place as long as elements of the result are looked up.
/// Result: c.mesh is the new mesh. c.vert_of(v), c.edge_of(e), c.face_of(f) and c.poly_of(p) are its elements that
///         correspond to elements of m. c.transfer(map, map_of_the_new_mesh) copies the values of maps.
///         c.correspondence() is the correspondence by indices.
/// Cost:   as convert.
/// Errors: as convert.
template<class To, class M>
  requires requirement::is_lvalue_or_view<M> && requirement::can_be_converted_from<To, std::remove_cvref_t<M>>
conversion<To, std::remove_cvref_t<M>> convert_with_correspondence(M&& m, const convert_options& input_options = {}) {
  const core::profiled_options profiled(input_options, "convert");
  const convert_options& options = *profiled;
  detail::report_progress(options.progress, 0, "converting");
  convert_report unused_report, &report = options.report ? *options.report : unused_report;
  report = {};
  auto c = [&] {
    if constexpr (requirement::is_constructible_from_arrays<To>) return detail::convert_by_arrays<To>(std::as_const(m));
    else return detail::convert_by_adding<To>(std::as_const(m));
  }();
  detail::report_progress(options.progress, 0.8, "converting");
  if (options.properties) detail::convert_properties(c, report);
  detail::report_progress(options.progress, 1, "converting");
  return c;
}

/// Converts m to a mesh of type To: auto polygons = convert<polygonmesh>(m).
/// Needs:  EmbeddedMesh M and a To of the same dimension. To is one of the six native meshes, which are constructed
///         from flat arrays, or can add verts and polys (in volumes tets or hexes): OpenMesh, CGAL::Surface_mesh, a
///         mesh of yours with add_vert and add_poly.
/// Result: a To. Verts, polys and, in a polyhedralmesh, faces are numbered in the order of m, without gaps for deleted
///         elements. Named properties of native meshes, and of submesh() and with_points() of them, are transferred
///         under their names.
/// Cost:   O(elements) time and memory; for properties of edges or faces, times the edges or faces at a vert.
/// Errors: unsupported that names the poly which a To cannot hold: of another size, not a tet or hex, or refused by the
///         library of To. m is not changed. cancelled.
template<class To, class M>
  requires requirement::can_be_converted_from<To, M>
To convert(const M& m, const convert_options& options = {}) {
  return std::move(convert_with_correspondence<To>(m, options).mesh);
}

// What to write instead of calls that cannot compile.
template<class... T> void convert(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void convert(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void convert_with_correspondence(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void convert_with_correspondence(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void convert_with_correspondence(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

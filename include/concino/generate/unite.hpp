// One mesh of two that have coincident verts.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/generate/detail/unite/coincident_points.hpp>
#include <concino/generate/detail/unite/united_arrays.hpp>
#include <concino/generate/detail/unite/united_properties.hpp>
#include <concino/mesh/property.hpp>

#include <limits>
#include <utility>

namespace concino {

struct unite_options {
  double tolerance = 0;                               // the largest distance of verts that become one, in units of
                                                      // length, 0 or more and finite; 0: equal points
  bool properties = true;                             // whether named properties of both meshes are transferred
  concino::correspondence* from_first = nullptr;      // unless null, filled with the elements of the first mesh of
                                                      // which those of the result were made
  concino::correspondence* from_second = nullptr;     // the same for the second mesh; elements of both have origins in
                                                      // both
};

namespace detail {

/// Transfers the properties of both meshes; the types of From may be any meshes.
template<class A, class B, class To>
void unite_properties(const A& a, const correspondence& from_a, const B& b, const correspondence& from_b, To& united) {
  property_set& to = traits<To>::properties(united);
  if constexpr (ShowsProperties<A>) to.transfer(traits<A>::properties(a), from_a);
  if constexpr (ShowsProperties<B>) add_united_properties(traits<B>::properties(b), from_a, from_b, to);
}

template<class M>
bool has_properties(const M& m) {
  if constexpr (ShowsProperties<M>) return traits<M>::properties(m).size() > 0;
  else return false;
}

}  // namespace detail

/// One mesh of two. Verts of the second mesh that coincide with verts of the first become the same verts, so that polys
/// of both meshes share edges, and in volumes faces with the same verts. It does not intersect them: polys may overlap,
/// and polys that are in both meshes are there twice.
/// Needs:  EmbeddedMesh both, of the same dimension. If faces of volumes are to be shared, they have the same verts in
///         both.
/// Result: a native mesh that can hold the polys of both: of triangles if both have triangles only by type, and so on,
///         else a polygonmesh or polyhedralmesh. Verts and polys are those of a, then those of b, in their orders;
///         verts of b within the tolerance of verts of a are left out, and the nearest of these takes their place.
///         Coincident verts of the same mesh remain apart. Where both meshes have a property of one name, elements of
///         both have the value in a.
/// Cost:   O(elements of both), and for each vert of b the verts of a within a few tolerances; searching for them in
///         parallel.
/// Errors: invalid_argument if the tolerance is below 0 or not finite; one that names a poly of b if two of its verts
///         would become one; one if two properties of one name have values of different types.
template<EmbeddedMesh A, EmbeddedMesh B>
  requires(dimension_v<A> == dimension_v<B>)
detail::united_mesh<A, B> unite(const A& a, const B& b, const unite_options& options = {}) {
  if (!(options.tolerance >= 0 && options.tolerance <= std::numeric_limits<double>::max()))
    core::throw_joined<invalid_argument>(
        {"unite: tolerance is ", core::number_text(options.tolerance), "; it must be finite and 0 or more"});
  std::vector<vec3> points, points_of_b;
  const std::vector<std::uint32_t> number_a = detail::read_points(a, points);
  std::vector<std::uint32_t> number_b = detail::read_points(b, points_of_b);
  // of each vert of b, by its position
  std::vector<std::uint32_t> number = detail::coincident_points(points, points_of_b, options.tolerance);
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] != ~0u) continue;
    number[i] = static_cast<std::uint32_t>(points.size());
    points.push_back(points_of_b[i]);
  }
  for (std::uint32_t& x : number_b)
    if (x != ~0u) x = number[x];
  detail::check_verts_differ(b, number_b, points.size());
  auto arrays = detail::united_arrays(a, number_a, b, number_b, points.size());
  arrays.points = std::move(points);
  detail::united_mesh<A, B> united(std::move(arrays));
  const bool has_properties = options.properties && (detail::has_properties(a) || detail::has_properties(b));
  if (!has_properties && !options.from_first && !options.from_second) return united;
  correspondence from_a = detail::origins_in(a, number_a, 0, united),
                 from_b = detail::origins_in(b, number_b, num_polys(a), united);
  if (has_properties) detail::unite_properties(a, from_a, b, from_b, united);
  if (options.from_first) *options.from_first = std::move(from_a);
  if (options.from_second) *options.from_second = std::move(from_b);
  return united;
}

// What to write instead of calls that cannot compile.
template<class... T> void unite(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void unite(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

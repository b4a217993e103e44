// make_arrows: the vectors of a field as arrows, such as gradients at polys or velocities at verts.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/render/drawable.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace concino {

/// What became of the vectors given to make_arrows.
struct arrow_report {
  std::size_t drawn = 0, thinned = 0;    // as arrows; left out because there are many
  std::size_t zero = 0, not_finite = 0;  // left out because they have no direction
};

struct arrow_options {
  double scale = 0.5;                     // above 0: lengths. With 0.5, an arrow of the mean norm is 3/4 as long as the
                                          // mean distance from an arrow to the nearest one
  bool equal_lengths = false;             // all arrows are as long as one of the mean norm; otherwise lengths are in
                                          // proportion to norms, up to 4 times the mean
  std::size_t count = 1000;               // the most arrows that are drawn, distributed evenly, or somewhat fewer; 0:
                                          // all
  double radius = 0;                      // of the shafts, in units of the mesh, 0 or more; 0: 7 % of the length for
                                          // the mean norm. A tenth of the length at most
  bool heads = true;                      // false: rods, for directions without a sense, such as lines and crosses
  rgb color = srgb(0.13f, 0.13f, 0.15f);  // if they are not coloured by norm
  bool color_by_norm = false;             // instead: look.scale of the result is linear over the norms
  colormap map = colormap::blue_to_yellow;  // of the norms
  double opacity = 1;                     // in [0, 1]
  bool centered = false;                  // arrows have their middles, not their tails, at the points of the vectors
  int corners = 0;                        // of the cross-section, 3 to 256; 0: 16 for up to 500 arrows, 10 for up to
                                          // 5,000, 6 for more
  arrow_report* report = nullptr;         // unless null, filled with the numbers of arrows and of vectors left out
};

namespace requirement {

template<class M, class G> concept has_vectors_at_polys = EmbeddedMesh<M> && gives_points<G, poly_t<M>>;
template<class M, class G> concept has_vectors_at_verts = Embedded<M> && has_verts<M> && gives_points<G, vert_t<M>>;

}  // namespace requirement

namespace detail {

/// The points and vectors of a field, and the length of the box in which arrows are to be drawn.
struct flat_vectors {
  std::vector<vec3> points, vectors;
  std::vector<std::uint32_t> indices;  // of the elements
  double size = 0;

  void add(const vec3& at, const vec3& vector, std::size_t index) {
    points.push_back(at);
    vectors.push_back(vector);
    indices.push_back(static_cast<std::uint32_t>(index));
  }
};

drawable arrows_of(const flat_vectors& field, const arrow_options& options, const char* caller);

/// Errors: invalid_argument if g is a map of another mesh, or was made before elements were added.
template<class M, class G>
void check_vector_map(const M& m, const G& g, std::size_t bound, const char* caller) {
  if constexpr (!is_view_v<M> && requires { { g.mesh() } -> std::same_as<const M&>; })
    if (&g.mesh() != &m)
      core::throw_joined<invalid_argument>(
          {caller, ": the vectors belong to another mesh; make the map with this one"});
  if constexpr (requires { g.values().size(); })
    if (const std::size_t size = g.values().size(); size < bound)
      core::throw_joined<invalid_argument>({caller, ": there are ", size, " vectors, but elements up to index ",
                                            bound - 1,
                                            "; the map was made for another mesh, or before elements were added"});
}

}  // namespace detail

/// Arrows for a vector field with a vector at each poly, from its centroid, or at each vert: cn::make_arrows(m,
/// cn::gradient(m, u)).
/// Needs:  EmbeddedMesh for vectors at polys, Embedded M with verts for vectors at verts; g: any readable map of
///         vectors. Arrows of some polys alone are those of submesh(m, keep).
/// Result: a drawable of closed surfaces: shafts with a cone at the end. `polys` has the indices of the polys or verts.
///         Vectors that are 0 or not finite are left out, and counted in options.report. If there are more than
///         options.count, those drawn are about equally far from each other. Where the distance between arrows is not
///         known, as of one arrow alone, a quarter of the diagonal of the mesh's box takes its place. The same in every
///         run.
/// Cost:   O(n log n) to choose among n vectors, about 20,000 more for each arrow if there are many; 25 corners of 130
///         bytes for each corner of a cross-section.
/// Errors: invalid_argument if an option is out of its range, or if g is a map of another mesh; invalid_mesh if a point
///         is not finite, naming the element. unsupported if there are too many arrows for 32-bit numbers.
/// Source: paper section 3, Fig. 4. Even choice: random sequential addition, Cook 1986, "Stochastic sampling in
///         computer graphics".
template<class M, class G>
  requires requirement::has_vectors_at_polys<M, G>
drawable make_arrows(const M& m, const G& g, const arrow_options& options = {}) {
  detail::check_vector_map(m, g, poly_index_bound(m), "make_arrows");
  detail::flat_vectors field;
  field.size = bounding_box(m).diagonal();
  for (const poly_t<M> p : polys(m)) field.add(centroid(m, p), to_vec3(g[p]), index_of(m, p));
  return detail::arrows_of(field, options, "make_arrows: poly ");
}
template<class M, class G>
  requires(requirement::has_vectors_at_verts<M, G> && !requirement::has_vectors_at_polys<M, G>)
drawable make_arrows(const M& m, const G& g, const arrow_options& options = {}) {
  detail::check_vector_map(m, g, vert_index_bound(m), "make_arrows");
  detail::flat_vectors field;
  field.size = bounding_box(m).diagonal();
  for (const vert_t<M> v : verts(m)) field.add(to_vec3(point(m, v)), to_vec3(g[v]), index_of(m, v));
  return detail::arrows_of(field, options, "make_arrows: vert ");
}

// What to write instead of calls that cannot compile.
template<class... T> void make_arrows(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void make_arrows(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class G, class R = mistake::remedy<mistake::give_vectors_at_polys>>
  requires(EmbeddedMesh<M> && !requirement::has_vectors_at_polys<M, G> && !requirement::has_vectors_at_verts<M, G>)
void make_arrows(M&&, const G&, ...) = delete;  // a vector at each poly: make_poly_map<vec3>(m), or gradient(m, u)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/render/detail/shapes/arrows.ipp>
#endif

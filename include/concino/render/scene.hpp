// Scenes: the things that a picture shows.
#pragma once

#include <concino/render/labels.hpp>
#include <concino/render/make_drawable.hpp>
#include <concino/render/shapes.hpp>

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace concino {

/// Several things to draw together. Each is prepared when it is added: later changes of a mesh or of its fields are not
/// seen.
class scene {
  std::vector<drawable> drawables_;
  std::vector<point_label> labels_;
  box earlier_;  // of all drawables but the last, which may still change

 public:
  /// Adds a mesh of any type: s.add(m, {.field = u, .edges = true, .visible = below('x', 0.3)}).
  /// Needs, Cost, Errors: as make_drawable.      Result: the scene, which holds no copy of the mesh and no reference to
  /// it.
  template<EmbeddedMesh M>
  scene& add(const M& m, const mesh_look<M>& look = {}) { return add(make_drawable(m, look)); }

  /// Adds a drawable, for example one made by make_drawable.
  scene& add(drawable d) {
    const box before = bounds();
    drawables_.push_back(std::move(d));
    earlier_ = before;
    return *this;
  }

  /// Adds a text beside a point. It is left out of pictures in which something hides the point, unless that is near to
  /// it, such as a ball that marks the point: within 1.5 % of the diagonal of the scene.
  /// Needs:  text in UTF-8.      Result: the scene.      Cost: O(length of the text).
  /// Errors: invalid_argument if the point is not finite.
  scene& add_label(const vec3& at, std::string text) {
    if (!is_finite(at))
      core::throw_joined<invalid_argument>({"scene: the point of the label \"", text, "\" is not finite"});
    labels_.push_back({at, std::move(text)});
    return *this;
  }

  // What to write instead of calls that cannot compile.
  template<class... T> void add(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
  template<class... T> void add(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

  /// What was added, in this order.
  std::span<const drawable> drawables() const { return drawables_; }
  std::span<const point_label> labels() const { return labels_; }
  /// The last drawable added, to change it before another is added.
  drawable& last() { return drawables_.back(); }

  /// The bounding box of all that was added.
  /// Cost: O(points of the last drawable).
  box bounds() const {
    box b = earlier_;
    if (!drawables_.empty())
      for (const vec3& p : drawables_.back().points) b.add(p);
    return b;
  }

  /// Adds lines as tubes: s.add_lines(lines, {.radius = 0.004, .color = {1, 0, 0}}); those of m are walks along it,
  /// such as paths and boundary loops. Needs, Errors: as make_tubes.      Result: the scene. A radius of 0 means 0.4 %
  /// of the diagonal of bounds(), if something was added before.
  /// Cost:   as make_tubes.
  template<class L = std::initializer_list<vec3>>
    requires requirement::is_lines<L>
  scene& add_lines(const L& lines, const tube_options& options = {}) {
    return add(make_tubes(lines, fitted(options, 0.004)));
  }
  template<Embedded M, class W>
    requires(requirement::is_walk<W, M> || requirement::is_walk_range<W, M>)
  scene& add_lines(const M& m, const W& walks, const tube_options& options = {}) {
    return add(make_tubes(m, walks, fitted(options, 0.004)));
  }

  /// Adds the edges of a graph or a mesh, or some of them, as tubes: s.add_graph(skeleton, {.radii =
  /// skeleton.radii()}). Needs, Errors: as make_graph_tubes.      Result: as add_lines.      Cost: as make_graph_tubes
  /// and add_lines.
  template<EmbeddedGraph M>
  scene& add_graph(const M& g, const tube_options& options = {}) {
    return add(make_graph_tubes(g, fitted(options, 0.004)));
  }
  template<Embedded M, class S>
    requires requirement::has_verts<M> && requirement::selects_edges<S, M>
  scene& add_graph(const M& m, const S& some, const tube_options& options = {}) {
    return add(make_graph_tubes(m, some, fitted(options, 0.004)));
  }

  /// Adds points, or the verts of a mesh or a graph, as balls: s.add_points(points, {.radius = 0.01}).
  /// Needs, Errors: as make_balls.      Result: the scene. A radius of 0 means 0.8 % of the diagonal of bounds(), if
  /// something was added before.
  /// Cost:   as make_balls.
  template<class P = std::initializer_list<vec3>>
    requires(requirement::is_point_range<P> || (Embedded<P> && requirement::has_verts<P>))
  scene& add_points(const P& points, const ball_options& options = {}) {
    return add(make_balls(points, fitted(options, 0.008)));
  }

  /// Adds the vectors of a field as arrows: s.add_arrows(m, gradient(m, u), {.scale = 0.5}).
  /// Needs, Cost, Errors: as make_arrows.      Result: the scene.
  template<class M, class G>
    requires(requirement::has_vectors_at_polys<M, G> || requirement::has_vectors_at_verts<M, G>)
  scene& add_arrows(const M& m, const G& g, const arrow_options& options = {}) {
    return add(make_arrows(m, g, options));
  }

 private:
  template<class O>
  O fitted(O options, double part) const {
    if (options.radius == 0) options.radius = part * bounds().diagonal();
    return options;
  }
};

}  // namespace concino

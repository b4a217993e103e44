// Scenes: the things that a picture shows.
#pragma once

#include <concino/render/labels.hpp>
#include <concino/render/make_drawable.hpp>

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace concino {

/// Several things to draw together. Each is prepared when it is added: later changes of a mesh or of its fields are not seen.
class scene {
  std::vector<drawable> drawables_;
  std::vector<point_label> labels_;

 public:
  /// Adds a mesh of any type: s.add(m, {.field = u, .edges = true, .visible = below('x', 0.3)}).
  /// Needs, Cost, Errors: as make_drawable.      Result: the scene, which holds no copy of the mesh and no reference to it.
  template<EmbeddedMesh M>
  scene& add(const M& m, const mesh_look<M>& look = {}) { return add(make_drawable(m, look)); }

  /// Adds a drawable, for example one made by make_drawable.
  scene& add(drawable d) {
    drawables_.push_back(std::move(d));
    return *this;
  }

  /// Adds a text beside a point. It is left out of pictures in which something hides the point.
  /// Needs:  text in UTF-8.      Result: the scene.      Cost: O(length of the text).
  /// Errors: invalid_argument if the point is not finite.
  scene& add_label(const vec3& at, std::string text) {
    if (!is_finite(at)) core::throw_joined<invalid_argument>({"scene: the point of the label \"", text, "\" is not finite"});
    labels_.push_back({at, std::move(text)});
    return *this;
  }

  // What to write instead of calls that cannot compile.
  template<class... T> void add(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
  template<class... T> void add(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

  /// What was added, in this order.
  std::span<const drawable> drawables() const { return drawables_; }
  std::span<const point_label> labels() const { return labels_; }
  /// The last drawable added, to change its appearance.
  drawable& last() { return drawables_.back(); }
};

}  // namespace concino

// Scenes: the things that a picture shows.
#pragma once

#include <concino/render/drawable.hpp>

#include <span>
#include <utility>
#include <vector>

namespace concino {

/// Several things to draw together. Each is prepared when it is added: later changes of a mesh or of its fields are not seen.
class scene {
  std::vector<drawable> drawables_;

 public:
  /// Adds a drawable, for example one made by make_drawable.
  scene& add(drawable d) {
    drawables_.push_back(std::move(d));
    return *this;
  }

  /// What was added, in this order.
  std::span<const drawable> drawables() const { return drawables_; }
  /// The last drawable added, to change its appearance.
  drawable& last() { return drawables_.back(); }
};

}  // namespace concino

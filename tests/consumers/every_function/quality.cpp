#include "call.hpp"

#include <concino/quality.hpp>

void call_quality() {
  constexpr auto what = cn::metric::mean_ratio;
  constexpr auto shape = cn::poly_shape::triangle;
  const cn::vec3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  call("mean_ratio", [&] {
    cn::mean_ratio(o, x, y);
    cn::mean_ratio(o, x, y, z);
  });
  call("scaled_jacobian", [&] {
    cn::scaled_jacobian(o, x, y);
    cn::scaled_jacobian(o, x, y, z);
  });
  call("is_defined", [&] { cn::is_defined(what, shape); });
  call("limits_of", [&] { cn::limits_of(what, shape); });
  call("is_acceptable", [&] { cn::is_acceptable(what, shape, 0.5); });
  call("larger_is_worse", [&] { cn::larger_is_worse(what); });
  call("is_worse", [&] { cn::is_worse(what, 0.5, 0.6); });
  call("name_of", [&] {
    cn::name_of(what);
    cn::name_of(shape);
  });
  call("metric_named", [&] { cn::metric_named(cn::name_of(what)); });
  call("quality", [&] { cn::quality(shape, std::vector{o, x, y}, what); });
  call("quality", [&](auto& m) {
    cn::quality(m, first(cn::polys(m)), cn::metric::planarity);
    cn::quality(m, cn::metric::planarity);
  }, all);
  call("shape_of_poly", [](auto& m) { cn::shape_of_poly(m, first(cn::polys(m))); }, all);
  call("mean_poly_size", [](auto& m) { cn::mean_poly_size(m); }, all);
  call("scaled_jacobian", [](auto& m) { cn::scaled_jacobian(m, first(cn::polys(m))); }, kinds<cn::trimesh, cn::quadmesh, cn::tetmesh, cn::hexmesh>());
  call("mean_ratio", [](auto& m) { cn::mean_ratio(m, first(cn::polys(m))); }, kinds<cn::trimesh, cn::tetmesh>());
  call("planarity", [](auto& m) { cn::planarity(m, first(cn::polys(m))); }, all);
  call("star_shapedness", [](auto& m) { cn::star_shapedness(m, first(cn::polys(m))); }, all);
  call("histogram", [](auto& m) { cn::histogram(m, cn::metric::planarity); }, all);
  call("worst", [](auto& m) { cn::worst(m, cn::metric::planarity); }, all);
}

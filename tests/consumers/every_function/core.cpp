#include "call.hpp"

#include <concino/core/parallel.hpp>
#include <concino/core/product.hpp>
#include <concino/core/rgba.hpp>
#include <concino/core/tangent_vector.hpp>
#include <concino/core/vec3.hpp>

#include <array>

void call_core() {
  const cn::vec3 a{1, 2, 3}, b{4, 5, 6};
  call("dot", [&] { cn::dot(a, b); });
  call("cross", [&] { cn::cross(a, b); });
  call("norm", [&] { cn::norm(a); });
  call("distance", [&] { cn::distance(a, b); });
  call("is_finite", [&] { cn::is_finite(a); });
  call("to_vec3", [&] { cn::to_vec3(std::array<double, 3>{1, 2, 3}); });
  const cn::tangent_vector t{1, 2};
  call("dot", [&] { cn::dot(t, t); });
  call("norm", [&] { cn::norm(t); });
  call("angle", [&] { cn::angle(t); });
  call("rgba_of_bytes", [] { cn::rgba_of_bytes(1, 2, 3); });
  std::vector<int> numbers(5000);
  call("parallel_for", [&] { cn::parallel_for(numbers.size(), [&](std::size_t i) { numbers[i] = 1; }); });
  call("parallel_for_each", [](auto& m) { cn::parallel_for_each(cn::polys(m), [](auto) {}); }, all);
  Eigen::SparseMatrix<double> i(2, 2);
  i.setIdentity();
  call("with_both_triangles", [&] { cn::with_both_triangles(i); });
  call("scaled_product", [&] { cn::scaled_product(i, {1.0, 2.0}, i); });
}

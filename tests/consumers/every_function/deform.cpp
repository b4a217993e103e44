#include "call.hpp"

#include <concino/deform.hpp>
#include <concino/generate.hpp>

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

void call_deform() {
  const auto cage = cn::icosphere(1);
  const auto inner = cn::make_box<cn::hexmesh>({.min = {-0.3, -0.3, -0.3}, .max = {0.3, 0.3, 0.3}});
  const auto box = cn::make_box<cn::hexmesh>({.cells = {2, 2, 2}});
  const auto around = cn::make_box<cn::quadmesh>({.cells = {1, 1, 1}});
  const std::vector<cn::vec3> points{{0.1, 0.2, 0.1}}, square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto a = cn::vert_id{0}, b = cn::vert_id{1};
  call("cage_coordinates", [&](auto& m) { cn::cage_coordinates(cage, m); }, all);
  call("cage_coordinates", [&] { cn::cage_coordinates(cage, points).points_of(cage); });
  call("cage_coordinates", [&] { cn::cage_coordinates(square, points); });
  call("green_coordinates", [&] { cn::green_coordinates(cage, inner).points_of(cage); });
  call("harmonic_coordinates", [&] { cn::harmonic_coordinates(box, around).points_of(around); });
  call("translation", [] { cn::translation({1, 0, 0}); });
  call("rotation", [] { cn::rotation({0, 0, 0}, {0, 0, 1}, 1); });
  call("is_rigid", [] { cn::is_rigid(cn::affine_map()); });
  call("best_rigid_motion", [&] { cn::best_rigid_motion(points, points); });
  const cn::skin_weights weights(cn::num_verts(box), 2, [&] {
    std::vector<cn::skin_weight> w;
    for (const auto v : cn::verts(box)) w.push_back({v.raw(), v.raw() % 2, 1});
    return w;
  }());
  const std::array<cn::affine_map, 2> rest;
  call("skin", [&] { cn::skin(box, weights, rest, cn::linear_blend); });
  call("skin", [&] { cn::skin(box, weights, rest, cn::dual_quaternions); });
  call("prepare_deform", [&](auto& m) {
    const auto v = *cn::verts(m).begin();
    cn::prepare_deform(m, {v}).with_positions({{v, cn::vec3{1, 2, 3}}});
  }, all);
  call("biharmonic_deform", [&](auto& m) { cn::biharmonic_deform(m, {{*cn::verts(m).begin(), cn::vec3{1, 2, 3}}}); }, all);
  call("laplacian_deform", [&](auto& m) {
    std::vector<std::pair<cn::vert_t<std::remove_cvref_t<decltype(m)>>, cn::vec3>> everywhere;
    for (const auto v : cn::verts(m)) everywhere.push_back({v, cn::vec3{1, 2, 3}});
    cn::laplacian_deform(m, everywhere);
  }, all);
  const cn::skeleton k({{-0.5, 0, 0}, {0, 0, 0}, {0.5, 0, 0}}, {{a, b}, {b, cn::vert_id{2}}});
  call("heat_weights", [&] { cn::heat_weights(cage, k); });
  call("bounded_biharmonic_weights", [&] { cn::bounded_biharmonic_weights(box, {{a}, {b}}); });
  call("transfer_weights", [&] { cn::transfer_weights(box, weights, around); });
}

// Measures the smallest ball around points against CGAL's Min_sphere_of_spheres_d, the smallest circle in the plane against the same, and the skeleton of a
// surface against its Mean_curvature_flow_skeletonization, with its options as they are by default. Also lscm against its Surface_mesh_parameterization.
#include "../support/kinds.hpp"

#include <concino/generate/grid.hpp>
#include <concino/geometry/enclosing_ball.hpp>
#include <concino/parametrize/lscm.hpp>
#include <concino/skeleton/skeleton_of.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Min_sphere_of_points_d_traits_2.h>
#include <CGAL/Min_sphere_of_points_d_traits_3.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace {

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using surface = CGAL::Surface_mesh<kernel::Point_3>;
using plain = CGAL::Simple_cartesian<double>;

surface surface_of(const bench::surface_arrays& a) {
  surface s;
  std::vector<surface::Vertex_index> v;
  for (const auto& x : a.points) v.push_back(s.add_vertex({x.x, x.y, x.z}));
  for (std::size_t i = 0; i < a.verts.size(); i += 3) s.add_face(v[a.verts[i].raw()], v[a.verts[i + 1].raw()], v[a.verts[i + 2].raw()]);
  return s;
}

void check(const std::string& work, double here, double there) {
  if (!(std::abs(here - there) <= 1e-9 * here)) throw std::runtime_error(work + ": CGAL and the library differ");
}

template<class Ours, class Theirs>
void compare(const bench::program& p, const std::string& work, int rounds, const Ours& ours, const Theirs& theirs) {
  p.print(bench::compare(work, rounds, {{"concino", [&] { return bench::seconds_of(ours); }}, {"cgal", [&] { return bench::seconds_of(theirs); }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (const std::string work = "enclosing-ball.tri1m"; p.wants(work)) {
      const auto points = p.data.tri1m().points;
      std::vector<plain::Point_3> same;
      for (const auto& x : points) same.emplace_back(x.x, x.y, x.z);
      const auto ours = [&] { return concino::enclosing_ball(points).radius; };
      const auto theirs = [&] { return CGAL::Min_sphere_of_spheres_d<CGAL::Min_sphere_of_points_d_traits_3<plain, double>>(same.begin(), same.end()).radius(); };
      check(work, ours(), theirs());
      compare(p, work, p.rounds, ours, theirs);
    }
    if (const std::string work = "enclosing-circle.tri1m"; p.wants(work)) {
      auto points = p.data.tri1m().points;
      for (auto& x : points) x.z = 0;
      std::vector<plain::Point_2> same;
      for (const auto& x : points) same.emplace_back(x.x, x.y);
      const auto ours = [&] { return concino::enclosing_ball(points).radius; };
      const auto theirs = [&] { return CGAL::Min_sphere_of_spheres_d<CGAL::Min_sphere_of_points_d_traits_2<plain, double>>(same.begin(), same.end()).radius(); };
      check(work, ours(), theirs());
      compare(p, work, p.rounds, ours, theirs);
    }
    if (const std::string work = "skeleton-of.bunny"; p.wants(work)) {
      const auto arrays = p.data.bunny();
      const concino::trimesh m(arrays);
      const surface s = surface_of(arrays);
      using skeletonization = CGAL::Mean_curvature_flow_skeletonization<surface>;
      const auto ours = [&] { return concino::skeleton_of(m).skeleton.num_verts(); };
      const auto theirs = [&] {
        skeletonization::Skeleton k;
        skeletonization flow(s);
        flow(k);
        return num_vertices(k);
      };
      compare(p, work, std::min(p.rounds, 3), ours, theirs);
    }
    if (const std::string work = "lscm.hill20k"; p.wants(work)) {
      const std::size_t n = p.data.tiny ? 10 : 100;
      auto m = concino::make_grid<concino::trimesh>({.cells = {n, n}});
      surface s;
      std::vector<surface::Vertex_index> v;
      for (const auto x : concino::verts(m)) {
        const concino::vec3 at = concino::point(m, x);
        concino::set_point(m, x, concino::vec3{at.x, at.y, 0.3 * std::sin(3 * at.x) * std::cos(4 * at.y)});
        v.push_back(s.add_vertex({concino::point(m, x).x, concino::point(m, x).y, concino::point(m, x).z}));
      }
      for (const auto t : concino::polys(m)) {
        std::vector<surface::Vertex_index> corners;
        for (const auto x : concino::adj_p2v(m, t)) corners.push_back(v[x.raw()]);
        s.add_face(corners);
      }
      const auto uv = s.add_property_map<surface::Vertex_index, kernel::Point_2>("v:uv").first;
      auto boundary = *s.halfedges().begin();
      for (const auto h : s.halfedges())
        if (s.is_border(h)) boundary = h;
      namespace smp = CGAL::Surface_mesh_parameterization;
      const auto ours = [&] { return concino::lscm(m)[concino::vert_id{0}][0]; };
      const auto theirs = [&] { return smp::parameterize(s, smp::LSCM_parameterizer_3<surface>(), boundary, uv); };
      compare(p, work, std::min(p.rounds, 3), ours, theirs);
    }
  });
}

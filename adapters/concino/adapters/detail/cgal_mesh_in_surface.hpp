// One call of CGAL's 3D mesher for a surface of triangles.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/generate/tetrahedralize_options.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <unordered_map>
#include <vector>

namespace concino {

struct cgal_tetrahedralize_options {
  double facet_distance = 0;         // how far the boundary of the tets may be from the surface; 0: 1/200 of the
                                     // diagonal of its box
  double facet_angle_deg = 25;       // the least angle of boundary faces, in degrees, at most 30
  double facet_size = 0;             // the largest radius of a circle around a boundary face; 0: any
  double feature_angle_deg = 180;    // edges at which the surface turns by this angle or more, in degrees, are kept;
                                     // 180: none
  double feature_edge_length = 0;    // the longest edge along kept edges; 0: 1/20 of the diagonal
  double radius_edge = 2;            // the largest ratio of the radius of the circumsphere of a tet to its shortest
                                     // edge, 2 or more
  double max_volume = 0;             // of a tet; 0: any
  function_ref<double(const vec3&)> edge_length = nullptr;  // the longest edge of tets at a point, above 0
  std::size_t max_verts = 10'000'000;                       // more are an error, so that refinement ends
  concino::progress progress = nullptr;                     // may stop the mesher; the fraction does not change while
                                                            // it runs
  concino::profiler* profiler = nullptr;                    // measures the call and its steps
};

namespace detail {

class cgal_mesh_in_surface {
  using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using surface = CGAL::Surface_mesh<kernel::Point_3>;
  using domain = CGAL::Polyhedral_mesh_domain_with_features_3<kernel, surface>;
  using triangulation = CGAL::Mesh_triangulation_3<domain>::type;
  using complex = CGAL::Mesh_complex_3_in_triangulation_3<triangulation>;
  using criteria = CGAL::Mesh_criteria_3<triangulation>;

  const tetrahedralize_input& in_;
  const cgal_tetrahedralize_options& options_;

  /// The largest radius of circumspheres at a point. CGAL calls copies of it often, so it also reports progress.
  struct cell_size {
    using FT = double;
    using Point_3 = triangulation::Geom_traits::Point_3;
    using Index = domain::Index;
    const cgal_tetrahedralize_options* options;
    double largest;
    std::atomic<bool>* stop;
    std::exception_ptr* error;
    std::size_t* calls;

    template<class P>
    double operator()(const P& p, int, const Index&) const {
      double radius = largest;
      if (*error) return radius;
      try {
        if (options->progress && ++*calls % 1024 == 0) report_progress(options->progress, 0, "tetrahedralizing");
        if (options->edge_length) {
          const double length =
              options->edge_length({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
          if (!(length > 0)) throw invalid_argument("tetrahedralize: edge_length is not above 0");
          radius = std::min(radius, length / 2);
        }
      } catch (...) {
        *error = std::current_exception();  // CGAL does not expect exceptions there
        stop->store(true);
      }
      return radius;
    }
  };

  surface input_surface() const {
    surface m;
    std::vector<surface::Vertex_index> vert(in_.points.size());
    for (std::size_t i = 0; i < in_.points.size(); ++i)
      vert[i] = m.add_vertex({in_.points[i].x, in_.points[i].y, in_.points[i].z});
    for (const auto& t : in_.triangles)
      if (m.add_face(vert[t[0]], vert[t[1]], vert[t[2]]) == surface::null_face())
        throw unsupported(
            "tetrahedralize: CGAL needs a surface with one fan of polys at each vert; split_vert_fans() makes one");
    return m;
  }

  tetrahedralize_output output_of(const complex& c) const {
    tetrahedralize_output out;
    std::unordered_map<const void*, std::uint32_t> number;
    for (auto cell = c.cells_in_complex_begin(); cell != c.cells_in_complex_end(); ++cell) {
      std::array<std::uint32_t, 4> t;
      for (int k = 0; k < 4; ++k) {
        const auto v = cell->vertex(k);
        const auto [at, is_new] = number.try_emplace(&*v, static_cast<std::uint32_t>(out.points.size()));
        if (is_new) {
          const auto& p = v->point();
          out.points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
        }
        t[static_cast<std::size_t>(k)] = at->second;
      }
      out.tets.push_back(t);
    }
    return out;
  }

 public:
  cgal_mesh_in_surface(const tetrahedralize_input& in, const cgal_tetrahedralize_options& options)
      : in_(in), options_(options) {}

  tetrahedralize_output fill(double distance) const {
    namespace p = CGAL::parameters;
    CGAL::Random random(0);  // so that the result is the same each time
    std::atomic<bool> stop = false;
    std::exception_ptr error;
    std::size_t calls = 0;
    try {
      const surface m = input_surface();
      domain d(m, &random);
      if (options_.feature_angle_deg < 180) d.detect_features(options_.feature_angle_deg);
      const double any = std::numeric_limits<double>::max();
      // the largest tet in a sphere is the regular one, of volume 8 sqrt(3) / 27 r^3
      const double radius =
          options_.max_volume > 0 ? std::cbrt(options_.max_volume * 27 / (8 * std::sqrt(3.0))) : in_.diagonal;
      const criteria wanted(
          p::edge_size = options_.feature_edge_length > 0 ? options_.feature_edge_length : in_.diagonal / 20,
          p::facet_angle = options_.facet_angle_deg,
          p::facet_size = options_.facet_size > 0 ? options_.facet_size : any, p::facet_distance = distance / 2,
          p::cell_radius_edge_ratio = options_.radius_edge,
          p::cell_size = cell_size{&options_, radius, &stop, &error, &calls});
      CGAL::Mesh_error_code code = CGAL::CGAL_MESH_3_NO_ERROR;
      const complex c = CGAL::make_mesh_3<complex>(
          d, wanted, p::no_perturb(),  // perturbation would make results depend on addresses in memory
          p::mesh_3_options(p::maximal_number_of_vertices = options_.max_verts, p::pointer_to_error_code = &code,
                            p::pointer_to_stop_atomic_boolean = &stop));
      if (error) std::rethrow_exception(error);
      if (code == CGAL::CGAL_MESH_3_MAXIMAL_NUMBER_OF_VERTICES_REACHED)
        core::throw_joined<unsupported>(
            {"tetrahedralize: CGAL would need more than ", options_.max_verts, " verts, which is max_verts"});
      return output_of(c);
    } catch (const CGAL::Failure_exception& e) {
      core::throw_joined<unsupported>({"tetrahedralize: CGAL failed: ", e.what()});
    }
  }
};

}  // namespace detail

}  // namespace concino

// The input of a remeshing: the nearest point of its surface, and the length that edges shall have there. All points
// and lengths are unit ones.
#pragma once

#include <concino/convert/convert.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/remesh/detail/unit_points.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace concino::detail {

class surface_sizes {
  polygonmesh input_;
  poly_tree<polygonmesh> tree_;
  vert_map<polygonmesh, vec3> normals_;
  std::vector<double> sizes_;  // of the verts of the input; none: all edges shall have one length
  double size_ = 0;

 public:
  struct sample {
    vec3 point;
    vec3 normal;  // the mean of those around; zero if they cancel
    double size = 0;
  };

  /// sizes: of the verts of m, in their order, or none.
  template<class M>
  surface_sizes(const M& m, const unit_points& unit, std::vector<double> sizes, double size)
      : input_(in_unit_box(convert<polygonmesh>(m), unit)), tree_(input_), normals_(vert_normals(input_)),
        sizes_(std::move(sizes)), size_(unit.length_to_unit(size)) {
    for (double& x : sizes_) x = unit.length_to_unit(x);
  }
  surface_sizes(const surface_sizes&) = delete;  // the tree refers to the input
  surface_sizes& operator=(const surface_sizes&) = delete;

  double distance_to(const vec3& x) const { return tree_.closest(x).distance; }

  /// The nearest point of the input. Normal and size are means of those of the corners there, weighted by the inverses
  /// of their squared distances.
  sample nearest(const vec3& x) const {
    const auto hit = tree_.closest(x);
    double longest = 0;
    for (const vert_id v : adj_p2v(input_, hit.poly))
      longest = std::max(longest, distance(hit.point, point(input_, v)));
    sample sum{hit.point, {}, 0};
    double weights = 0;
    for (const vert_id v : adj_p2v(input_, hit.poly)) {
      const double d = longest > 0 ? distance(hit.point, point(input_, v)) / longest : 0;
      const double weight = 1 / std::max(d * d, 1e-16);
      sum.normal += weight * normals_[v], sum.size += weight * size_of(v), weights += weight;
    }
    sum.size /= weights;
    if (const double length = norm(sum.normal) / weights; length > 0.1) sum.normal = sum.normal / (length * weights);
    else sum.normal = {};
    return sum;
  }

 private:
  static polygonmesh in_unit_box(polygonmesh m, const unit_points& unit) {
    for (const vert_id v : verts(m)) set_point(m, v, unit.at(m, v));
    return m;
  }
  double size_of(vert_id v) const { return sizes_.empty() ? size_ : sizes_[v.raw()]; }
};

}  // namespace concino::detail

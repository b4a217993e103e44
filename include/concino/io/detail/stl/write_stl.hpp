// The writer of STL: triangles, as text, or binary on request.
#pragma once

#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/io/detail/stl/stl_format.hpp>
#include <concino/io/detail/text/write_common.hpp>
#include <concino/io/detail/values/point_numbers.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

namespace concino::detail {

class stl_writer {
  write_context& c_;
  flat_mesh& m_;
  const bool binary_;
  flat_values<std::uint16_t> attribute_;
  flat_values<std::string> object_;
  bool rounded_ = false;
  std::vector<vec3> points_;          // those that readers tell apart, as the file holds them
  std::vector<std::size_t> of_vert_;  // the place of each vert in points_, or unused
  static constexpr std::size_t unused = static_cast<std::size_t>(-1);
  polygon_triangulator triangulate_;
  std::vector<vec3> corners_;

  /// A coordinate as the file holds it.
  double stored(double x) {
    if (!binary_) return x;
    const float f = static_cast<float>(x);
    if (!std::isfinite(f))
      c_.throw_cannot_hold("binary .stl", {"a coordinate that is too large for floats"}, "text, with binary = false");
    rounded_ = rounded_ || static_cast<double>(f) != x;
    return static_cast<double>(f);
  }

  /// Errors: unsupported if the poly is no triangle and is not to be cut into some, or if two corners are at one point,
  ///         so that readers would see one vert twice.
  void check(std::size_t p) const {
    const std::size_t n = m_.poly_verts[p].size();
    if (n != 3 && !c_.options.as_triangles)
      c_.throw_cannot_hold(
          ".stl", {"poly ", m_.poly_index(p), " of ", n, " corners, unless options.as_triangles is set"},
          ".ply or .obj");
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < k && n == 3; ++i)
        if (corners_[k] == corners_[i])
          c_.throw_cannot_hold(binary_ ? "binary .stl" : ".stl",
                               {"poly ", m_.poly_index(p), ", which has two corners at the same point",
                                binary_ ? " once they are rounded to floats" : ""},
                               ".ply or .obj");
  }

  /// Calls f(corners) for each triangle of a poly. Needs: the points in corners_.
  template<class F>
  void for_each_triangle(const F& f) {
    if (corners_.size() == 3) return f(std::array<vec3, 3>{corners_[0], corners_[1], corners_[2]});
    for (const polygon_triangle& t : triangulate_(corners_)) {
      const std::array<vec3, 3> x{corners_[t[0]], corners_[t[1]], corners_[t[2]]};
      if (!(x[0] == x[1]) && !(x[1] == x[2]) && !(x[2] == x[0])) f(x);
    }
  }
  void collect_corners(std::size_t p) {
    corners_.clear();
    for (const vert_id v : m_.poly_verts[p]) corners_.push_back(points_[of_vert_[v.raw()]]);
  }
  /// Fills points_ and of_vert_. Verts that readers unite are written alike, also if one is at 0 and the other at -0.
  void number_points() {
    point_numbers number(points_);
    of_vert_.assign(m_.points.size(), unused);
    for (std::size_t p = 0; p < m_.num_polys; ++p)
      for (const vert_id v : m_.poly_verts[p]) {
        const vec3& q = m_.points[v.raw()];
        if (of_vert_[v.raw()] == unused) of_vert_[v.raw()] = number({stored(q.x), stored(q.y), stored(q.z)}).raw();
      }
  }

  /// The unit normal, or zero if the triangle has none. Sides are scaled first, so that products are finite.
  static vec3 normal_of(const std::array<vec3, 3>& x) {
    double largest = 0;
    for (const vec3& p : x) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const vec3 a = (1 / largest) * x[1] - (1 / largest) * x[0], b = (1 / largest) * x[2] - (1 / largest) * x[0];
    const vec3 n = cross(a, b);
    const double length = norm(n);
    const vec3 unit = (1 / length) * n;
    return length > 0 && is_finite(unit) ? unit : vec3{};
  }

  void bytes(std::uint32_t x, int n) {
    for (int i = 0; i < n; ++i, x >>= 8) c_.out << static_cast<char>(x & 255);
  }
  void triangle(const std::array<vec3, 3>& x, std::size_t p) {
    const vec3 n = normal_of(x);
    if (binary_) {
      for (const vec3& q : {n, x[0], x[1], x[2]})
        for (const double coordinate : {q.x, q.y, q.z})
          bytes(std::bit_cast<std::uint32_t>(static_cast<float>(coordinate)), 4);
      return bytes(attribute_ ? std::uint32_t{attribute_[p]} : 0u, 2);
    }
    c_.out << "facet normal ";
    write_point(c_.out, n);
    c_.out << "\nouter loop\n";
    for (const vec3& q : x) {
      c_.out << "vertex ";
      write_point(c_.out, q);
      c_.out << '\n';
    }
    c_.out << "endloop\nendfacet\n";
  }

  /// Whether readers find this name behind "solid".
  static bool can_be_read(const std::string& name) {
    return name.find_first_of(std::string_view("\0\r\n", 3)) == name.npos &&
           (name.empty() || (!is_blank(name.front()) && !is_blank(name.back())));
  }
  /// The name of the solid of poly p.
  std::string name_of_solid(std::size_t p) const {
    return object_ && can_be_read(object_[p]) ? object_[p] : std::string();
  }

 public:
  stl_writer(write_context& c, flat_mesh& m)
      : c_(c), m_(m), binary_(c.options.binary), attribute_(m.poly_values<std::uint16_t>("attribute")),
        object_(m.poly_values<std::string>("object")) {
    bool all_are_read = true;
    for (std::size_t p = 0; object_ && p < m.num_polys; ++p) all_are_read = all_are_read && can_be_read(object_[p]);
    if (binary_) c.declare_stored<std::uint16_t>(element_kind::poly, "attribute");
    else if (all_are_read) c.declare_stored<std::string>(element_kind::poly, "object");
  }

  void write() {
    number_points();
    std::uint64_t num_triangles = 0;
    std::size_t num_polygons = 0;
    for (std::size_t p = 0; p < m_.num_polys; ++p) {
      collect_corners(p);
      check(p);
      num_polygons += corners_.size() != 3;
      for_each_triangle([&](const auto&) { ++num_triangles; });
    }
    if (num_triangles > 0xFFFFFFFFu) c_.throw_cannot_hold(".stl", {"so many triangles"}, ".ply");
    const auto num_unused = static_cast<std::size_t>(std::count(of_vert_.begin(), of_vert_.end(), unused));
    if (binary_) {
      constexpr std::string_view title = "binary STL";
      c_.out << title << std::string(80 - title.size(), ' ');
      bytes(static_cast<std::uint32_t>(num_triangles), 4);
    }
    std::string name;
    for (std::size_t p = 0; p < m_.num_polys; ++p) {
      if (!binary_ && (p == 0 || name_of_solid(p) != name)) {
        if (p != 0) c_.out << "endsolid " << name << '\n';
        name = name_of_solid(p);
        c_.out << "solid " << name << '\n';
      }
      collect_corners(p);
      for_each_triangle([&](const auto& x) { triangle(x, p); });
      c_.report_progress();
    }
    if (!binary_) c_.out << (m_.num_polys ? "" : "solid \n") << "endsolid " << name << '\n';
    report(num_unused, num_polygons);
  }

 private:
  void report(std::size_t num_unused, std::size_t num_polygons) {
    const auto lost = [&](std::size_t n, const char* what) {
      if (n) c_.report.lost.push_back(core::joined({n, what}));
    };
    lost(num_unused, " verts of no poly: .stl lists the corners of triangles only");
    lost(m_.points.size() - num_unused - points_.size(),
         " verts at the point of another one: readers of .stl unite them");
    lost(num_polygons, " polygons were cut into triangles");
    if (rounded_) c_.report.lost.push_back("binary .stl holds floats: coordinates were rounded to 32 bits");
  }
};

}  // namespace concino::detail

namespace concino {

inline void stl_format::write(write_context& c, flat_mesh& m) { detail::stl_writer(c, m).write(); }

}  // namespace concino

// OpenMesh types of many kinds for tests, and their construction from arrays by OpenMesh's own functions.
#pragma once

#include <concino/adapters/openmesh.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/meshes.hpp>

#include <OpenMesh/Core/Geometry/EigenVectorT.hh>

#include <doctest/doctest.h>

#include <array>
#include <set>
#include <vector>

namespace concino::testing::om {

/// A user's point type with operator[], and the arithmetic operators that OpenMesh needs.
struct own_point {
  std::array<float, 3> x{};
  own_point() = default;
  own_point(float a, float b, float c) : x{a, b, c} {}
  float& operator[](int i) { return x[static_cast<std::size_t>(i)]; }
  float operator[](int i) const { return x[static_cast<std::size_t>(i)]; }
  friend own_point operator+(const own_point& a, const own_point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
  friend own_point operator-(const own_point& a, const own_point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
};

}  // namespace concino::testing::om

template<>
struct OpenMesh::vector_traits<concino::testing::om::own_point> {
  using vector_type = concino::testing::om::own_point;
  using value_type = float;
  static const size_t size_ = 3;
  static size_t size() { return size_; }
};

namespace concino::testing::om {

struct floats : OpenMesh::DefaultTraits {};
struct doubles : OpenMesh::DefaultTraitsDouble {};
struct with_status : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
struct eigen_points : OpenMesh::DefaultTraits {
  using Point = Eigen::Vector3d;
  using Normal = Eigen::Vector3d;
  using TexCoord2D = Eigen::Vector2d;
};
struct own_points : OpenMesh::DefaultTraits {
  using Point = own_point;
};
struct homogeneous : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec4d;
};
struct planar : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec2d;
};

using tri_float = OpenMesh::TriMesh_ArrayKernelT<floats>;
using tri_double = OpenMesh::TriMesh_ArrayKernelT<doubles>;
using tri_status = OpenMesh::TriMesh_ArrayKernelT<with_status>;
using poly_double = OpenMesh::PolyMesh_ArrayKernelT<doubles>;
using poly_status = OpenMesh::PolyMesh_ArrayKernelT<with_status>;
using poly_eigen = OpenMesh::PolyMesh_ArrayKernelT<eigen_points>;
using tri_own = OpenMesh::TriMesh_ArrayKernelT<own_points>;
using poly_homogeneous = OpenMesh::PolyMesh_ArrayKernelT<homogeneous>;
using tri_planar = OpenMesh::TriMesh_ArrayKernelT<planar>;

/// Classes of a user, derived once and twice; the second can be neither copied nor moved.
struct mine : tri_status {
  std::vector<int> notes;
};
class only_one : public mine {
 public:
  only_one() = default;
  only_one(const only_one&) = delete;
  only_one& operator=(const only_one&) = delete;
};

template<class M>
inline constexpr bool triangles_only = std::derived_from<M, OpenMesh::TriConnectivity>;

/// Adds the verts and polys of the arrays to m, in their order.
template<class M>
void fill(M& m, const surface_arrays& arrays) {
  const surface_arrays s = with_offsets(arrays);
  for (const vec3& x : s.points) {
    using scalar = typename M::Scalar;
    constexpr auto coordinates = OpenMesh::vector_traits<typename M::Point>::size_;
    typename M::Point p;
    p[0] = static_cast<scalar>(x.x);
    p[1] = static_cast<scalar>(x.y);
    if constexpr (coordinates > 2) p[2] = static_cast<scalar>(x.z);
    if constexpr (coordinates > 3) p[3] = 1;
    m.add_vertex(p);
  }
  for (std::size_t p = 0; p + 1 < s.offsets.size(); ++p) {
    std::vector<OpenMesh::VertexHandle> corners;
    for (std::size_t i = s.offsets[p]; i < s.offsets[p + 1]; ++i) corners.push_back(m.vertex_handle(s.verts[i].raw()));
    REQUIRE(m.add_face(corners).is_valid());
  }
}

/// Two disjoint grids and an isolated vert.
template<class M>
surface_arrays two_grids(unsigned n) {
  surface_arrays s = with_offsets(triangles_only<M> ? triangle_grid(n) : polygon_grid(n));
  const surface_arrays one = s;
  for (const vec3& x : one.points) s.points.push_back(x + vec3{2, 0, 0});
  for (const vert_id v : one.verts) s.verts.push_back(vert_id(v.raw() + one.points.size()));
  for (std::size_t i = 1; i < one.offsets.size(); ++i) s.offsets.push_back(one.offsets.back() + one.offsets[i]);
  s.points.push_back({5, 5, 0});
  return s;
}

/// Fails with every law that m breaks. With the connectivity as M, one instantiation is enough for meshes of all kinds.
template<class M = OpenMesh::PolyConnectivity>
void check_laws_hold(const M& m) {
  const auto broken = check_laws(m);
  for (const auto& b : broken) MESSAGE(b.law << ": " << b.what);
  CHECK(broken.empty());
}

/// Fails unless every ring of m equals, as a set of indices, that of the native mesh with the same points and the polys of m that are not deleted.
inline void check_rings(const OpenMesh::PolyConnectivity& m) {
  using numbers = std::multiset<std::size_t>;
  surface_arrays s;
  s.arity = 0;
  s.offsets = {0};
  s.points.resize(m.n_vertices());
  std::vector<OpenMesh::FaceHandle> poly_list;
  for (unsigned i = 0; i < m.n_faces(); ++i) {
    const OpenMesh::FaceHandle f = m.face_handle(i);
    if (m.has_face_status() && m.status(f).deleted()) continue;
    poly_list.push_back(f);
    for (const auto v : m.fv_range(f)) s.verts.push_back(vert_id(v.idx()));
    s.offsets.push_back(static_cast<std::uint32_t>(s.verts.size()));
  }
  const polygonmesh native(s);
  const auto of = [&](const auto& range) {
    numbers r;
    for (const auto x : range) r.insert(index_of(m, x));
    return r;
  };
  const auto polys_of = [&](const auto& range) {
    numbers r;
    for (const auto p : range) r.insert(static_cast<std::size_t>(poly_list[index_of(native, p)].idx()));
    return r;
  };
  const auto verts_of = [&](const auto& range) {
    numbers r;
    for (const auto v : range) r.insert(index_of(native, v));
    return r;
  };
  CHECK(num_polys(m) == num_polys(native));
  CHECK(num_edges(m) == num_edges(native));
  for (const auto v : verts(m)) {
    const vert_id w(index_of(m, v));
    CHECK(of(adj_v2v(m, v)) == verts_of(adj_v2v(native, w)));
    CHECK(of(adj_v2p(m, v)) == polys_of(adj_v2p(native, w)));
  }
  for (std::size_t i = 0; i < poly_list.size(); ++i) {
    const auto p = poly_list[i];
    CHECK(of(adj_p2p(m, p)) == polys_of(adj_p2p(native, poly_id(i))));
    std::vector<std::size_t> cycle, expected;
    for (const auto v : adj_p2v(m, p)) cycle.push_back(index_of(m, v));
    for (const auto v : adj_p2v(native, poly_id(i))) expected.push_back(index_of(native, v));
    CHECK(cycle == expected);
  }
}

}  // namespace concino::testing::om

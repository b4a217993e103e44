// What tests of distributed meshes share: processes, partitions, elements by their number, and properties.
#pragma once

#include <concino/adapters/distributed.hpp>
#include <concino/adapters/metis_partition.hpp>
#include <concino/core/rgba.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/property.hpp>

#include <support/same_mesh.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace distributed_tests {

inline int rank() {
  int r = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &r);
  return r;
}
inline int number_of_processes() {
  int n = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &n);
  return n;
}
inline bool is_first() { return rank() == 0; }

inline double sum_of_all(double x) {
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return x;
}

/// Native meshes without deleted elements number verts and polys by index.
template<class M, class X>
std::uint64_t number(const M& m, const X& x) { return concino::index_of(m, x); }
template<class M>
auto vert_at(const M&, std::uint64_t i) { return concino::vert_t<M>{static_cast<unsigned>(i)}; }
template<class M>
auto poly_at(const M&, std::uint64_t i) { return concino::poly_t<M>{static_cast<unsigned>(i)}; }

/// Partitions for this number of processes: by METIS; every n-th poly, so that parts are scattered; all polys on the last process; and slabs of equal
/// numbers of polys, which are thin on small grids.
template<class M>
std::vector<concino::poly_map<M, int>> parts_of(const M& m) {
  const auto n = static_cast<std::size_t>(number_of_processes());
  std::vector<concino::poly_map<M, int>> r(4, concino::make_poly_map<int>(m, 0));
  r[0] = concino::partition(m, n, concino::metis).part;
  std::size_t i = 0;
  for (const auto p : concino::polys(m)) {
    r[1][p] = static_cast<int>(i % n);
    r[2][p] = static_cast<int>(n - 1);
    r[3][p] = static_cast<int>(i * n / concino::num_polys(m));
    ++i;
  }
  return r;
}

inline double magnitude(double x) { return std::abs(x); }
inline double magnitude(const concino::vec3& x) { return concino::norm(x); }

/// Between a map of a distributed mesh and one of the whole mesh, at the verts of this process and its ghosts, relative to the largest value of the latter.
template<class M, class X, class T>
double largest_difference(const concino::element_map<concino::distributed<M>, X, T>& u, const concino::element_map<M, X, T>& expected) {
  double worst = 0, largest = 0;
  for (const auto v : concino::verts(expected.mesh())) largest = std::max(largest, magnitude(expected[v]));
  for (const auto v : concino::verts(u.mesh()))
    worst = std::max(worst, magnitude(u[v] - expected[vert_at(expected.mesh(), u.mesh().global_number(v))]));
  return worst / largest;
}

/// Gives a mesh properties of many types. Those of polys have values in their second half alone, those of faces at a few alone.
template<class M>
void add_values(M& m) {
  using namespace concino;
  auto heat = vert_property<double>(m, "heat");
  auto texture = vert_property<std::array<float, 2>>(m, "texture");
  auto normal = vert_property<vec3>(m, "normal");
  for (const auto v : verts(m)) {
    const auto i = static_cast<double>(index_of(m, v));
    heat[v] = 0.25 + i, texture[v] = {static_cast<float>(i), 1}, normal[v] = {i, 0, -i};
  }
  auto label = poly_property<int>(m, "label");
  auto byte = poly_property<std::uint8_t>(m, "byte");
  auto color = poly_property<rgba>(m, "color");
  for (const auto p : polys(m))
    if (const std::size_t i = index_of(m, p); 2 * i >= num_polys(m)) label[p] = static_cast<int>(3 * i), byte[p] = 7, color[p] = {0, 0.5f, 0, 1};
  *mesh_property<double>(m, "time") = 0.75;
  if constexpr (dimension_v<M> == 3) {
    auto patch = face_property<int>(m, "patch");
    for (const auto f : faces(m)) patch[f] = index_of(m, f) < 3;
  }
}

/// Checks that a distributed mesh has the properties of the whole mesh, at ghosts too, except names and those of edges, faces and corners.
template<class M>
void check_properties(const concino::distributed<M>& d, const M& m) {
  using namespace concino;
  std::size_t num_kept = 0, num_wrong = 0;
  for (const property_info& p : property_list(m)) {
    const bool is_kept = p.kind == element_kind::vert || p.kind == element_kind::poly || p.kind == element_kind::mesh;
    if (!is_kept || *p.type == typeid(std::string)) continue;
    ++num_kept;
    CAPTURE(p.name);
    REQUIRE(traits<distributed<M>>::properties(d).values_if_any(p.kind, p.name, *p.type) != nullptr);
    const std::string whole = concino::testing::bytes_of_property(m, p), local = concino::testing::bytes_of_property(d, p);
    const auto compare = [&](const auto& elements, std::size_t bound) {
      for (const auto x : elements) {
        const std::size_t size = whole.size() / bound;
        num_wrong += local.compare(index_of(d, x) * size, size, whole, d.global_number(x) * size, size) != 0;
      }
    };
    if (p.kind == element_kind::vert) compare(verts(d), vert_index_bound(m));
    else if (p.kind == element_kind::poly) compare(polys(d), poly_index_bound(m));
    else num_wrong += local != whole;
    for (const property_info& q : property_list(d)) num_wrong += q.kind == p.kind && q.name == p.name && q.rule != p.rule;
  }
  const property_set& all = traits<distributed<M>>::properties(d);
  for (std::size_t i = 0; i < all.size(); ++i) num_wrong += all.kind(i) == element_kind::mesh && all.values(i)->size() != 1;
  CHECK(num_wrong == 0);
  CHECK(property_list(d).size() == num_kept);
}

/// A folder that all processes see, from the first one. Its end waits for all of them.
class shared_folder {
  std::optional<concino::testing::temporary_folder> own_;
  std::string path_;

 public:
  shared_folder() {
    if (is_first()) path_ = own_.emplace().path();
    int length = static_cast<int>(path_.size());
    MPI_Bcast(&length, 1, MPI_INT, 0, MPI_COMM_WORLD);
    path_.resize(static_cast<std::size_t>(length));
    MPI_Bcast(path_.data(), length, MPI_CHAR, 0, MPI_COMM_WORLD);
  }
  shared_folder(const shared_folder&) = delete;
  shared_folder& operator=(const shared_folder&) = delete;
  ~shared_folder() { MPI_Barrier(MPI_COMM_WORLD); }
  std::string operator/(const std::string& file) const { return path_ + "/" + file; }
};

}  // namespace distributed_tests

// What nearly every test file uses of the six native meshes, compiled once. Only precompiled headers include this, so that programs with other flags compile
// their own.
#pragma once

#include <support/kinds.hpp>
#include <support/whole_mesh.hpp>

// The adjacency tables. clang++ 14 cannot use these: an explicit instantiation there includes members whose requirements do not hold. It would gain little.

#define CONCINO_TEST_TABLES(EXTERN, ...) \
  EXTERN template class __VA_ARGS__;     \
  EXTERN template class concino::detail::native_mesh<__VA_ARGS__>
#define CONCINO_TEST_FACET_ADJACENCY(EXTERN, facet, arity) EXTERN template class concino::detail::facet_adjacency<facet, arity>

#define CONCINO_TEST_NATIVE_TABLES(EXTERN)                                                                 \
  CONCINO_TEST_FACET_ADJACENCY(EXTERN, concino::edge_id, 0);                                                         \
  CONCINO_TEST_FACET_ADJACENCY(EXTERN, concino::edge_id, 3);                                                         \
  CONCINO_TEST_FACET_ADJACENCY(EXTERN, concino::edge_id, 4);                                                         \
  CONCINO_TEST_FACET_ADJACENCY(EXTERN, concino::face_id, 0);                                                         \
  CONCINO_TEST_FACET_ADJACENCY(EXTERN, concino::face_id, 4);                                                         \
  CONCINO_TEST_FACET_ADJACENCY(EXTERN, concino::face_id, 6);                                                         \
  EXTERN template class concino::detail::jagged_array<concino::vert_id, 0>;                                        \
  CONCINO_TEST_TABLES(EXTERN, concino::surface_tables<0>);                                                 \
  CONCINO_TEST_TABLES(EXTERN, concino::surface_tables<3>);                                                 \
  CONCINO_TEST_TABLES(EXTERN, concino::surface_tables<4>);                                                 \
  CONCINO_TEST_TABLES(EXTERN, concino::cell_tables<concino::detail::tet_shape>);                           \
  CONCINO_TEST_TABLES(EXTERN, concino::cell_tables<concino::detail::hex_shape>);                           \
  CONCINO_TEST_TABLES(EXTERN, concino::basic_polyhedra_tables<concino::detail::jagged_array<concino::vert_id, 0>>)

#ifndef __clang__
CONCINO_TEST_NATIVE_TABLES(extern);
#endif

// Tests of edits spend most of their time comparing meshes.
#define CONCINO_TEST_WHOLE_MESHES(EXTERN)                                                         \
  EXTERN template std::vector<double> concino::testing::whole(const concino::trimesh&);           \
  EXTERN template std::vector<double> concino::testing::whole(const concino::quadmesh&);          \
  EXTERN template std::vector<double> concino::testing::whole(const concino::polygonmesh&);       \
  EXTERN template std::vector<double> concino::testing::whole(const concino::tetmesh&);           \
  EXTERN template std::vector<double> concino::testing::whole(const concino::hexmesh&);           \
  EXTERN template std::vector<double> concino::testing::whole(const concino::polyhedralmesh&)

CONCINO_TEST_WHOLE_MESHES(extern);

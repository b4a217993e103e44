// The six native mesh types, their properties and maps, and views of other meshes.
#pragma once

#include <concino/concepts/views.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/mesh/cell_tables.hpp>
#include <concino/mesh/corner.hpp>
#include <concino/mesh/corner_orders.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/correspondence.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/mesh/facet_map.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/indexed_base.hpp>
#include <concino/mesh/mesh_point.hpp>
#include <concino/mesh/native_mesh.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedra_tables.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/property.hpp>
#include <concino/mesh/property_set.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/submesh.hpp>
#include <concino/mesh/surface_tables.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>

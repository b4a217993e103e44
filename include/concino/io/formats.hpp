// All formats of the library, in the order in which messages name them.
#pragma once

#include <concino/io/detail/abaqus/abaqus_format.hpp>
#include <concino/io/detail/gmsh/gmsh_format.hpp>
#include <concino/io/detail/gltf/gltf_format.hpp>
#include <concino/io/detail/hedra/hedra_format.hpp>
#include <concino/io/detail/hybrid/hybrid_format.hpp>
#include <concino/io/detail/iv/iv_format.hpp>
#include <concino/io/detail/medit/medit_format.hpp>
#include <concino/io/detail/obj/obj_format.hpp>
#include <concino/io/detail/off/off_format.hpp>
#include <concino/io/detail/openfoam/openfoam_format.hpp>
#include <concino/io/detail/ovm/ovm_format.hpp>
#include <concino/io/detail/ply/ply_format.hpp>
#include <concino/io/detail/pvtu/pvtu_format.hpp>
#include <concino/io/detail/stl/stl_format.hpp>
#include <concino/io/detail/tet/tet_format.hpp>
#include <concino/io/detail/tetgen/ele_format.hpp>
#include <concino/io/detail/tetgen/smesh_format.hpp>
#include <concino/io/detail/vtk/vtk_format.hpp>
#include <concino/io/detail/vtk_xml/vtp_format.hpp>
#include <concino/io/detail/vtk_xml/vtu_format.hpp>

namespace concino {

/// The formats that load, load_any and save know by default; save leaves out those that are only read, and load those
/// that are only written. Add your own: standard_formats + my_format{}.
inline constexpr format_list<obj_format, off_format, medit_format, hedra_format, hybrid_format, tet_format, iv_format,
                             vtk_format, vtu_format, vtp_format, ply_format, stl_format, gmsh_format, openfoam_format,
                             ele_format, smesh_format, poly_format, abaqus_format, ovm_format, gltf_format, pvtu_format>
    standard_formats{};

}  // namespace concino

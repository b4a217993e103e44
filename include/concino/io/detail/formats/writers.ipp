// Compiles the writers of all formats into the compiled library.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/gmsh/write_gmsh.hpp>
#include <concino/io/detail/gltf/write_gltf.hpp>
#include <concino/io/detail/hedra/write_hedra.hpp>
#include <concino/io/detail/hybrid/write_hybrid.hpp>
#include <concino/io/detail/medit/write_medit.hpp>
#include <concino/io/detail/obj/write_obj.hpp>
#include <concino/io/detail/off/write_off.hpp>
#include <concino/io/detail/openfoam/write_openfoam.hpp>
#include <concino/io/detail/ovm/write_ovm.hpp>
#include <concino/io/detail/ply/write_ply.hpp>
#include <concino/io/detail/stl/write_stl.hpp>
#include <concino/io/detail/tet/write_tet.hpp>
#include <concino/io/detail/tetgen/write_ele.hpp>
#include <concino/io/detail/tetgen/write_smesh.hpp>
#include <concino/io/detail/vtk/write_vtk.hpp>
#include <concino/io/detail/vtk_xml/write_vtp.hpp>
#include <concino/io/detail/vtk_xml/write_vtu.hpp>

#ifdef CONCINO_COMPILED
namespace concino {

// The writers are inline. Taking their addresses makes the compiler emit them here.
namespace {
[[gnu::used]] void (*const writers[])(write_context&, flat_mesh&) = {&gltf_format::write,
                                                                     &hedra_format::write,
                                                                     &hybrid_format::write,
                                                                     &medit_format::write,
                                                                     &obj_format::write,
                                                                     &off_format::write,
                                                                     &openfoam_format::write,
                                                                     &ovm_format::write,
                                                                     &ply_format::write,
                                                                     &stl_format::write,
                                                                     &tet_format::write,
                                                                     &vtk_format::write<write_context>,
                                                                     &vtu_format::write<write_context>,
                                                                     &vtp_format::write<write_context>,
                                                                     &gmsh_format::write,
                                                                     &ele_format::write,
                                                                     &smesh_format::write,
                                                                     &poly_format::write};
}  // namespace

}  // namespace concino
#endif

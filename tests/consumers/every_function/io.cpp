#include "call.hpp"

#include <concino/io.hpp>
#include <concino/io/numbers.hpp>

#include <fstream>

namespace {

inline constexpr kinds<cn::tetmesh, cn::hexmesh> cells;

void call_formats() {
  call("save_obj", [](auto& m) { cn::save_obj(m, "m.obj"); }, surfaces);
  call("load_obj", [](auto& m) { cn::save_obj(m, "m.obj"), cn::load_obj<std::remove_reference_t<decltype(m)>>("m.obj"); }, surfaces);
  call("save_off", [](auto& m) { cn::save_off(m, "m.off"); }, surfaces);
  call("load_off", [](auto& m) { cn::save_off(m, "m.off"), cn::load_off<std::remove_reference_t<decltype(m)>>("m.off"); }, surfaces);
  call("load_iv", [](auto& m) {
    std::ofstream("m.iv") << "#Inventor V2.1 ascii\nCoordinate3 { point [ 0 0 0, 1 0 0, 1 1 0 ] }\nIndexedFaceSet { coordIndex [ 0, 1, 2, -1 ] }\n";
    cn::load_iv<std::remove_reference_t<decltype(m)>>("m.iv");
  }, kinds<cn::trimesh, cn::polygonmesh>());
  call("save_hedra", [](auto& m) { cn::save_hedra(m, "m.hedra"); }, volumes);
  call("load_hedra", [](auto& m) { cn::save_hedra(m, "m.hedra"), cn::load_hedra<std::remove_reference_t<decltype(m)>>("m.hedra"); }, volumes);
  call("save_hybrid", [](auto& m) { cn::save_hybrid(m, "m.hybrid"); }, cells);
  call("load_hybrid", [](auto& m) { cn::save_hybrid(m, "m.hybrid"), cn::load_hybrid<std::remove_reference_t<decltype(m)>>("m.hybrid"); }, cells);
  call("save_tet", [](auto& m) { cn::save_tet(m, "m.tet"); }, tets);
  call("load_tet", [](auto& m) { cn::save_tet(m, "m.tet"), cn::load_tet<std::remove_reference_t<decltype(m)>>("m.tet"); }, tets);
  call("save_medit", [](auto& m) { cn::save_medit(m, "m.mesh"); }, kinds<cn::trimesh, cn::quadmesh, cn::tetmesh, cn::hexmesh>());
  call("load_medit", [](auto& m) { cn::save_medit(m, "m.mesh"), cn::load_medit<std::remove_reference_t<decltype(m)>>("m.mesh"); },
       kinds<cn::trimesh, cn::quadmesh, cn::tetmesh, cn::hexmesh>());
  call("save_vtk", [](auto& m) { cn::save_vtk(m, "m.vtk"); }, all);
  call("load_vtk", [](auto& m) { cn::save_vtk(m, "m.vtk"), cn::load_vtk<std::remove_reference_t<decltype(m)>>("m.vtk"); }, all);
  call("save_vtp", [](auto& m) { cn::save_vtp(m, "m.vtp"); }, surfaces);
  call("load_vtp", [](auto& m) { cn::save_vtp(m, "m.vtp"), cn::load_vtp<std::remove_reference_t<decltype(m)>>("m.vtp"); }, surfaces);
  call("save_ply", [](auto& m) { cn::save_ply(m, "m.ply"); }, surfaces);
  call("load_ply", [](auto& m) { cn::save_ply(m, "m.ply"), cn::load_ply<std::remove_reference_t<decltype(m)>>("m.ply"); }, surfaces);
  call("save_stl", [](auto& m) { cn::save_stl(m, "m.stl"); }, kinds<cn::trimesh>());
  call("load_stl", [](auto& m) { cn::save_stl(m, "m.stl"), cn::load_stl<std::remove_reference_t<decltype(m)>>("m.stl"); }, kinds<cn::trimesh>());
  call("save_openfoam", [](auto& m) { cn::save_openfoam(m, "polyMesh"); }, volumes);
  call("load_openfoam", [](auto& m) { cn::save_openfoam(m, "polyMesh"), cn::load_openfoam<std::remove_reference_t<decltype(m)>>("polyMesh"); }, volumes);
  call("save_ovm", [](auto& m) { cn::save_ovm(m, "m.ovm"); }, volumes);
  call("load_ovm", [](auto& m) { cn::save_ovm(m, "m.ovm"), cn::load_ovm<std::remove_reference_t<decltype(m)>>("m.ovm"); }, volumes);
  call("save_gltf", [](auto& m) { cn::save_gltf(m, "m.glb", {.as_triangles = true, .as_boundary = true}); }, all);
  call("load_abaqus", [](auto& m) {
    std::ofstream("m.inp") << "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n*ELEMENT, TYPE=S3\n1, 1, 2, 3\n";
    cn::load_abaqus<std::remove_reference_t<decltype(m)>>("m.inp");
  }, kinds<cn::trimesh, cn::polygonmesh>());
  call("save_ele", [](auto& m) { cn::save_ele(m, "m.ele"); }, kinds<cn::tetmesh>());
  call("load_ele", [](auto& m) { cn::save_ele(m, "m.ele"), cn::load_ele<std::remove_reference_t<decltype(m)>>("m.ele"); }, kinds<cn::tetmesh>());
  call("save_smesh", [](auto& m) { cn::save_smesh(m, "m.smesh"); }, surfaces);
  call("load_smesh", [](auto& m) { cn::save_smesh(m, "m.smesh"), cn::load_smesh<std::remove_reference_t<decltype(m)>>("m.smesh"); }, surfaces);
  call("save_poly", [](auto& m) { cn::save_poly(m, "m.poly"); }, surfaces);
  call("load_poly", [](auto& m) { cn::save_poly(m, "m.poly"), cn::load_poly<std::remove_reference_t<decltype(m)>>("m.poly"); }, surfaces);
  call("save_gmsh", [](auto& m) { cn::save_gmsh(m, "m.msh"); }, kinds<cn::trimesh, cn::quadmesh, cn::tetmesh, cn::hexmesh>());
  call("load_gmsh", [](auto& m) { cn::save_gmsh(m, "m.msh"), cn::load_gmsh<std::remove_reference_t<decltype(m)>>("m.msh"); },
       kinds<cn::trimesh, cn::quadmesh, cn::tetmesh, cn::hexmesh>());
  call("save_vtu", [](auto& m) { cn::save_vtu(m, "m.vtu"); }, all);
  call("load_vtu", [](auto& m) { cn::save_vtu(m, "m.vtu"), cn::load_vtu<std::remove_reference_t<decltype(m)>>("m.vtu"); }, all);
}

}  // namespace

void call_io() {
  call_formats();
  call("save", [](auto& m) { cn::save(m, "m.vtu"); }, all);
  call("load", [](auto& m) { cn::save(m, "m.vtu"), cn::load<std::remove_reference_t<decltype(m)>>("m.vtu"); }, all);
  call("save_text", [](auto& m) { cn::save_text(m, cn::file_format::vtu); }, all);
  call("load_text", [](auto& m) { cn::load_text<std::remove_reference_t<decltype(m)>>(cn::save_text(m, cn::file_format::vtu), cn::file_format::vtu); }, all);
  call("save_pvtu", [](auto& m) { cn::save_pvtu(m, "m.pvtu", cn::make_poly_map<int>(m)); }, all);
  call("load_pvtu", [](auto& m) {
    cn::save_pvtu(m, "m.pvtu", cn::make_poly_map<int>(m));
    cn::load_pvtu<std::remove_reference_t<decltype(m)>>("m.pvtu");
  }, all);
  call("load_slice", [](auto& m) {
    cn::save(m, "m.vtu", {.binary = true});
    cn::load_slice<std::remove_reference_t<decltype(m)>>("m.vtu", 0, 2);
  }, all);
  call("load_any", [](auto& m) { cn::save(m, "m.vtu"), cn::load_any("m.vtu"); }, all);
  call("save_field", [](auto& m) {
    cn::save_field(heights(m), m, "verts.txt");
    cn::save_field(cn::make_poly_map<double>(m), m, "polys.txt");
  }, all);
  call("load_vert_field", [](auto& m) { cn::save_field(heights(m), m, "verts.txt"), cn::load_vert_field<double>(m, "verts.txt"); }, all);
  call("load_poly_field", [](auto& m) { cn::save_field(cn::make_poly_map<double>(m), m, "polys.txt"), cn::load_poly_field<double>(m, "polys.txt"); }, all);
  call("explain_format", [] { cn::explain_format<std::remove_cvref_t<decltype(cn::file_format::obj)>>(); });
  call("save_skeleton", [] { cn::save_skeleton({}, "k.skel"); });
  call("load_skeleton", [] { cn::save_skeleton({}, "k.skel"), cn::load_skeleton("k.skel"); });
  call("save_skeleton_text", [] { cn::save_skeleton_text({}, {.format = cn::file_format::skel}); });
  call("load_skeleton_text", [] {
    const auto format = cn::file_format::skel;
    cn::load_skeleton_text(cn::save_skeleton_text({}, {.format = format}), {.format = format});
  });
  call("save_slices", [] { cn::save_slices({}, "s.cli"); });
  call("load_slices", [] { cn::save_slices({}, "s.cli"), cn::load_slices("s.cli"); });
  call("save_slices_text", [] { cn::save_slices_text({}, {}); });
  call("load_slices_text", [] { cn::load_slices_text(cn::save_slices_text({}, {})); });
  const std::string number = "12";
  call("parse_real", [&] {
    double x;
    cn::parse_real(number.data(), number.data() + number.size(), x);
  });
  call("parse_integer", [&] {
    std::int64_t i;
    cn::parse_integer(number.data(), number.data() + number.size(), i);
  });
}

// The writer of .vtp files: polygons as text, or with appended raw bytes.
#pragma once

#include <concino/io/detail/vtk_xml/vtk_xml_output.hpp>
#include <concino/io/detail/vtk_xml/vtp_format.hpp>

namespace concino {

template<std::same_as<write_context> Context>
void vtp_format::write(Context& c, flat_mesh& m) {
  const detail::vtk_output_arrays<Context> arrays(c, m, false);
  const std::uint64_t corners = m.poly_verts.values.size();
  detail::vtk_xml_output<Context> out(c,
                                      std::max<std::uint64_t>({8 * corners, 72 * m.num_polys, 72 * m.points.size()}));
  out.begin("PolyData");
  const auto of_elements = [](const detail::vtk_output_array& a, std::size_t i) { return a.value(i); };
  const auto corner_verts = [&](function_ref<void(const void*)> use) {
    for (std::size_t p = 0; p < m.num_polys; ++p) {
      for (const vert_id v : m.poly_verts[p]) {
        const std::int64_t x = v.raw();
        use(&x);
      }
      c.report_progress();
    }
  };
  const auto ends = [&](function_ref<void(const void*)> use) {
    std::int64_t end = 0;
    for (std::size_t p = 0; p < m.num_polys; ++p) {
      end += static_cast<std::int64_t>(m.poly_verts[p].size());
      use(&end);
    }
  };
  const auto all = [&] {
    out.tag("<PolyData>");
    if (!arrays.of_mesh.empty()) {
      out.tag("<FieldData>");
      detail::write_vtk_xml_arrays(out, arrays.of_mesh, 1, " NumberOfTuples=\"1\"", of_elements);
      out.tag("</FieldData>");
    }
    out.tag("<Piece NumberOfPoints=\"", m.points.size(),
            "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"", m.num_polys, "\">");
    detail::write_vtk_xml_points(out, c, m, arrays);
    out.tag("<Polys>");
    out.array("connectivity", {detail::vtk_number::int64, 1}, corners, "", corner_verts);
    out.array("offsets", {detail::vtk_number::int64, 1}, m.num_polys, "", ends);
    out.tag("</Polys>");
    if (!arrays.of_cells.empty()) {
      out.tag("<CellData>");
      detail::write_vtk_xml_arrays(out, arrays.of_cells, m.num_polys, "", of_elements);
      out.tag("</CellData>");
    }
    out.tag("</Piece>");
    out.tag("</PolyData>");
  };
  out.arrays(all);
  out.tag("</VTKFile>");
}

}  // namespace concino

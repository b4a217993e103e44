// A model of lib3mf that is made of a mesh, and its file.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/hash_bytes.hpp>
#include <concino/core/message.hpp>
#include <concino/core/rgba.hpp>
#include <concino/io/flat_mesh.hpp>
#include <concino/io/flat_triangles.hpp>
#include <concino/io/write_context.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include <Model/COM/NMR_DLLInterfaces.h>

namespace concino::detail {

/// An object of lib3mf, released at the end.
class lib3mf_object {
  NMR::PLib3MFBase* object_ = nullptr;

 public:
  lib3mf_object() = default;
  lib3mf_object(const lib3mf_object&) = delete;
  lib3mf_object& operator=(const lib3mf_object&) = delete;
  ~lib3mf_object() {
    if (object_) NMR::lib3mf_release(object_);
  }
  NMR::PLib3MFBase* get() const { return object_; }
  NMR::PLib3MFBase** out() { return &object_; }
};

/// The bytes of a file that lib3mf writes piece by piece.
struct lib3mf_bytes {
  std::string text;
  std::size_t at = 0;
  bool is_out_of_memory = false;

  // Exceptions must not pass through lib3mf. Other values than 0 end its work.
  static std::uint32_t put(const unsigned char* from, std::uint32_t n, void* to) noexcept {
    auto& b = *static_cast<lib3mf_bytes*>(to);
    return b.reserve(b.at + n) ? (std::memcpy(b.text.data() + b.at, from, n), b.at += n, 0u) : 1u;
  }
  static std::uint32_t seek(unsigned long long position, void* to) noexcept {
    auto& b = *static_cast<lib3mf_bytes*>(to);
    b.at = static_cast<std::size_t>(position);
    return b.reserve(b.at) ? 0u : 1u;
  }

 private:
  bool reserve(std::size_t size) noexcept {
    try {
      if (text.size() < size) text.resize(size);
    } catch (const std::exception&) {
      is_out_of_memory = true;
    }
    return !is_out_of_memory;
  }
};

class lib3mf_model {
  write_context& c_;
  flat_mesh& m_;
  flat_values<rgba> vert_colors_, poly_colors_;
  std::vector<NMR::MODELMESHVERTEX> verts_;
  std::vector<NMR::MODELMESHTRIANGLE> triangles_;
  std::vector<std::uint32_t> polys_;  // of the triangles
  bool rounded_ = false, colors_rounded_ = false;
  lib3mf_object model_, mesh_, item_, writer_;

  /// Errors: unsupported if a function of lib3mf failed, with the reason that the object has.
  void check(int result, const lib3mf_object& object) const {
    if (result == LIB3MF_OK) return;
    DWORD code = 0;
    LPCSTR reason = nullptr;
    if (!object.get() || NMR::lib3mf_getlasterror(object.get(), &code, &reason) != LIB3MF_OK) reason = nullptr;
    core::throw_joined<unsupported>(
        {c_.name, ": lib3mf cannot write the mesh: ", reason && *reason ? reason : "no reason is known"});
  }

  /// A coordinate as the file holds it: a float with six decimals.
  float stored(double x) {
    if (!(std::abs(x) < 1e9)) c_.throw_cannot_hold(".3mf", {"a coordinate of 1e9 millimetres or more"}, ".ply or .obj");
    const float f = static_cast<float>(x);
    const double micro = 1e6 * x;
    rounded_ = rounded_ || static_cast<double>(f) != x || std::trunc(micro) != micro;
    return f;
  }
  void collect() {
    for (const vec3& p : m_.points) {
      verts_.push_back({{stored(p.x), stored(p.y), stored(p.z)}});
      c_.report_progress();
    }
    flat_triangles triangles(c_, m_, ".3mf", ".ply or .obj");
    for (std::size_t p = 0; p < m_.num_polys; ++p) {
      for (const std::array<vert_id, 3>& t : triangles(p)) {
        triangles_.push_back({{t[0].raw(), t[1].raw(), t[2].raw()}});
        polys_.push_back(static_cast<std::uint32_t>(p));
      }
      c_.report_progress();
    }
    triangles.report_cut(c_.report);
    if (verts_.size() > 0x7FFFFFFFu || triangles_.size() > 0x7FFFFFFFu)
      c_.throw_cannot_hold(".3mf", {"so many verts or triangles"}, ".ply");
  }

  /// The name of the object, if lib3mf takes it.
  void set_name() {
    const std::string* const name = m_.mesh_value<std::string>("name");
    if (!name) return;
    const bool is_text = std::all_of(name->begin(), name->end(), [](char x) { return x < 0 || (x >= 32 && x != 127); });
    if (is_text && NMR::lib3mf_object_setnameutf8(mesh_.get(), name->c_str()) == LIB3MF_OK)
      c_.declare_stored<std::string>(element_kind::mesh, "name");
  }

  NMR::MODELMESHCOLOR_SRGB stored(const rgba& x) {
    const auto part = [&](float y) {
      const float limited = y >= 0 ? std::min(y, 1.0f) : 0.0f;
      const auto b = static_cast<std::uint8_t>(std::lround(255 * static_cast<double>(limited)));
      colors_rounded_ = colors_rounded_ || static_cast<float>(b / 255.0) != y;
      return b;
    };
    return {part(x.r), part(x.g), part(x.b), part(x.a)};
  }
  void set_colors() {
    if ((!vert_colors_ && !poly_colors_) || triangles_.empty()) return;
    lib3mf_object by_default, of_triangles;  // the object must have a colour too, for triangles without one
    check(NMR::lib3mf_object_createdefaultpropertyhandler(mesh_.get(), by_default.out()), mesh_);
    check(NMR::lib3mf_defaultpropertyhandler_setcolorrgba(by_default.get(), 255, 255, 255, 255), by_default);
    check(NMR::lib3mf_meshobject_createpropertyhandler(mesh_.get(), of_triangles.out()), mesh_);
    std::vector<NMR::MODELMESH_TRIANGLECOLOR_SRGB> all;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      NMR::MODELMESH_TRIANGLECOLOR_SRGB x;
      for (std::size_t k = 0; k < 3; ++k)
        x.m_Colors[k] = stored(vert_colors_ ? vert_colors_[triangles_[t].m_nIndices[k]] : poly_colors_[polys_[t]]);
      all.push_back(x);
    }
    check(NMR::lib3mf_propertyhandler_setgradientcolorarray(of_triangles.get(), all.data()), of_triangles);
  }

  /// A name of the file's parts that follows from the mesh, where lib3mf would take random ones.
  std::string uuid(std::uint64_t part) const {
    std::uint64_t h[] = {part, part ^ 0x9E3779B97F4A7C15u};
    for (std::uint64_t& x : h) {
      for (const NMR::MODELMESHVERTEX& v : verts_)
        for (const float f : v.m_fPosition) x = core::scrambled(x ^ std::bit_cast<std::uint32_t>(f));
      for (const NMR::MODELMESHTRIANGLE& t : triangles_)
        for (const DWORD i : t.m_nIndices) x = core::scrambled(x ^ i);
    }
    std::string s;
    for (int k = 0; k < 32; ++k) {
      if (k == 8 || k == 12 || k == 16 || k == 20) s += '-';
      s += k == 12 ? '4' : k == 16 ? '8' : "0123456789abcdef"[h[k / 16] >> 4 * (k % 16) & 15];
    }
    return s;
  }
  void set_uuids() {
    check(NMR::lib3mf_object_setuuidutf8(mesh_.get(), uuid(1).c_str()), mesh_);
    check(NMR::lib3mf_builditem_setuuidutf8(item_.get(), uuid(2).c_str()), item_);
    check(NMR::lib3mf_model_setbuilduuidutf8(model_.get(), uuid(3).c_str()), model_);
  }

 public:
  lib3mf_model(write_context& c, flat_mesh& m)
      : c_(c), m_(m), vert_colors_(m.vert_values<rgba>("color")), poly_colors_(m.poly_values<rgba>("color")) {
    if (vert_colors_) c.declare_stored<rgba>(element_kind::vert, "color");
    else if (poly_colors_) c.declare_stored<rgba>(element_kind::poly, "color");
  }

  void write() {
    verts_.reserve(1), triangles_.reserve(1);  // lib3mf takes no null pointers
    collect();
    check(NMR::lib3mf_createmodel(model_.out()), model_);
    check(NMR::lib3mf_model_setunit(model_.get(), NMR::MODELUNIT_MILLIMETER), model_);
    check(NMR::lib3mf_model_addmeshobject(model_.get(), mesh_.out()), model_);
    check(NMR::lib3mf_meshobject_setgeometry(mesh_.get(), verts_.data(), static_cast<DWORD>(verts_.size()),
                                             triangles_.data(), static_cast<DWORD>(triangles_.size())),
          mesh_);
    BOOL is_solid = 0;
    check(NMR::lib3mf_meshobject_ismanifoldandoriented(mesh_.get(), &is_solid), mesh_);
    check(NMR::lib3mf_object_settype(mesh_.get(), is_solid ? NMR::MODELOBJECTTYPE_MODEL : NMR::MODELOBJECTTYPE_SURFACE),
          mesh_);
    set_name();
    set_colors();
    check(NMR::lib3mf_model_addbuilditem(model_.get(), mesh_.get(), nullptr, item_.out()), model_);
    set_uuids();
    check(NMR::lib3mf_model_querywriter(model_.get(), "3mf", writer_.out()), model_);
    lib3mf_bytes bytes;
    const int result = NMR::lib3mf_writer_writetocallback(writer_.get(), reinterpret_cast<void*>(&lib3mf_bytes::put),
                                                          reinterpret_cast<void*>(&lib3mf_bytes::seek), &bytes);
    if (bytes.is_out_of_memory) throw std::bad_alloc();
    check(result, writer_);
    c_.out << bytes.text;
    if (rounded_) c_.report.lost.push_back(".3mf holds floats with six decimals: coordinates were rounded");
    if (colors_rounded_) c_.report.lost.push_back(".3mf holds colours of 8 bits: parts were rounded");
  }
};

}  // namespace concino::detail

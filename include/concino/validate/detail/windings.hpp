// Finds polys with inconsistent windings at shared edges (surfaces) or faces (volumes).
#pragma once

#include <concino/core/message.hpp>
#include <concino/validate/detail/defect_log.hpp>
#include <concino/validate/detail/parity_sets.hpp>

namespace concino::detail {

/// The polys at one edge (face): their number, the first two by index, and how many traverse it forward (turn their
/// outside to its front).
struct shared_by {
  std::uint32_t polys = 0;
  std::uint32_t forward = 0;
  std::uint32_t poly[2] = {0, 0};

  void add(std::size_t poly_index, bool runs_forward) {
    if (polys < 2) poly[polys] = static_cast<std::uint32_t>(poly_index);
    ++polys;
    forward += runs_forward;
  }
  bool clashes() const { return polys == 2 && forward != 1; }
};

/// Reports inconsistent windings if turning polys could repair them; otherwise reports once per component that it is
/// not orientable. `shared`: by index of the elements of the range `all`; polys_of(x) are the polys at x. Only pairs
/// count: if more polys meet, or one of two is not sound, no winding is right.                    Result: whether all
/// polys are orientable.
template<class M, class R, class PolysOf>
bool check_windings(const M& m, const R& all, const PolysOf& polys_of, const std::vector<shared_by>& shared,
                    std::size_t poly_bound, const char* clash_text, defect_log<M>& log) {
  bool any_clash = false;
  for (const shared_by& s : shared) any_clash = any_clash || s.clashes();
  if (!any_clash) return true;

  parity_sets pieces(poly_bound);
  std::vector<std::uint32_t> contradictions;  // polys
  for (const shared_by& s : shared)
    if (s.polys == 2 && !pieces.join(s.poly[0], s.poly[1], s.clashes())) contradictions.push_back(s.poly[0]);
  enum : std::uint8_t { mendable, one_sided, reported };
  std::vector<std::uint8_t> state(poly_bound, mendable);  // by root of a component
  for (const std::uint32_t p : contradictions) state[pieces.find(p).first] = one_sided;

  const auto full_name = [&](const auto& x) {
    if constexpr (std::same_as<std::remove_cvref_t<decltype(x)>, edge_t<M>>) return log.edge_name(x);
    else return log.name(x);
  };
  for (const auto x : all) {
    const shared_by& s = shared[index_of(m, x)];
    if (!s.clashes()) continue;
    std::uint8_t& piece = state[pieces.find(s.poly[0]).first];
    if (piece == reported) continue;
    if (piece == one_sided) {
      piece = reported;
      if (defect<M>* d = log.add(defect_kind::not_orientable, x))
        d->what = core::joined(
            {"the polys connected to ", log.list(*d, polys_of(x)),
             " cannot be wound consistently: they form a one-sided component; their windings conflict, for example, at ",
             full_name(x)});
    } else if (defect<M>* d = log.add(defect_kind::inconsistent_winding, x)) {
      const std::string polys_text = log.list(*d, polys_of(x));
      d->what = core::joined({polys_text, clash_text, full_name(x)});
    }
  }
  return contradictions.empty();
}

}  // namespace concino::detail

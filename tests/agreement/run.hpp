// Runs one algorithm on every model of a family and records the models on which it ran and agreed. The table of docs/agreement.md is made of these lines.
#pragma once

#include <agreement/inputs.hpp>
#include <agreement/matched.hpp>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <string>

namespace concino::agreement {

/// The name of the polys of a kind of mesh.
template<class K> inline constexpr const char* polys_of_kind = nullptr;
template<> inline constexpr const char* polys_of_kind<trimesh> = "triangles";
template<> inline constexpr const char* polys_of_kind<quadmesh> = "quads";
template<> inline constexpr const char* polys_of_kind<polygonmesh> = "polygons";
template<> inline constexpr const char* polys_of_kind<tetmesh> = "tets";
template<> inline constexpr const char* polys_of_kind<hexmesh> = "hexes";
template<> inline constexpr const char* polys_of_kind<polyhedralmesh> = "polyhedra";

/// A list of models, each a class with
///   using kind = trimesh ...;                     the native mesh of the same arrays
///   static constexpr const char* column, *name;   in the table of docs/agreement.md, and its own name
///   static constexpr bool any_surface, gaps;      whether it can hold non-manifold surfaces, and removed elements
///   static void with(const input<...>&, f);       constructs it from an input and calls f(mesh)
/// or, if it cannot be constructed from arrays, own_inputs = true and each(f), which calls f(input, native mesh, mesh).
template<class... Models> struct models {};

/// Writes one line "column|algorithm|model|dimension|ran", or with "not its concept" at the end, to a file of its own. The file exists only after the
/// test has passed.
class record {
  std::string path_, line_;

 public:
  record(const std::string& column, const std::string& algorithm, const std::string& model, int dimension)
      : line_(column + '|' + algorithm + '|' + model + '|' + std::to_string(dimension) + '|') {
#ifdef CONCINO_AGREEMENT_RECORDS
    std::string name = line_;
    for (char& c : name)
      if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    path_ = CONCINO_AGREEMENT_RECORDS "/" + name + ".txt";
    std::filesystem::remove(path_);
#endif
  }
  void write(bool ran) const {
    if (path_.empty()) return;
    std::ofstream file(path_);
    file << line_ << (ran ? "ran" : "not its concept") << '\n';
    expect(bool(file.flush()), "the record can be written");
  }
};

template<class A>
constexpr bool needs_a_shape() {
  if constexpr (requires { A::needs_a_shape; }) return A::needs_a_shape;
  return false;
}

template<class Algorithm, class N, class M, class In>
bool check_on(const N& native, const M& m, const In& in) {
  return Algorithm::check(matched<N, M>(native, m), in);
}

/// Calls f(input, native mesh, other mesh) for every input that the model can hold.
template<class Model, class F>
void each_input(const F& f) {
  using kind = typename Model::kind;
  if constexpr (requires { Model::own_inputs; }) {
    Model::each(f);
  } else {
    for (const auto& in : inputs<kind>()) {
      if (!in.manifold && !Model::any_surface) continue;
      if (!in.gone_polys.empty() && !Model::gaps) continue;
      const auto native = reference<kind>(in);
      Model::with(in, [&](const auto& m) { f(in, native, m); });
    }
  }
}

template<class Algorithm, class Model>
void run_on() {
  const record written(Model::column, Algorithm::name, Model::name, dimension_v<typename Model::kind>);
  bool is_modelled = false;
  int times = 0;
  each_input<Model>([&](const auto& in, const auto& native, const auto& m) {
    if constexpr (Algorithm::template runs_on<std::remove_cvref_t<decltype(m)>>) {
      INFO(std::string(Algorithm::name) << " on " << std::string(Model::name) << ", " << in.name);
      is_modelled = true;
      times += check_on<Algorithm>(native, m, in);
    }
  });
  INFO(std::string(Algorithm::name) << " on " << std::string(Model::name));
  expect(times > 0 || !is_modelled || needs_a_shape<Algorithm>(), "some input is one for this algorithm");
  written.write(times > 0);
}

template<class Algorithm, class... Models>
void run(models<Models...>) {
  (run_on<Algorithm, Models>(), ...);
}

}  // namespace concino::agreement

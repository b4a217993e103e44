// Measures geodesics on surfaces: logarithmic maps against the factorisations and back-substitutions that they need, straightest geodesics in edges that are
// crossed per second, and paths made straight.
#include "support/matrix_keeper.hpp"
#include "support/kinds.hpp"

#include <concino/fields/log_map.hpp>
#include <concino/graph/shortest_path.hpp>
#include <concino/lines/straighten.hpp>
#include <concino/lines/trace_geodesic.hpp>
#include <concino/solve/ldlt.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace cn = concino;
using sparse = Eigen::SparseMatrix<double>;

void log_map(const bench::program& p, const std::string& name, const cn::trimesh& m) {
  const std::string prepare = "log_map.prepare." + name, query = "log_map.query." + name;
  std::vector<sparse> matrices;
  const auto log = cn::prepare_log_map(m, {}, bench::matrix_keeper(&matrices));
  if (matrices.size() != 2) throw std::runtime_error(prepare + ": not two factorisations");
  const cn::vert_id source{0};
  const auto seen = log.log_map_from(source);
  for (const auto v : cn::verts(m))
    if (!(seen.distance[v] < 1e9)) throw std::runtime_error(query + ": a vert is not reached");
  const auto factorised = [&] {
    std::vector<std::unique_ptr<cn::ldlt>> all;
    for (const sparse& a : matrices) {
      all.push_back(std::make_unique<cn::ldlt>());
      all.back()->factorize(a);
    }
    return all;
  };
  if (p.wants(prepare))
    p.print(bench::compare(prepare, std::min(p.rounds, 3),
                           {{"factorisations", [&] { return bench::seconds_of(factorised); }},
                            {"concino", [&] { return bench::seconds_of([&] { return cn::prepare_log_map(m); }); }}}));
  if (!p.wants(query)) return;
  const auto all = factorised();
  Eigen::VectorXd heat = Eigen::VectorXd::Zero(matrices[0].cols()), vectors = Eigen::VectorXd::Zero(matrices[1].cols());
  heat[0] = vectors[0] = 1;
  const Eigen::VectorXd carried = Eigen::VectorXd::Ones(matrices[0].cols()), carried_vectors = Eigen::VectorXd::Ones(matrices[1].cols());
  p.print(bench::compare(query, p.rounds,
                         {{"substitutions", [&] {
                             return bench::seconds_of([&] {
                               return all[0]->solve(heat).sum() + all[1]->solve(vectors).sum() + all[1]->solve(carried_vectors).sum() + all[0]->solve(carried).sum();
                             });
                           }},
                          {"concino", [&] { return bench::seconds_of([&] { return log.log_map_from(source); }); }}}));
}

/// Geodesics in many directions, as long as it takes to cross about a million edges.
void trace(const bench::program& p, const std::string& name, const cn::trimesh& m) {
  const std::string work = "trace_geodesic." + name;
  const auto trace = cn::prepare_trace_geodesic(m);
  double longest = 0;
  for (const auto v : cn::verts(m)) longest = std::max(longest, cn::norm(cn::point(m, v)));
  const double length = (p.data.tiny ? 1 : 500) * longest;
  const auto walk = [&] {
    std::size_t crossed = 0;
    for (int k = 0; k < 8; ++k) crossed += trace.trace_from(cn::vert_id{static_cast<unsigned>(k)}, cn::tangent_vector{std::cos(k), std::sin(k)}, length).points.size();
    return crossed;
  };
  const double millions = static_cast<double>(walk()) / 1e6;
  p.print(bench::compare(work, p.rounds, {{"concino", [&] { return bench::seconds_of(walk) / millions; }}}));
}

void straighten(const bench::program& p, const std::string& name, const cn::trimesh& m) {
  const std::string work = "straighten." + name;
  cn::vert_id last{0};
  for (const auto v : cn::verts(m)) last = v;
  const auto path = cn::shortest_path(m, cn::vert_id{0}, last);
  p.print(bench::compare(work, p.rounds,
                         {{"shortest_path", [&] { return bench::seconds_of([&] { return cn::shortest_path(m, cn::vert_id{0}, last); }); }},
                          {"concino", [&] { return bench::seconds_of([&] { return cn::straighten(m, path); }); }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (p.wants("log_map.prepare.bunny") || p.wants("log_map.query.bunny")) log_map(p, "bunny", cn::trimesh(p.data.bunny()));
    if (p.wants("trace_geodesic.bunny")) trace(p, "bunny", cn::trimesh(p.data.bunny()));
    if (p.wants("straighten.bunny16")) straighten(p, "bunny16", cn::trimesh(p.data.bunny16()));
  });
}

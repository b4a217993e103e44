// expect in 10 lines: give the array a name
#include <concino/adapters/eigen.hpp>

Eigen::MatrixXi made();

auto fine(const Eigen::MatrixXd& v, const Eigen::MatrixXi& f) { return concino::view_tri(v, f); }
auto dangling(const Eigen::MatrixXd& v) { return concino::view_tri(v, made()); }

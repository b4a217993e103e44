// expect: is_no_temporary_array<.*Matrix<int
#include <concino/adapters/eigen.hpp>

Eigen::MatrixXi made();

auto fine(const Eigen::MatrixXd& v, const Eigen::MatrixXi& f) { return concino::view_tri(v, f); }
auto dangling(const Eigen::MatrixXd& v) { return concino::view_tri(v, made()); }

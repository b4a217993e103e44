// expect in 10 lines: concino: no mesh_traits<M>: include the adapter
#include <concino/operators/discretisation.hpp>
#include <concino/operators/uniform.hpp>

int main() { concino::explain_discretisation<decltype(concino::uniform), int>(); }

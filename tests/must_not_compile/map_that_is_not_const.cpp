// expect in 10 lines: operator.. is there, but is not const
#include <concino/concepts/descriptors.hpp>
#include <concino/concepts/maps.hpp>

struct heights { double operator[](concino::vert_id); };

int main() { concino::explain_readable_map<heights, concino::vert_id>(); }

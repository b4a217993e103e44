// Does not compile: what g++ and clang++ say begins with the sentence in message.txt.
#include "ring.hpp"

int main() { concino::explain_primal_graph<half_done>(); }

// Does not compile: the error of g++ and of clang++ begins with the sentence in message.txt.
#include "ring.hpp"

int main() { concino::explain_primal_graph<half_done>(); }

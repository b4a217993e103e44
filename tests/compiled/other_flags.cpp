#include <concino/core/compiled.hpp>

int main() {}

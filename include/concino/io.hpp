// Reading and writing files: OBJ, MEDIT .mesh, .hedra.
#pragma once

#include <concino/io/load.hpp>
#include <concino/io/load_any.hpp>
#include <concino/io/save.hpp>

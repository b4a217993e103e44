// Conversion of a mesh to another mesh type.
#pragma once

#include <concino/convert/convert.hpp>

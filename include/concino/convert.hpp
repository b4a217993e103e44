// Conversion of a mesh to another mesh type.
#pragma once

#include <concino/convert/conversion.hpp>
#include <concino/convert/convert.hpp>

// From a mesh of one kind to a mesh of another.
#pragma once

#include <concino/convert/convert.hpp>

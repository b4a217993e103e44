// Changing a mesh: elements added and removed.
#pragma once

#include <concino/edit/elements.hpp>

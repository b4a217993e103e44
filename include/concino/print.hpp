// 3D printing: overhangs, supports, thin walls, and which way up to print.
#pragma once

#include <concino/print/overhangs.hpp>

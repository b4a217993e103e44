// Curve skeletons: their bones, samples of them, tubes around them, and the skeleton of a surface.
#pragma once

#include <concino/skeleton/bone_curve.hpp>
#include <concino/skeleton/bones.hpp>
#include <concino/skeleton/nearest_bone.hpp>
#include <concino/skeleton/respace.hpp>
#include <concino/skeleton/skeleton_of.hpp>
#include <concino/skeleton/tube.hpp>

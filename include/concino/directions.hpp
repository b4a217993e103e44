// Fields of directions on surfaces, and of frames in volumes.
#pragma once

#include <concino/directions/direction_field.hpp>
#include <concino/directions/frame_field.hpp>
#include <concino/directions/frame_singularities.hpp>
#include <concino/directions/principal_curvatures.hpp>
#include <concino/directions/rosy.hpp>
#include <concino/directions/singularities.hpp>
#include <concino/directions/stripes.hpp>
#include <concino/directions/trivial_connection.hpp>

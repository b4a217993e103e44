// Direction fields on surfaces: the smoothest ones, singularities, connections.
#pragma once

#include <concino/directions/direction_field.hpp>
#include <concino/directions/rosy.hpp>
#include <concino/directions/singularities.hpp>
#include <concino/directions/trivial_connection.hpp>

// Shapes that mark points, lines and vectors in a picture.
#pragma once

#include <concino/render/arrows.hpp>
#include <concino/render/balls.hpp>
#include <concino/render/graph_tubes.hpp>
#include <concino/render/tubes.hpp>

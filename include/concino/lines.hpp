// Lines over surfaces and through volumes: along vector fields, and geodesics.
#pragma once

#include <concino/lines/evenly_spaced_lines.hpp>
#include <concino/lines/field_at_verts.hpp>
#include <concino/lines/field_line.hpp>
#include <concino/lines/integral_line.hpp>
#include <concino/lines/karcher_mean.hpp>
#include <concino/lines/line_end.hpp>
#include <concino/lines/starts_around.hpp>
#include <concino/lines/straighten.hpp>
#include <concino/lines/trace_geodesic.hpp>

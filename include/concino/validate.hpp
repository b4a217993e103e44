// Validation of meshes: defects and broken concept laws.
#pragma once

#include <concino/validate/broken_law.hpp>
#include <concino/validate/check_laws.hpp>
#include <concino/validate/defect.hpp>
#include <concino/validate/halfedge_links.hpp>
#include <concino/validate/validate.hpp>

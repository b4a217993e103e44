// Is this mesh what it claims to be? Everything of the module validate.
#pragma once

#include <concino/validate/check_laws.hpp>
#include <concino/validate/halfedge_links.hpp>
#include <concino/validate/validate.hpp>

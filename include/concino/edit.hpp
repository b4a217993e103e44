// Editing of meshes: adding and removing elements.
#pragma once

#include <concino/edit/elements.hpp>
#include <concino/edit/remove_unreferenced.hpp>

// Editing of meshes: adding and removing elements, splitting and flipping edges, undoing edits.
#pragma once

#include <concino/edit/edge_flip.hpp>
#include <concino/edit/edge_split.hpp>
#include <concino/edit/elements.hpp>
#include <concino/edit/garbage_collect.hpp>
#include <concino/edit/remove_unreferenced.hpp>
#include <concino/edit/transaction.hpp>

// Editing of meshes: adding and removing elements, splitting, collapsing and flipping, undoing edits.
#pragma once

#include <concino/edit/connected_verts.hpp>
#include <concino/edit/edge_collapse.hpp>
#include <concino/edit/edge_flip.hpp>
#include <concino/edit/edge_split.hpp>
#include <concino/edit/elements.hpp>
#include <concino/edit/face_flip.hpp>
#include <concino/edit/face_split.hpp>
#include <concino/edit/flip_winding.hpp>
#include <concino/edit/garbage_collect.hpp>
#include <concino/edit/invariants.hpp>
#include <concino/edit/keep_labels.hpp>
#include <concino/edit/max_distance.hpp>
#include <concino/edit/merge_verts.hpp>
#include <concino/edit/permission.hpp>
#include <concino/edit/poly_split.hpp>
#include <concino/edit/proposed_edit.hpp>
#include <concino/edit/protect.hpp>
#include <concino/edit/remove_unreferenced.hpp>
#include <concino/edit/replace_polys.hpp>
#include <concino/edit/simplex_cavity.hpp>
#include <concino/edit/split_vert_fans.hpp>
#include <concino/edit/transaction.hpp>
#include <concino/edit/vert_split.hpp>

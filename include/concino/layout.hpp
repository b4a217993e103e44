// Quads and hexes as structures: chords and sheets, singularities, separatrices, blocks; collapsing and inserting.
#pragma once

#include <concino/layout/chords.hpp>
#include <concino/layout/coarse_layout.hpp>
#include <concino/layout/collapse_sheet.hpp>
#include <concino/layout/diagonal_collapse.hpp>
#include <concino/layout/insert_sheet.hpp>
#include <concino/layout/separatrices.hpp>
#include <concino/layout/sheets.hpp>
#include <concino/layout/singularities.hpp>

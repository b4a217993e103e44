// Quads and hexes as structures: chords and sheets, singularities, separatrices, blocks.
#pragma once

#include <concino/layout/chords.hpp>
#include <concino/layout/coarse_layout.hpp>
#include <concino/layout/separatrices.hpp>
#include <concino/layout/sheets.hpp>
#include <concino/layout/singularities.hpp>

// Several pictures as one, in rows and columns, with a line of text under each.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/image.hpp>

#include <span>
#include <string>
#include <vector>

namespace concino {

struct sheet_options {
  std::size_t columns = 0;                 // pictures in a row; 0: as many as make the sheet about square
  std::size_t gap = 16;                    // pixels between pictures and around the sheet
  std::vector<std::string> captions = {};  // under the pictures, in their order, in UTF-8; there may be fewer than
                                           // pictures
  std::string title = {};                  // above all pictures
  double size = 0;  // of the letters of captions in pixels, up to 65535; 0: 1/20 of the height of the highest picture,
                    // at least 10
  rgb color = srgb(0.1f, 0.1f, 0.12f);  // of letters
  rgb background = {1, 1, 1};           // between the pictures
};

/// Places pictures beside and below one another.
/// Needs:  at least one picture, each of at least one pixel; sizes may differ.
/// Result: a sheet in which every pixel of every picture occurs. Columns are as wide as their widest picture, rows as
///         high as their highest; smaller ones are in the middle of their cells. Captions are made smaller where they
///         would be wider than the column. If all pictures have opacities, the sheet has them, and nothing between the
///         pictures; else pictures with opacities are laid on the background.
/// Cost:   O(pixels of the sheet).
/// Errors: invalid_argument if there is no picture, one has no pixels, there are more captions than pictures, an option
///         is out of its range, or the sheet would have more than 65,535 pixels along an axis.
image make_sheet(std::span<const image> pictures, const sheet_options& options = {});

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/render/detail/image/sheet.ipp>
#endif

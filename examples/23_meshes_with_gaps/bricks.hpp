// A block of hexes in arrays, as a solver may store it: the eight corners of each hex run along x first, then along y, then along z.
#pragma once

#include <vector>

struct Bricks {
  std::vector<double> x, y, z;
  std::vector<int> corners;  // eight per brick

  Bricks(int nx, int ny, int nz) {
    for (int k = 0; k <= nz; ++k)
      for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) x.push_back(i), y.push_back(0.5 * j), z.push_back(2 * k);
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
          for (int c = 0; c < 8; ++c) corners.push_back(i + c % 2 + (nx + 1) * (j + c / 2 % 2 + (ny + 1) * (k + c / 4)));
  }
};

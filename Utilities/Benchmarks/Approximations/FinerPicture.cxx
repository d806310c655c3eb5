// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FinerPicture.h"

namespace approximations
{
reference::RgbaPicture MakeCoarser(const reference::RgbaPicture& fine)
{
  reference::RgbaPicture picture(fine.Width / Finer, fine.Height / Finer);
  for (int j = 0; j < fine.Height; ++j)
  {
    for (int i = 0; i < fine.Width; ++i)
    {
      for (int c = 0; c < 4; ++c)
      {
        picture.At(i / Finer, j / Finer)[c] += fine.At(i, j)[c] / (Finer * Finer);
      }
    }
  }
  return picture;
}
}

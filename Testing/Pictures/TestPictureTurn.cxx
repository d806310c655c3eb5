// SPDX-License-Identifier: BSD-3-Clause
// Second differences of turning pictures: none in an even motion, and the frame that stands out.
#include "Support/Pictures/PictureTurn.h"
#include "Support/Checks/ReferenceCheck.h"

#include <cmath>

int TestPictureTurn(int, char*[])
{
  using namespace reference;
  Check check;
  PictureTurn even;
  PictureTurn odd;
  for (int i = 0; i < 100; ++i)
  {
    RgbaPicture picture(2, 2);
    picture.At(0, 0)[0] = 0.01 * i;
    picture.At(1, 1)[1] = i % 2;
    even.Add(picture);
    picture.At(1, 0)[0] = i == 17 ? 0.5 : 0.0;
    odd.Add(picture);
  }
  check.Near(even.GetMean(), 0.01 * 49.5 / 4.0, 1e-12, "mean of red");
  check.Near(even.GetMeanBend().Largest, 0.0, 1e-12, "an even motion", 1.0);
  check.Near(even.GetChangeBend().Largest, 0.0, 1e-12, "even changes", 1.0);
  check.Near(odd.GetMeanBend().Largest, 0.125, 1e-12, "a picture that stands out");
  check.Equal(odd.GetMeanBend().At, 17, "its place");
  check.Near(odd.GetMeanBend().P95, 0.0, 1e-12, "all but three are even", 1.0);
  check.Equal(odd.GetMeanBend().Outliers, 3, "that picture and those beside it");
  check.Equal(even.GetMeanBend().Outliers, 0, "an even motion has no outlier");
  // From the picture before it and to the one after.
  check.Near(odd.GetChangeBend().Largest, 0.245, 1e-12, "a change that stands out");
  check.Near(odd.GetChangeBend().P95, 0.0, 1e-12, "all but four changes are even", 1.0);
  check.Equal(odd.GetChangeBend().Outliers, 2, "both changes, not those beside them");
  check.Equal(PictureTurn::Measure({ 1.0, 5.0 }, 0.1, 1.0).At, 0, "two numbers have no middle");
  // Second differences of 1 but for one, and half as much more beside it.
  const auto countOutliers = [](double one, double seen, double bound)
  {
    std::vector<double> numbers(100);
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      numbers[i] = i % 2 == 1 ? 1.0 : i == 50 ? 1.0 - one : 0.0;
    }
    return PictureTurn::Measure(numbers, seen, bound).Outliers;
  };
  check.Equal(countOutliers(2.9, 0.1, 10.0), 0, "less than three times what is usual");
  check.Equal(countOutliers(3.1, 0.1, 10.0), 1, "more than three times what is usual");
  check.Equal(countOutliers(3.1, 4.0, 10.0), 0, "what is not seen");
  check.Equal(countOutliers(1.0, 0.1, 0.5), 98, "above the bound");
  return check.Result();
}

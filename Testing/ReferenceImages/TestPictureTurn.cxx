// SPDX-License-Identifier: BSD-3-Clause
// Second differences of the images of a rotation: zero for uniform motion, large for one frame that
// differs.
#include "Support/Images/MotionOutliers.h"
#include "Support/Checks/ReferenceCheck.h"

#include <cmath>

int TestPictureTurn(int, char*[])
{
  using namespace reference;
  Check check;
  MotionOutliers even;
  MotionOutliers odd;
  for (int i = 0; i < 100; ++i)
  {
    RgbaImage image(2, 2);
    image.At(0, 0)[0] = 0.01 * i;
    image.At(1, 1)[1] = i % 2;
    even.Add(image);
    image.At(1, 0)[0] = i == 17 ? 0.5 : 0.0;
    odd.Add(image);
  }
  check.Near(even.GetMean(), 0.01 * 49.5 / 4.0, 1e-12, "mean of red");
  check.Near(even.GetSecondDifferencesOfMean().Largest, 0.0, 1e-12, "uniform motion", 1.0);
  check.Near(even.GetSecondDifferencesOfChange().Largest, 0.0, 1e-12, "uniform changes", 1.0);
  check.Near(odd.GetSecondDifferencesOfMean().Largest, 0.125, 1e-12, "one frame that differs");
  check.Equal(odd.GetSecondDifferencesOfMean().At, 17, "index of that frame");
  check.Near(
    odd.GetSecondDifferencesOfMean().P95, 0.0, 1e-12, "all frames except three are uniform", 1.0);
  check.Equal(
    odd.GetSecondDifferencesOfMean().Outliers, 3, "outliers: that frame and its neighbors");
  check.Equal(even.GetSecondDifferencesOfMean().Outliers, 0, "uniform motion has no outlier");
  // Both the change to the differing frame and the change back are outliers.
  check.Near(odd.GetSecondDifferencesOfChange().Largest, 0.245, 1e-12, "a change that differs");
  check.Near(
    odd.GetSecondDifferencesOfChange().P95, 0.0, 1e-12, "all changes except four are uniform", 1.0);
  check.Equal(odd.GetSecondDifferencesOfChange().Outliers, 2,
    "outliers: both changes, but not their neighbors");
  check.Equal(
    MotionOutliers::Measure({ 1.0, 5.0 }, 0.1, 1.0).At, 0, "two numbers have no second difference");
  // The second difference at index 50 is \a one, its two neighbors are (1 + \a one) / 2, and all
  // others are 1.
  const auto countOutliers = [](double one, double seen, double bound)
  {
    std::vector<double> numbers(100);
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      numbers[i] = i % 2 == 1 ? 1.0 : i == 50 ? 1.0 - one : 0.0;
    }
    return MotionOutliers::Measure(numbers, seen, bound).Outliers;
  };
  check.Equal(countOutliers(2.9, 0.1, 10.0), 0, "less than three times the usual value");
  check.Equal(countOutliers(3.1, 0.1, 10.0), 1, "more than three times the usual value");
  check.Equal(countOutliers(3.1, 4.0, 10.0), 0, "a second difference below the visible size");
  check.Equal(countOutliers(1.0, 0.1, 0.5), 98, "above the bound");
  return check.Result();
}

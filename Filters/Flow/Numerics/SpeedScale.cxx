// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/SpeedScale.h"

#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace interlume
{

namespace
{
// Added to binary exponents, so that even the exponents of subnormal numbers are valid bin indices.
constexpr int Offset = 1080;
// With fewer vectors than this, no fill values are detected.
constexpr vtkIdType MinimumNumber = 8;
// Minimum gap, in powers of 2, between fill values and the next lower speed, for fill values that
// are few, that repeat a component, or that are huge.
constexpr std::size_t GapOfFew = 10;
constexpr std::size_t GapOfRepeated = 3;
constexpr std::size_t GapOfHuge = 30;
// Minimum magnitude of the components of huge fill values.
constexpr double Huge = 1e10;

// Returns the component of a vector with the largest magnitude. Sets \a isRepeated to true if two
// components have this value and the third one has it too or is much smaller.
double FindLargest(const double vector[3], bool& isRepeated)
{
  double v[3] = { vector[0], vector[1], vector[2] };
  std::sort(v, v + 3, [](double a, double b) { return std::abs(a) > std::abs(b); });
  isRepeated = v[0] == v[1] && (v[2] == v[0] || std::abs(v[2]) < std::abs(v[0]) / 32.0);
  return v[0];
}

// Returns the beginning of a warning about the vectors at \a number points.
std::string DescribePoints(vtkIdType number, const char* array)
{
  return "The vectors" + (array ? std::string(" of array \"") + array + "\"" : "") + " at " +
    std::to_string(number) + " points ";
}

// Returns the end of a warning, which explains how to exclude the points. \a where is empty or a
// clause that tells where the points are.
std::string DescribeRemedy(const std::string& where)
{
  return " To exclude these points, set the HIDDENPOINT flag in the point array vtkGhostType" +
    where + ", or remove their cells, for example with vtkThreshold.";
}
}

std::string DescribeNonFinite(vtkIdType number, const char* array, const std::string& effect)
{
  return number == 0
    ? std::string()
    : DescribePoints(number, array) + "are NaN or infinite. " + effect + DescribeRemedy("");
}

std::string FillValues::Describe(const char* array, const std::string& effect) const
{
  std::ostringstream text;
  text << DescribePoints(this->Number, array) << "look like fill values: ";
  if (this->Value != 0.0)
  {
    text << "each has a component equal to " << this->Value << ", and ";
  }
  text << "their speeds (up to " << this->LargestSpeed << ") are far above all other speeds (up to "
       << this->Scale << "). " << effect;
  std::ostringstream where;
  if (this->Value != 0.0)
  {
    where << " wherever a component is " << this->Value;
  }
  return text.str() + DescribeRemedy(where.str());
}

void SpeedScale::Bin::Add(const Bin& other)
{
  this->Number += other.Number;
  this->Repeated += other.Repeated;
  this->Largest = std::max(this->Largest, other.Largest);
  this->Lower = std::min(this->Lower, other.Lower);
  this->Upper = std::max(this->Upper, other.Upper);
}

void SpeedScale::Add(const double vector[3])
{
  const double speed = Vectors::SafeLength({ vector[0], vector[1], vector[2] });
  if (speed > 0.0)
  {
    bool isRepeated = false;
    const double largest = FindLargest(vector, isRepeated);
    this->Bins[static_cast<std::size_t>(std::ilogb(speed) + Offset)].Add(
      { 1, isRepeated ? 1 : 0, speed, largest, largest });
  }
}

void SpeedScale::Add(const SpeedScale& other)
{
  for (std::size_t power = 0; power < Powers; ++power)
  {
    this->Bins[power].Add(other.Bins[power]);
  }
}

double SpeedScale::GetLargest() const
{
  double largest = 0.0;
  for (const Bin& bin : this->Bins)
  {
    largest = std::max(largest, bin.Largest);
  }
  return largest;
}

bool SpeedScale::AreFillValues(const Bin& top, vtkIdType above, vtkIdType number, std::size_t gap)
{
  if (gap > GapOfFew && above <= std::max<vtkIdType>(number / 100, 1))
  {
    return true;
  }
  const bool isRepeated =
    gap > GapOfRepeated && 2 * top.Repeated >= top.Number && 2 * above <= number;
  const bool isHuge = gap > GapOfHuge && std::abs(top.Lower) >= Huge &&
    number - above >= std::max(number / 100, MinimumNumber);
  return top.HasOneValue() && (isRepeated || isHuge);
}

FillValues SpeedScale::FindFillValues() const
{
  FillValues fill;
  fill.LargestSpeed = this->GetLargest();
  fill.Scale = fill.LargestSpeed;
  vtkIdType number = 0;
  for (const Bin& bin : this->Bins)
  {
    number += bin.Number;
  }
  if (number < MinimumNumber)
  {
    return fill;
  }
  // Vectors visited since the last gap, in descending order of speed. They may be fill values.
  Bin top;
  vtkIdType largestCount = 0;
  vtkIdType above = 0;
  std::size_t last = Powers;
  for (std::size_t power = Powers; power-- > 0;)
  {
    const Bin& bin = this->Bins[power];
    if (bin.Number == 0)
    {
      continue;
    }
    if (above > 0 && AreFillValues(top, above, number, last - power))
    {
      fill.Number = above;
      fill.Scale = bin.Largest;
      if (top.Number > largestCount)
      {
        largestCount = top.Number;
        fill.Value = top.HasOneValue() ? top.Lower : 0.0;
      }
      top = Bin();
    }
    top.Add(bin);
    above += bin.Number;
    last = power;
  }
  return fill;
}

void SpeedCount::Add(const double vector[3])
{
  if (Vectors::IsFinite({ vector[0], vector[1], vector[2] }))
  {
    this->Speeds.Add(vector);
  }
  else
  {
    ++this->NonFinite;
  }
}

void SpeedCount::Add(const SpeedCount& other)
{
  this->Speeds.Add(other.Speeds);
  this->NonFinite += other.NonFinite;
}

}

// SPDX-License-Identifier: BSD-3-Clause
// Projection of a 4-simplex to space and its split into tetrahedra, compared with exact arithmetic:
// class, number of tetrahedra, hypervolume, and duration at points of space.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExact.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceSpaceTime.h"

#include "Common/SimdDispatch.h"
#include "TimeVarying/SimplexProjection.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <numeric>
#include <random>

namespace
{

using namespace reference;

using Real = long double;
using Point = interlume::SimplexProjection::Point;
using Points = std::array<Point, 5>;
using Position = std::array<Real, 3>;

constexpr int NumberOfClasses = 6;
const char* const ClassNames[NumberOfClasses] = { "1", "2", "3a", "3b", "4", "5" };
constexpr int TetrahedraOfClass[NumberOfClasses] = { 6, 4, 4, 3, 2, 1 };

/// Returns a point with multiples of 2^-10 in [0,1) as coordinates, so that Mean() is exact.
Point RandomPoint(std::mt19937& random)
{
  Point p;
  for (double& x : p)
  {
    x = std::ldexp(static_cast<double>(random() % 1024), -10);
  }
  return p;
}

/// Returns the weighted mean of points, with a random time. The weights are given in quarters.
Point Mean(const std::vector<std::pair<Point, int>>& parts, std::mt19937& random)
{
  Point mean = RandomPoint(random);
  for (int a = 0; a < 3; ++a)
  {
    mean[a] = 0;
    for (const auto& [point, quarters] : parts)
    {
      mean[a] += 0.25 * quarters * point[a];
    }
  }
  return mean;
}

/// Returns the points of a 4-simplex that is in class \a index by construction.
Points MakeClass(int index, std::mt19937& random)
{
  Points p;
  std::generate(p.begin(), p.end(), [&] { return RandomPoint(random); });
  switch (index)
  {
    case 0: // a segment through a triangle
    {
      const Point cross = Mean({ { p[0], 1 }, { p[1], 1 }, { p[2], 2 } }, random);
      p[4] = Mean({ { cross, 6 }, { p[3], -2 } }, random);
      break;
    }
    case 1:
      p[4] = Mean({ { p[0], 1 }, { p[1], 1 }, { p[2], 1 }, { p[3], 1 } }, random);
      break;
    case 2: // two segments that cross at their midpoints
      p[3] = Mean({ { p[0], 4 }, { p[1], 4 }, { p[2], -4 } }, random);
      break;
    case 3:
      p[3] = Mean({ { p[0], 1 }, { p[1], 1 }, { p[2], 2 } }, random);
      break;
    case 4:
      p[2] = Mean({ { p[0], 1 }, { p[1], 3 } }, random);
      break;
    default:
      p[1] = Mean({ { p[0], 4 } }, random);
      break;
  }
  std::shuffle(p.begin(), p.end(), random);
  return p;
}

/// Returns the exact lambda_i: (-1)^i times the determinant of the points without point i.
std::array<Exact, 5> Dependency(const Points& p)
{
  std::array<Exact, 5> lambda;
  for (int i = 0; i < 5; ++i)
  {
    std::array<ExactPoint, 4> others;
    for (int k = 0, n = 0; k < 5; ++k)
    {
      if (k != i)
      {
        others[n++] = { p[k][0], p[k][1], p[k][2] };
      }
    }
    const Exact determinant = ExactDeterminant(others);
    lambda[i] = i % 2 == 0 ? determinant : Exact(0) - determinant;
  }
  return lambda;
}

/// Exact properties of a 4-simplex.
struct ExactProperties
{
  std::array<Real, 5> Lambda{};
  std::array<int, 5> Signs{};
  Real Hypervolume = 0; ///< signed
  Real Moment = 0;      ///< sum of lambda_i t_i: 24 times the hypervolume
  Real Length = 0;      ///< sum of the positive lambda_i: six times the volume in space
  Real Thickness = 0;
};

ExactProperties MakeTruth(const Points& p)
{
  ExactProperties exact;
  const std::array<Exact, 5> lambda = Dependency(p);
  Exact moment;
  Exact length;
  for (int i = 0; i < 5; ++i)
  {
    exact.Lambda[i] = lambda[i].Round();
    exact.Signs[i] = lambda[i].Sign();
    length = exact.Signs[i] > 0 ? length + lambda[i] : length;
    moment = moment + lambda[i] * p[i][3];
  }
  exact.Moment = moment.Round();
  exact.Length = length.Round();
  exact.Thickness = exact.Length > 0 ? std::abs(exact.Moment) / exact.Length : 0;
  // The determinant of four edges, expanded along the column of times, is the moment.
  exact.Hypervolume = exact.Moment / 24;
  return exact;
}

int ClassOf(const std::array<int, 5>& signs)
{
  const auto count = [&](int sign)
  { return static_cast<int>(std::count(signs.begin(), signs.end(), sign)); };
  const std::pair<int, int> sides = std::minmax(count(1), count(-1));
  const std::pair<int, int> classes[NumberOfClasses] = { { 2, 3 }, { 1, 4 }, { 2, 2 }, { 1, 3 },
    { 1, 2 }, { 1, 1 } };
  return static_cast<int>(std::find(classes, classes + NumberOfClasses, sides) - classes);
}

Position PositionOf(const Point& p)
{
  return { p[0], p[1], p[2] };
}

/// Returns the tetrahedra of a projection. The last point of each is the thick point.
std::vector<std::array<Position, 4>> TetrahedraOf(
  const interlume::SimplexProjection& projection, const Points& p)
{
  double thick[3];
  projection.GetThickPoint(p, thick);
  std::vector<std::array<Position, 4>> tetrahedra;
  projection.GetSigns().ForEachTetrahedron(
    [&](int a, int b, int c)
    {
      tetrahedra.push_back(
        { PositionOf(p[a]), PositionOf(p[b]), PositionOf(p[c]), { thick[0], thick[1], thick[2] } });
    });
  return tetrahedra;
}

/// Returns how long the 4-simplex contains the position \a x. On the line through \a x along the
/// time axis, the barycentric coordinates are b + s lambda, where s is a parameter. They are
/// nonnegative inside the 4-simplex. Per unit of s, time changes by the moment.
Real ExactDuration(const ExactProperties& exact, const Points& p, const Position& x)
{
  // b are the barycentric coordinates in the tetrahedron that omits the point with the largest
  // absolute value of lambda.
  int largest = 0;
  for (int i = 1; i < 5; ++i)
  {
    largest = std::abs(exact.Lambda[i]) > std::abs(exact.Lambda[largest]) ? i : largest;
  }
  std::array<int, 4> corners;
  for (int i = 0, n = 0; i < 5; ++i)
  {
    if (i != largest)
    {
      corners[n++] = i;
    }
  }
  std::array<Position, 4> positions;
  std::transform(
    corners.begin(), corners.end(), positions.begin(), [&](int i) { return PositionOf(p[i]); });
  const Real whole = Determinant(positions[0], positions[1], positions[2], positions[3]);
  std::array<Real, 5> b{};
  for (int n = 0; n < 4; ++n)
  {
    auto replaced = positions;
    replaced[n] = x;
    b[corners[n]] = Determinant(replaced[0], replaced[1], replaced[2], replaced[3]) / whole;
  }
  Real from = -1 / Real(0);
  Real to = 1 / Real(0);
  for (int i = 0; i < 5; ++i)
  {
    if (exact.Signs[i] == 0)
    {
      from = b[i] < 0 ? to : from;
      continue;
    }
    Real& end = exact.Signs[i] > 0 ? from : to;
    const Real s = -b[i] / exact.Lambda[i];
    end = exact.Signs[i] > 0 ? std::max(end, s) : std::min(end, s);
  }
  return std::max(to - from, Real(0)) * std::abs(exact.Moment);
}

Real FoundDuration(
  const std::vector<std::array<Position, 4>>& tetrahedra, double thickness, const Position& x)
{
  Real sum = 0;
  for (const auto& corners : tetrahedra)
  {
    const Real whole = Determinant(corners[0], corners[1], corners[2], corners[3]);
    std::array<Real, 4> weights;
    for (int n = 0; n < 4; ++n)
    {
      auto replaced = corners;
      replaced[n] = x;
      weights[n] = Determinant(replaced[0], replaced[1], replaced[2], replaced[3]) / whole;
    }
    sum += *std::min_element(weights.begin(), weights.end()) >= 0 ? weights[3] * thickness : 0;
  }
  return sum;
}

/// Size of a 4-simplex: extent in space, extent in time, and largest absolute coordinate.
struct Size
{
  Real Space = 0;
  Real Time = 0;
  Real Offset = 0;
};

Size SizeOf(const Points& p)
{
  Size size;
  for (const Point& a : p)
  {
    for (const Point& b : p)
    {
      for (int i = 0; i < 3; ++i)
      {
        size.Space = std::max<Real>(size.Space, std::abs(a[i] - b[i]));
        size.Offset = std::max<Real>(size.Offset, std::abs(a[i]));
      }
      size.Time = std::max<Real>(size.Time, std::abs(a[3] - b[3]));
    }
  }
  return size;
}

/// Maximum errors, for the printed summary.
struct Errors
{
  Real Hypervolume = 0;
  Real Thickness = 0;
  Real Duration = 0;
  long long Count = 0;
};

/// Checks properties that hold for every 4-simplex, even if its class is ambiguous. The hypervolume
/// may have a relative error plus errors due to rounding the thick point's coordinates and due to
/// cancellation in a weighted sum of times.
void CheckMeasures(const Points& p, Errors& errors, Check& check)
{
  const ExactProperties exact = MakeTruth(p);
  const Size size = SizeOf(p);
  const interlume::SimplexProjection projection(p, 0);
  const auto tetrahedra =
    projection.IsFlat() ? std::vector<std::array<Position, 4>>() : TetrahedraOf(projection, p);
  Real sum = 0;
  long long turned = 0;
  const Real rounding = std::ldexp(Real(1), -51) * size.Offset * size.Space * size.Space;
  for (const auto& corners : tetrahedra)
  {
    const Real volume = Determinant(corners[0], corners[1], corners[2], corners[3]) / 6;
    sum += volume * projection.GetThickness() / 4;
    turned += volume * (projection.IsInverted() ? -1 : 1) < -rounding ? 1 : 0;
  }
  check.Equal(turned, 0, "tetrahedra inverted relative to their 4-simplex");
  const Real rounded = std::ldexp(Real(1), -52) * exact.Length / 6 * size.Time;
  const Real bound =
    1e-12L * std::abs(exact.Hypervolume) + rounding * projection.GetThickness() + rounded;
  const Real error = std::abs(sum - exact.Hypervolume);
  if (!check.Near(static_cast<double>(error / bound), 0, 1,
        "error of the hypervolume relative to the bound", 1))
  {
    return;
  }
  errors.Hypervolume = std::max(errors.Hypervolume, error / bound);
  ++errors.Count;
}

/// Checks properties of 4-simplices whose class is unambiguous.
void CheckClass(
  const Points& p, int index, unsigned flat, Errors& errors, std::mt19937& random, Check& check)
{
  const ExactProperties exact = MakeTruth(p);
  const interlume::SimplexProjection projection(p, flat);
  if (!check.That(!projection.IsFlat(), "volume and thickness are positive"))
  {
    return;
  }
  const Size size = SizeOf(p);
  check.Equal(projection.GetClass(), index, "class");
  const auto tetrahedra = TetrahedraOf(projection, p);
  check.Equal(projection.GetNumberOfTetrahedra(), TetrahedraOfClass[index], "tetrahedra reported");
  check.Equal(
    static_cast<long long>(tetrahedra.size()), TetrahedraOfClass[index], "tetrahedra created");
  check.That(projection.IsInverted() == (exact.Moment < 0), "orientation");
  check.Near(projection.GetThickness(), static_cast<double>(exact.Thickness), 1e-14, "thickness",
    static_cast<double>(size.Time));
  errors.Thickness = std::max(
    errors.Thickness, std::abs(projection.GetThickness() - exact.Thickness) / exact.Thickness);
  // The weights yield the mean time of the thick point, halfway between the times at which it
  // enters and leaves the 4-simplex.
  Real mean = 0;
  for (int i = 0; i < 5; ++i)
  {
    const int sign = projection.GetSigns().Get(i);
    check.Equal(sign * sign, exact.Signs[i] != 0, "points with a weight");
    mean += projection.GetWeights()[i] * p[i][3];
  }
  Real expected = 0;
  for (int i = 0; i < 5; ++i)
  {
    expected += std::abs(exact.Lambda[i]) / exact.Length / 2 * p[i][3];
  }
  check.Near(static_cast<double>(mean), static_cast<double>(expected), 1e-13, "mean time", 1);
  std::uniform_real_distribution<double> fraction(0.0, 1.0);
  for (int sample = 0; sample < 4; ++sample)
  {
    std::array<Real, 5> weights;
    std::generate(weights.begin(), weights.end(), [&] { return -std::log(fraction(random)); });
    const Real total = std::accumulate(weights.begin(), weights.end(), Real(0));
    Position x{};
    for (int i = 0; i < 5; ++i)
    {
      for (int a = 0; a < 3; ++a)
      {
        x[a] += weights[i] / total * p[i][a];
      }
    }
    const Real known = ExactDuration(exact, p, x);
    const Real found = FoundDuration(tetrahedra, projection.GetThickness(), x);
    errors.Duration = std::max(errors.Duration, std::abs(known - found) / exact.Thickness);
    check.Near(static_cast<double>(found), static_cast<double>(known), 1e-9, "duration at a point",
      static_cast<double>(exact.Thickness));
  }
}

/// Returns whether \a p clearly belongs to class \a index: neither the thickness nor any nonzero
/// lambda_i is close to 0.
bool IsClear(const Points& p, int index)
{
  const ExactProperties exact = MakeTruth(p);
  Real smallest = exact.Length;
  for (Real lambda : exact.Lambda)
  {
    smallest = lambda == 0 ? smallest : std::min(smallest, std::abs(lambda));
  }
  return ClassOf(exact.Signs) == index && smallest > 1e-3L && exact.Thickness > 1e-3L;
}

Points Scaled(Points p, double space, double time, double offset)
{
  for (Point& point : p)
  {
    for (int a = 0; a < 3; ++a)
    {
      point[a] = point[a] * space + offset;
    }
    point[3] *= time;
  }
  return p;
}

unsigned FlatBits(const Points& p)
{
  const ExactProperties exact = MakeTruth(p);
  unsigned flat = 0;
  for (unsigned i = 0; i < 5; ++i)
  {
    flat |= exact.Signs[i] == 0 ? 1U << i : 0U;
  }
  return flat;
}

void CheckConstructed(int index, Check& check)
{
  std::mt19937 random(100 + index);
  Errors errors;
  for (int round = 0; round < 300; ++round)
  {
    Points p = MakeClass(index, random);
    if (!IsClear(p, index))
    {
      continue;
    }
    check.SetContext("class " + std::string(ClassNames[index]) + ", " + std::to_string(round));
    CheckClass(p, index, 0, errors, random, check);
    CheckClass(p, index, FlatBits(p), errors, random, check);
    CheckMeasures(p, errors, check);
    for (int exponent : { -30, 30 })
    {
      check.SetContext("class " + std::string(ClassNames[index]) + ", " + std::to_string(round) +
        ", space by 2^" + std::to_string(exponent));
      const double scale = std::ldexp(1, exponent);
      for (double time : { 1 / scale, 1.0, scale })
      {
        const Points scaled = Scaled(p, scale, time, 0);
        check.Equal(interlume::SimplexProjection(scaled, 0).GetClass(), index, "class");
        CheckMeasures(scaled, errors, check);
      }
    }
    check.SetContext("class " + std::string(ClassNames[index]) + ", " + std::to_string(round) +
      ", far from the origin");
    const Points far = Scaled(p, 1, 1, 1048576);
    check.Equal(interlume::SimplexProjection(far, 0).GetClass(), index, "class");
    CheckMeasures(far, errors, check);
  }
  check.That(errors.Count > 300, "enough 4-simplices of the class");
  std::cout << "class " << ClassNames[index] << ": " << errors.Count
            << " simplices, error of the hypervolume " << errors.Hypervolume
            << " of the bound, of the thickness " << errors.Thickness << ", of durations "
            << errors.Duration << '\n';
}

/// Moves one point by distances down to 1e-17, which make the class ambiguous.
void CheckPerturbed(int index, Check& check)
{
  std::mt19937 random(200 + index);
  std::uniform_real_distribution<double> amount(-1.0, 1.0);
  Errors errors;
  for (int digits = 1; digits <= 17; ++digits)
  {
    check.SetContext(
      "class " + std::string(ClassNames[index]) + " moved by 1e-" + std::to_string(digits));
    for (int round = 0; round < 200; ++round)
    {
      Points p = MakeClass(index, random);
      Point& moved = p[random() % 5];
      for (double& x : moved)
      {
        x += amount(random) * std::pow(10.0, -digits);
      }
      CheckMeasures(p, errors, check);
      const double scale = std::pow(10.0, static_cast<int>(random() % 19) - 9);
      CheckMeasures(Scaled(p, scale, 1 / scale, 0), errors, check);
    }
  }
  std::cout << "class " << ClassNames[index] << " perturbed: " << errors.Count
            << " simplices, error of the hypervolume " << errors.Hypervolume << " of the bound\n";
}

/// Tests 4-simplices that have no volume in space, or whose thickness is zero except for rounding
/// errors.
void CheckDegenerate(Check& check)
{
  check.SetContext("flat");
  std::mt19937 random(5);
  for (int round = 0; round < 100; ++round)
  {
    Points p = MakeClass(0, random);
    Points plane = p;
    Points line = p;
    Points point = p;
    Points sheet = p;
    for (int i = 0; i < 5; ++i)
    {
      plane[i][2] = 0.5;
      line[i][1] = line[i][2] = 0.25;
      std::fill_n(point[i].begin(), 3, 0.75);
      // Time is a linear function of position.
      sheet[i][3] = 0.5 * sheet[i][0] + 0.25 * sheet[i][1] + 2;
    }
    for (const Points& flat : { plane, line, point })
    {
      check.That(
        interlume::SimplexProjection(flat, 0).IsFlat(), "no volume in space: no tetrahedra");
    }
    check.Near(
      interlume::SimplexProjection(sheet, 0).GetThickness(), 0, 1e-15, "no extent in time", 1);
  }
}

/// Returns whether two projections are bit-identical.
bool AreSame(const interlume::SimplexProjection& a, const interlume::SimplexProjection& b)
{
  bool same = a.GetWeights() == b.GetWeights() && a.GetThickness() == b.GetThickness() &&
    a.IsInverted() == b.IsInverted();
  for (int i = 0; i < 5; ++i)
  {
    same = same && a.GetSigns().Get(i) == b.GetSigns().Get(i);
  }
  return same;
}

/// Projects several 4-simplices at once and compares the results with those of single projections.
/// Includes simple cases, cases that require extended precision, and degenerate cases.
void CheckSeveral(Check& check)
{
  check.SetContext("several at once");
  std::mt19937 random(7);
  std::uniform_real_distribution<double> amount(-1.0, 1.0);
  std::array<long long, 3> found{};
  for (int round = 0; round < 2000; ++round)
  {
    const int number = 1 + static_cast<int>(random() % 11);
    std::vector<Points> several(number);
    std::vector<std::uint8_t> flats(number);
    for (int s = 0; s < number; ++s)
    {
      Points& p = several[s];
      p = MakeClass(static_cast<int>(random() % NumberOfClasses), random);
      flats[s] = static_cast<std::uint8_t>(random() % 2 == 0 ? FlatBits(p) : 0);
      const double digits = -17.0 * (0.5 + 0.5 * amount(random));
      p[random() % 5][random() % 4] += amount(random) * std::pow(10.0, digits);
      if (random() % 8 == 0)
      {
        std::for_each(p.begin(), p.end(), [](Point& point) { point[2] = 0.5; });
      }
      p = Scaled(p, std::ldexp(1.0, static_cast<int>(random() % 5) * 20 - 40), 1.0, 0.0);
    }
    std::vector<interlume::SimplexProjection> quick(number);
    std::vector<interlume::SimplexProjection> plain(number);
    interlume::SimplexProjection::Project(several.data(), flats.data(), number, quick.data());
    interlume::SimdDispatch::UseAvx2(false);
    interlume::SimplexProjection::Project(several.data(), flats.data(), number, plain.data());
    interlume::SimdDispatch::UseAvx2(true);
    for (int s = 0; s < number; ++s)
    {
      const interlume::SimplexProjection alone(several[s], flats[s]);
      check.That(AreSame(quick[s], alone), "the result is bit-identical to a single projection");
      check.That(AreSame(plain[s], alone), "the result is bit-identical for all instruction sets");
      ++found[alone.IsFlat() ? 0 : alone.IsInverted() ? 1 : 2];
    }
  }
  check.That(*std::min_element(found.begin(), found.end()) > 500, "enough cases of each kind");
}

}

int TestTimeVaryingProjection(int, char*[])
{
  Check check;
  for (int index = 0; index < NumberOfClasses; ++index)
  {
    CheckConstructed(index, check);
    CheckPerturbed(index, check);
  }
  CheckDegenerate(check);
  CheckSeveral(check);
  return check.Result();
}

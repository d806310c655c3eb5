// SPDX-License-Identifier: BSD-3-Clause
// The order of boxes that planes part, along lines of sight that are cut with all of them; and
// which boxes planes do not part.
#include "Support/Checks/ReferenceCheck.h"

#include "Pieces/PieceOrder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{

using interlume::PieceOrder;
using reference::Check;
using Box = PieceOrder::Box;
using Vector = std::array<double, 3>;

constexpr Box NOTHING{ { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 } };

/// Cuts a box again and again at random places, so that planes part the parts.
std::vector<Box> CutBox(const Box& whole, int number, std::mt19937& random)
{
  std::vector<Box> boxes{ whole };
  std::uniform_real_distribution<double> share(0.2, 0.8);
  while (static_cast<int>(boxes.size()) < number)
  {
    const std::size_t which = random() % boxes.size();
    const std::size_t axis = random() % 3;
    Box upper = boxes[which];
    const double plane = upper[2 * axis] + share(random) * (upper[2 * axis + 1] - upper[2 * axis]);
    boxes[which][2 * axis + 1] = plane;
    upper[2 * axis] = plane;
    boxes.push_back(upper);
  }
  std::shuffle(boxes.begin(), boxes.end(), random);
  return boxes;
}

/// Returns the part of a ray in a box; the second is not above the first where it misses.
std::array<double, 2> Cut(const Box& box, const Vector& from, const Vector& along)
{
  std::array<double, 2> part{ { 0.0, std::numeric_limits<double>::max() } };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double a = (box[2 * axis] - from[axis]) / along[axis];
    const double b = (box[2 * axis + 1] - from[axis]) / along[axis];
    part = { { std::max(part[0], std::min(a, b)), std::min(part[1], std::max(a, b)) } };
  }
  return part;
}

/// Counts pairs of boxes on rays, of which the later in the order is before the other.
int CountWrong(const std::vector<Box>& boxes, const std::vector<int>& order, const Vector& from,
  const Vector& along, int& pairs)
{
  int wrong = 0;
  double reached = -std::numeric_limits<double>::max();
  for (const int box : order)
  {
    const std::array<double, 2> part = Cut(boxes[static_cast<std::size_t>(box)], from, along);
    const bool isFull = boxes[static_cast<std::size_t>(box)] != NOTHING;
    if (isFull && part[1] - part[0] > 1e-9)
    {
      pairs += reached > 0.0 ? 1 : 0;
      wrong += part[0] < reached - 1e-9 ? 1 : 0;
      reached = std::max(reached, part[1]);
    }
  }
  return wrong;
}

Vector RandomVector(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> number(-size, size);
  return { { number(random), number(random), number(random) } };
}

void CheckViews(Check& check, std::mt19937& random)
{
  const Box whole{ { -1.0, 1.0, -0.5, 2.0, -1.5, 0.5 } };
  int pairs = 0;
  for (int round = 0; round < 200; ++round)
  {
    const int number = 1 + static_cast<int>(random() % 24);
    std::vector<Box> boxes = CutBox(whole, number, random);
    // Pieces do not always fill their parts, and some processes have none.
    for (Box& box : boxes)
    {
      box[0] += random() % 2 ? 0.1 * (box[1] - box[0]) : 0.0;
      box = random() % 10 == 0 ? NOTHING : box;
    }
    const PieceOrder parts(boxes);
    check.SetContext("round " + std::to_string(round));
    check.That(parts.IsPossible(), "planes part what they cut");
    for (int view = 0; view < 20; ++view)
    {
      // Eyes inside the boxes, too.
      const Vector eye = RandomVector(random, 3.0);
      const bool isParallel = view % 2 == 1;
      const std::array<double, 4> from{ { eye[0], eye[1], eye[2], isParallel ? 0.0 : 1.0 } };
      const std::vector<int> order = parts.Compute(from);
      std::vector<int> sorted = order;
      std::sort(sorted.begin(), sorted.end());
      bool isWhole = sorted.size() == boxes.size();
      for (std::size_t i = 0; isWhole && i < sorted.size(); ++i)
      {
        isWhole = sorted[i] == static_cast<int>(i);
      }
      check.That(isWhole, "each process once");
      int wrong = 0;
      for (int ray = 0; ray < 50; ++ray)
      {
        const Vector target = RandomVector(random, 1.5);
        Vector start = eye;
        Vector along{ { target[0] - eye[0], target[1] - eye[1], target[2] - eye[2] } };
        if (isParallel)
        {
          along = { { -eye[0], -eye[1], -eye[2] } };
          start = { { target[0] - 10.0 * along[0], target[1] - 10.0 * along[1],
            target[2] - 10.0 * along[2] } };
        }
        wrong += CountWrong(boxes, order, start, along, pairs);
      }
      check.Equal(wrong, 0, "boxes in the wrong order");
    }
  }
  check.SetContext("");
  check.That(pairs > 100000, "rays pass through several boxes");
}

void CheckAlignedEyes(Check& check)
{
  const PieceOrder halves(
    { { { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 } }, { { 1.0, 2.0, 0.0, 1.0, 0.0, 1.0 } } });
  const auto first = [&](double x, double w) { return halves.Compute({ { x, 0.5, 0.5, w } })[0]; };
  check.Equal(first(-3.0, 1.0), 0, "from below");
  check.Equal(first(0.99, 1.0), 0, "from within the lower one");
  check.Equal(first(1.01, 1.0), 1, "from within the upper one");
  check.Equal(first(5.0, 1.0), 1, "from above");
  check.Equal(first(-1.0, 0.0), 0, "along the axis");
  check.Equal(first(1.0, 0.0), 1, "against the axis");
}

void CheckWhatCannotBeParted(Check& check)
{
  // Three bars, each before the next and the last before the first.
  const std::vector<Box> wheel{ { { 0.0, 3.0, 0.0, 1.0, 0.0, 1.0 } },
    { { 2.0, 3.0, 1.0, 3.0, 0.0, 3.0 } }, { { 0.0, 1.0, 0.5, 3.0, 1.0, 2.0 } },
    { { 0.5, 2.5, 0.0, 1.5, 2.0, 3.5 } } };
  check.That(
    !PieceOrder({ { { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 } }, { { 0.9, 2.0, 0.5, 1.5, 0.5, 1.5 } } })
       .IsPossible(),
    "boxes that overlap");
  const std::vector<Box> ring{ { { 0.0, 2.0, 0.0, 1.0, 0.0, 1.0 } },
    { { 2.0, 3.0, 0.0, 2.0, 0.0, 1.0 } }, { { 1.0, 3.0, 2.0, 3.0, 0.0, 1.0 } },
    { { 0.0, 1.0, 1.0, 3.0, 0.0, 1.0 } } };
  check.That(!PieceOrder(ring).IsPossible(), "four boxes around a fifth that is not there");
  check.That(PieceOrder({ ring[0], ring[1], ring[2] }).IsPossible(), "three of them");
  check.That(!PieceOrder(wheel).IsPossible(), "bars across each other");
  check.That(PieceOrder({}).IsPossible() && PieceOrder({}).Compute({}).empty(), "no process");
  check.That(PieceOrder({ NOTHING, NOTHING }).IsPossible(), "nothing anywhere");
  // What is cut in single precision does not fit to the last bit.
  const double third = static_cast<double>(1.0f / 3.0f);
  const std::vector<Box> touching{ { { 0.0, third + 1e-8, 0.0, 1.0, 0.0, 1.0 } },
    { { third - 1e-8, 1.0, 0.0, 1.0, 0.0, 1.0 } } };
  check.That(PieceOrder(touching).IsPossible(), "boxes that overlap by rounding");
  const std::vector<Box> flat{ { { 0.0, 1.0, 0.0, 1.0, 0.0, 0.0 } },
    { { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 } } };
  check.Equal(PieceOrder(flat).Compute({ { 0.5, 0.5, 5.0, 1.0 } })[0], 1, "a flat box behind");
  check.Equal(PieceOrder(flat).Compute({ { 0.5, 0.5, -5.0, 1.0 } })[0], 0, "a flat box before");
  check.That(PieceOrder({ flat[0], flat[0] }).IsPossible(), "two flat boxes in one place");
}

}

int TestPieceOrder(int, char*[])
{
  Check check;
  std::mt19937 random(7);
  CheckViews(check, random);
  CheckAlignedEyes(check);
  CheckWhatCannotBeParted(check);
  return check.Result();
}

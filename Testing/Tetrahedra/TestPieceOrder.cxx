// SPDX-License-Identifier: BSD-3-Clause
// Compares the order of boxes that planes can separate with view rays clipped to each box. Also
// tests that sets of boxes that planes cannot separate are detected.
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

/// Cuts a box repeatedly at random positions, so that planes separate the parts.
std::vector<Box> CutBox(const Box& full, int number, std::mt19937& random)
{
  std::vector<Box> boxes{ full };
  std::uniform_real_distribution<double> fraction(0.2, 0.8);
  while (static_cast<int>(boxes.size()) < number)
  {
    const std::size_t which = random() % boxes.size();
    const std::size_t axis = random() % 3;
    Box upper = boxes[which];
    const double plane =
      upper[2 * axis] + fraction(random) * (upper[2 * axis + 1] - upper[2 * axis]);
    boxes[which][2 * axis + 1] = plane;
    upper[2 * axis] = plane;
    boxes.push_back(upper);
  }
  std::shuffle(boxes.begin(), boxes.end(), random);
  return boxes;
}

/// Returns the parameter range of a ray inside a box. The range is empty if the ray misses the box.
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

/// Counts the boxes that the ray enters before it leaves a box that is earlier in \a order. Adds
/// the number of compared pairs to \a pairs.
int CountErrors(const std::vector<Box>& boxes, const std::vector<int>& order, const Vector& from,
  const Vector& along, int& pairs)
{
  int errors = 0;
  double reached = -std::numeric_limits<double>::max();
  for (const int box : order)
  {
    const std::array<double, 2> part = Cut(boxes[static_cast<std::size_t>(box)], from, along);
    const bool isFull = boxes[static_cast<std::size_t>(box)] != NOTHING;
    if (isFull && part[1] - part[0] > 1e-9)
    {
      pairs += reached > 0.0 ? 1 : 0;
      errors += part[0] < reached - 1e-9 ? 1 : 0;
      reached = std::max(reached, part[1]);
    }
  }
  return errors;
}

Vector RandomVector(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> number(-size, size);
  return { { number(random), number(random), number(random) } };
}

void CheckViews(Check& check, std::mt19937& random)
{
  const Box full{ { -1.0, 1.0, -0.5, 2.0, -1.5, 0.5 } };
  int pairs = 0;
  for (int round = 0; round < 200; ++round)
  {
    const int number = 1 + static_cast<int>(random() % 24);
    std::vector<Box> boxes = CutBox(full, number, random);
    // Pieces do not always fill their regions, and some processes have no piece.
    for (Box& box : boxes)
    {
      box[0] += random() % 2 ? 0.1 * (box[1] - box[0]) : 0.0;
      box = random() % 10 == 0 ? NOTHING : box;
    }
    const PieceOrder parts(boxes);
    check.SetContext("round " + std::to_string(round));
    check.That(parts.IsPossible(), "planes separate the boxes that they cut");
    for (int view = 0; view < 20; ++view)
    {
      // The camera may be inside a box.
      const Vector eye = RandomVector(random, 3.0);
      const bool isParallel = view % 2 == 1;
      const std::array<double, 4> from{ { eye[0], eye[1], eye[2], isParallel ? 0.0 : 1.0 } };
      const std::vector<int> order = parts.Compute(from);
      std::vector<int> sorted = order;
      std::sort(sorted.begin(), sorted.end());
      bool isComplete = sorted.size() == boxes.size();
      for (std::size_t i = 0; isComplete && i < sorted.size(); ++i)
      {
        isComplete = sorted[i] == static_cast<int>(i);
      }
      check.That(isComplete, "each process occurs once");
      int errors = 0;
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
        errors += CountErrors(boxes, order, start, along, pairs);
      }
      check.Equal(errors, 0, "boxes in the wrong order");
    }
  }
  check.SetContext("");
  check.That(pairs > 100000, "rays pass through several boxes");
}

void CheckAlignedCameras(Check& check)
{
  const PieceOrder halves(
    { { { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 } }, { { 1.0, 2.0, 0.0, 1.0, 0.0, 1.0 } } });
  const auto first = [&](double x, double w) { return halves.Compute({ { x, 0.5, 0.5, w } })[0]; };
  check.Equal(first(-3.0, 1.0), 0, "view from below");
  check.Equal(first(0.99, 1.0), 0, "camera inside the lower box");
  check.Equal(first(1.01, 1.0), 1, "camera inside the upper box");
  check.Equal(first(5.0, 1.0), 1, "view from above");
  check.Equal(first(-1.0, 0.0), 0, "parallel view along the axis");
  check.Equal(first(1.0, 0.0), 1, "parallel view against the axis");
}

void CheckInseparableBoxes(Check& check)
{
  // Bars that occlude each other cyclically.
  const std::vector<Box> wheel{ { { 0.0, 3.0, 0.0, 1.0, 0.0, 1.0 } },
    { { 2.0, 3.0, 1.0, 3.0, 0.0, 3.0 } }, { { 0.0, 1.0, 0.5, 3.0, 1.0, 2.0 } },
    { { 0.5, 2.5, 0.0, 1.5, 2.0, 3.5 } } };
  check.That(
    !PieceOrder({ { { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 } }, { { 0.9, 2.0, 0.5, 1.5, 0.5, 1.5 } } })
       .IsPossible(),
    "overlapping boxes cannot be ordered");
  const std::vector<Box> ring{ { { 0.0, 2.0, 0.0, 1.0, 0.0, 1.0 } },
    { { 2.0, 3.0, 0.0, 2.0, 0.0, 1.0 } }, { { 1.0, 3.0, 2.0, 3.0, 0.0, 1.0 } },
    { { 0.0, 1.0, 1.0, 3.0, 0.0, 1.0 } } };
  check.That(!PieceOrder(ring).IsPossible(), "four boxes around a hole cannot be ordered");
  check.That(
    PieceOrder({ ring[0], ring[1], ring[2] }).IsPossible(), "three of the boxes can be ordered");
  check.That(!PieceOrder(wheel).IsPossible(), "cyclic bars cannot be ordered");
  check.That(PieceOrder({}).IsPossible() && PieceOrder({}).Compute({}).empty(), "no process");
  check.That(PieceOrder({ NOTHING, NOTHING }).IsPossible(), "only empty processes");
  // Boxes that were computed in single precision may overlap slightly.
  const double third = static_cast<double>(1.0f / 3.0f);
  const std::vector<Box> touching{ { { 0.0, third + 1e-8, 0.0, 1.0, 0.0, 1.0 } },
    { { third - 1e-8, 1.0, 0.0, 1.0, 0.0, 1.0 } } };
  check.That(PieceOrder(touching).IsPossible(), "rounding overlaps are tolerated");
  const std::vector<Box> flat{ { { 0.0, 1.0, 0.0, 1.0, 0.0, 0.0 } },
    { { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 } } };
  check.Equal(
    PieceOrder(flat).Compute({ { 0.5, 0.5, 5.0, 1.0 } })[0], 1, "flat box behind the other");
  check.Equal(
    PieceOrder(flat).Compute({ { 0.5, 0.5, -5.0, 1.0 } })[0], 0, "flat box in front of the other");
  check.That(PieceOrder({ flat[0], flat[0] }).IsPossible(), "two identical flat boxes");
}

}

int TestPieceOrder(int, char*[])
{
  Check check;
  std::mt19937 random(7);
  CheckViews(check, random);
  CheckAlignedCameras(check);
  CheckInseparableBoxes(check);
  return check.Result();
}

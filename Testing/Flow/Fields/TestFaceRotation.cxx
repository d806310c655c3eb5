// SPDX-License-Identifier: BSD-3-Clause
// The canonical order of face points: it is the same for every start point and direction around a
// face, including repeated points, and links map corners to corners.
#include "Support/Checks/ReferenceCheck.h"

#include "Fields/FaceRotation.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{

using reference::Check;
using Face = std::vector<vtkIdType>;

std::vector<Face> GetTurns(const Face& face)
{
  std::vector<Face> turns;
  for (const bool isReversed : { false, true })
  {
    Face turned = face;
    if (isReversed)
    {
      std::reverse(turned.begin(), turned.end());
    }
    for (std::size_t start = 0; start < face.size(); ++start)
    {
      turns.push_back(turned);
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    }
  }
  return turns;
}

void CheckFace(Check& check, const Face& face, const std::string& name)
{
  const std::vector<Face> turns = GetTurns(face);
  const int corners = static_cast<int>(face.size());
  const Face wanted = *std::min_element(turns.begin(), turns.end());
  for (const Face& one : turns)
  {
    Face ordered(face.size());
    const interlume::FaceRotation from =
      interlume::FaceRotation::Order(one.data(), corners, ordered.data());
    check.That(ordered == wanted, name + ": the smallest order");
    for (const Face& other : turns)
    {
      const interlume::FaceRotation to =
        interlume::FaceRotation::Order(other.data(), corners, ordered.data());
      const interlume::FaceLinks::Link link = interlume::FaceRotation::GetLink(from, to, 7);
      check.Equal(link.Face, static_cast<vtkIdType>(7), name + ": the other face");
      for (int i = 0; i < corners; ++i)
      {
        const int corner = (link.Start + (link.IsReversed ? corners - i : i)) % corners;
        check.Equal(other[static_cast<std::size_t>(i)], one[static_cast<std::size_t>(corner)],
          name + ": a corner of the other face");
      }
    }
  }
}

}

int TestFaceRotation(int, char*[])
{
  Check check;
  CheckFace(check, { 3, 8, 5 }, "triangle");
  CheckFace(check, { 3, 8, 3 }, "triangle, a point twice");
  CheckFace(check, { 9, 4, 6, 1 }, "quadrilateral");
  CheckFace(check, { 5, 5, 7, 9 }, "collapsed at the smallest point");
  CheckFace(check, { 5, 7, 7, 9 }, "collapsed at another point");
  CheckFace(check, { 5, 7, 5, 9 }, "folded");
  CheckFace(check, { 5, 9, 7, 9 }, "folded at another point");
  CheckFace(check, { 5, 5, 7, 7 }, "a line");
  CheckFace(check, { 5, 5, 5, 5 }, "a point");
  return check.Result();
}

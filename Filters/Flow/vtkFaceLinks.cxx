#include "vtkFaceLinks.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace
{

// A face with its points in order, to be found among others.
struct Key
{
  std::array<vtkIdType, 4> Points;
  vtkIdType Face;
  bool operator<(const Key& other) const
  {
    return this->Points != other.Points ? this->Points < other.Points : this->Face < other.Face;
  }
};

bool FindTurn(const vtkIdType* from, const vtkIdType* to, int corners, vtkFaceLinks::Link& link)
{
  for (int start = 0; start < corners; ++start)
  {
    for (const bool isReversed : { true, false })
    {
      const int way = isReversed ? corners - 1 : 1;
      bool isSame = true;
      for (int i = 0; i < corners; ++i)
      {
        isSame = isSame && to[i] == from[(start + i * way) % corners];
      }
      if (isSame)
      {
        link.Start = start;
        link.IsReversed = isReversed;
        return true;
      }
    }
  }
  return false;
}

// Faces are gathered at the least of their points' ids, and compared there.
void Match(vtkIdType numberOfFaces, const vtkFaceLinks::FacePoints& getFace,
  vtkIdType numberOfPoints, const vtkFaceLinks::SetLink& setLink)
{
  std::vector<std::atomic<vtkIdType>> ends(numberOfPoints + 1);
  const auto forEachFace = [&](auto&& visit)
  {
    vtkSMPTools::For(0, numberOfFaces,
      [&](vtkIdType first, vtkIdType last)
      {
        vtkIdType points[4];
        for (vtkIdType face = first; face < last; ++face)
        {
          if (const int corners = getFace(face, points))
          {
            visit(face, *std::min_element(points, points + corners));
          }
        }
      });
  };
  forEachFace(
    [&](vtkIdType, vtkIdType point) { ends[point + 1].fetch_add(1, std::memory_order_relaxed); });
  for (vtkIdType point = 0; point < numberOfPoints; ++point)
  {
    ends[point + 1] += ends[point];
  }
  // Filling moves each point's begin to its end.
  std::vector<vtkIdType> faces(ends[numberOfPoints]);
  forEachFace([&](vtkIdType face, vtkIdType point)
    { faces[ends[point].fetch_add(1, std::memory_order_relaxed)] = face; });

  vtkSMPThreadLocal<std::vector<Key>> keysOfThreads;
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType firstPoint, vtkIdType lastPoint)
    {
      std::vector<Key>& keys = keysOfThreads.Local();
      for (vtkIdType point = firstPoint; point < lastPoint; ++point)
      {
        keys.clear();
        const vtkIdType begin = point > 0 ? ends[point - 1].load() : 0;
        for (vtkIdType i = begin; i < ends[point]; ++i)
        {
          Key key;
          key.Face = faces[i];
          key.Points.fill(-1);
          getFace(key.Face, key.Points.data());
          std::sort(key.Points.begin(), key.Points.end());
          keys.push_back(key);
        }
        std::sort(keys.begin(), keys.end());
        for (std::size_t i = 0; i < keys.size();)
        {
          std::size_t next = i + 1;
          while (next < keys.size() && keys[next].Points == keys[i].Points)
          {
            ++next;
          }
          if (next == i + 2)
          {
            vtkIdType a[4];
            vtkIdType b[4];
            const int corners = getFace(keys[i].Face, a);
            getFace(keys[i + 1].Face, b);
            vtkFaceLinks::Link link;
            link.Face = keys[i + 1].Face;
            if (FindTurn(a, b, corners, link))
            {
              setLink(keys[i].Face, link);
              link.Face = keys[i].Face;
              FindTurn(b, a, corners, link);
              setLink(keys[i + 1].Face, link);
            }
          }
          i = next;
        }
      }
    });
}

// Each point's first one at its coordinates, of the points of these faces.
bool FindCoincident(const std::vector<vtkIdType>& faces, const vtkFaceLinks::FacePoints& getFace,
  const vtkFlowValues& positions, std::vector<vtkIdType>& firsts)
{
  std::vector<vtkIdType> ids;
  vtkIdType points[4];
  for (const vtkIdType face : faces)
  {
    ids.insert(ids.end(), points, points + getFace(face, points));
  }
  vtkSMPTools::Sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  using Place = std::pair<std::array<double, 3>, vtkIdType>;
  std::vector<Place> places(ids.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(ids.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        positions.Get<3>(ids[i], places[i].first.data());
        places[i].second = ids[i];
      }
    });
  vtkSMPTools::Sort(places.begin(), places.end());
  const auto isSame = [](const Place& a, const Place& b) { return a.first == b.first; };
  if (std::adjacent_find(places.begin(), places.end(), isSame) == places.end())
  {
    return false;
  }
  firsts.resize(positions.GetNumber());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const bool isRepeated = i > 0 && isSame(places[i - 1], places[i]);
    firsts[places[i].second] = isRepeated ? firsts[places[i - 1].second] : places[i].second;
  }
  return true;
}

}

//------------------------------------------------------------------------------
void vtkFaceLinks::Find(vtkIdType numberOfFaces, const FacePoints& getFace,
  const vtkFlowValues& positions, const SetLink& setLink)
{
  std::vector<unsigned char> isLinked(numberOfFaces, 0);
  Match(numberOfFaces, getFace, positions.GetNumber(),
    [&](vtkIdType face, const Link& link)
    {
      isLinked[face] = 1;
      setLink(face, link);
    });
  std::vector<vtkIdType> single;
  vtkIdType points[4];
  for (vtkIdType face = 0; face < numberOfFaces; ++face)
  {
    if (!isLinked[face] && getFace(face, points) > 0)
    {
      single.push_back(face);
    }
  }
  std::vector<vtkIdType> firsts;
  if (!FindCoincident(single, getFace, positions, firsts))
  {
    return;
  }
  Match(
    static_cast<vtkIdType>(single.size()),
    [&](vtkIdType i, vtkIdType* ids)
    {
      const int corners = getFace(single[i], ids);
      std::transform(ids, ids + corners, ids, [&](vtkIdType id) { return firsts[id]; });
      return corners;
    },
    positions.GetNumber(),
    [&](vtkIdType i, const Link& link) {
      setLink(single[i], { single[link.Face], link.Start, link.IsReversed });
    });
}

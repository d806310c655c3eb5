// SPDX-License-Identifier: BSD-3-Clause
#include "Order/VisibilityOrder.h"

#include "Common/Prefetch.h"
#include "Order/CentroidOrder.h"
#include "Order/CycleOrder.h"
#include "Order/EyeSides.h"
#include "Order/FaceAdjacency.h"
#include "Order/GapRelations.h"
#include "Order/VisibilityGraph.h"

namespace interlume
{

class VisibilityOrder::Internals
{
public:
  FaceAdjacency Adjacency;
  EyeSides Sides;
  interlume::CentroidOrder CentroidOrder;
  GapRelations Gaps;

  std::vector<unsigned char> InFront;
  std::vector<std::uint32_t> Centroids;
  vtkIdType InCycles = 0;

  VisibilityGraph GetGraph() const;
  void Sort(std::vector<std::uint32_t>& frontToBack);
  std::size_t GetSearchBytes() const
  {
    return this->States.capacity() + this->Frames.capacity() * sizeof(Frame);
  }

private:
  struct Frame
  {
    std::uint32_t Tetrahedron;
    std::uint32_t Position;
  };
  enum States : unsigned char
  {
    NEW = 0,
    DONE = 1,
    // The tetrahedron waits for those in front of it.
    WAITING = 2
  };

  // Puts out a tetrahedron after all in front of it. Returns false where that led into a cycle.
  bool PutOut(const VisibilityGraph& graph, std::uint32_t tetrahedron,
    std::vector<std::uint32_t>& frontToBack);

  std::vector<unsigned char> States;
  std::vector<Frame> Frames;
};

VisibilityGraph VisibilityOrder::Internals::GetGraph() const
{
  VisibilityGraph graph;
  graph.InFront = this->InFront.data();
  graph.Twins = this->Adjacency.GetTwins().data();
  if (this->Gaps.GetNumberOfRelations() > 0)
  {
    graph.GapOffsets = this->Gaps.GetOffsets().data();
    graph.Gaps = this->Gaps.GetInFront().data();
  }
  return graph;
}

bool VisibilityOrder::Internals::PutOut(
  const VisibilityGraph& graph, std::uint32_t tetrahedron, std::vector<std::uint32_t>& frontToBack)
{
  this->Frames.clear();
  this->Frames.push_back({ tetrahedron, 0 });
  this->States[tetrahedron] = WAITING;
  while (!this->Frames.empty())
  {
    Frame& frame = this->Frames.back();
    const std::uint32_t next = graph.GetNext(frame.Tetrahedron, frame.Position);
    if (next == VisibilityGraph::None)
    {
      this->States[frame.Tetrahedron] = DONE;
      frontToBack.push_back(frame.Tetrahedron);
      this->Frames.pop_back();
    }
    else if (this->States[next] == NEW)
    {
      this->States[next] = WAITING;
      this->Frames.push_back({ next, 0 });
    }
    else if (this->States[next] == WAITING)
    {
      return false;
    }
  }
  return true;
}

void VisibilityOrder::Internals::Sort(std::vector<std::uint32_t>& frontToBack)
{
  const VisibilityGraph graph = this->GetGraph();
  this->InCycles = 0;
  this->States.assign(this->Centroids.size(), NEW);
  frontToBack.clear();
  frontToBack.reserve(this->Centroids.size());
  // The distance is far enough ahead for what is loaded to be there in time.
  constexpr std::size_t ahead = 24;
  for (std::size_t i = 0; i < this->Centroids.size(); ++i)
  {
    const std::uint32_t tetrahedron = this->Centroids[i];
    if (i + ahead < this->Centroids.size())
    {
      const std::size_t later = this->Centroids[i + ahead];
      Prefetch::Read(graph.Twins + 4 * later);
      Prefetch::Read(graph.InFront + later);
      Prefetch::Read(this->States.data() + later);
    }
    if (this->States[tetrahedron] == NEW && !this->PutOut(graph, tetrahedron, frontToBack))
    {
      // A tetrahedron that is put out is not in cycles, nor is anything before it that is not. The
      // rest takes the longer way.
      for (const Frame& frame : this->Frames)
      {
        this->States[frame.Tetrahedron] = NEW;
      }
      CycleOrder cycles;
      this->InCycles = cycles.Append(graph, this->Centroids, this->States, frontToBack);
      break;
    }
  }
}

VisibilityOrder::VisibilityOrder()
  : Internal(std::make_unique<Internals>())
{
}

VisibilityOrder::~VisibilityOrder() = default;

bool VisibilityOrder::Build(const TetrahedraMesh& mesh)
{
  if (!this->Internal->Adjacency.Build(mesh))
  {
    return false;
  }
  this->Internal->Sides.Build(mesh, this->Internal->Adjacency);
  return true;
}

void VisibilityOrder::Compute(
  const TetrahedraMesh& mesh, const ViewRays& rays, std::vector<std::uint32_t>& frontToBack)
{
  this->Internal->CentroidOrder.Compute(mesh, rays.Viewpoint, this->Internal->Centroids);
  this->Internal->Sides.Compute(mesh, rays.Viewpoint, this->Internal->InFront);
  this->Internal->Gaps.Compute(mesh, this->Internal->Sides, rays);
  this->Internal->Sort(frontToBack);
}

vtkIdType VisibilityOrder::GetNumberOfTetrahedraInCycles() const
{
  return this->Internal->InCycles;
}

vtkIdType VisibilityOrder::GetNumberOfGapRelations() const
{
  return this->Internal->Gaps.GetNumberOfRelations();
}

const FaceAdjacency& VisibilityOrder::GetAdjacency() const
{
  return this->Internal->Adjacency;
}

std::size_t VisibilityOrder::GetBytes() const
{
  const Internals& held = *this->Internal;
  return held.Adjacency.GetBytes() + held.Sides.GetBytes() + held.CentroidOrder.GetBytes() +
    held.Gaps.GetBytes() + held.InFront.capacity() +
    held.Centroids.capacity() * sizeof(std::uint32_t) + held.GetSearchBytes();
}

}

#include "vtkVisibilityOrder.h"

#include "vtkCentroidOrder.h"
#include "vtkCycleOrder.h"
#include "vtkEyeSides.h"
#include "vtkFaceAdjacency.h"
#include "vtkGapRelations.h"
#include "vtkVisibilityGraph.h"

namespace
{
// Has a line of the cache loaded that will be read soon.
void Prefetch(const void* memory)
{
#if defined(__GNUC__)
  __builtin_prefetch(memory);
#else
  static_cast<void>(memory);
#endif
}
}

class vtkVisibilityOrder::Internals
{
public:
  vtkFaceAdjacency Adjacency;
  vtkEyeSides Sides;
  vtkCentroidOrder CentroidOrder;
  vtkGapRelations Gaps;

  std::vector<unsigned char> InFront;
  std::vector<std::uint32_t> Centroids;
  vtkIdType InCycles = 0;

  vtkVisibilityGraph GetGraph() const;
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
    // Waits for those in front of it.
    WAITING = 2
  };

  // Puts out a tetrahedron after all in front of it; false where that led into a cycle.
  bool PutOut(const vtkVisibilityGraph& graph, std::uint32_t tetrahedron,
    std::vector<std::uint32_t>& frontToBack);

  std::vector<unsigned char> States;
  std::vector<Frame> Frames;
};

vtkVisibilityGraph vtkVisibilityOrder::Internals::GetGraph() const
{
  vtkVisibilityGraph graph;
  graph.InFront = this->InFront.data();
  graph.Twins = this->Adjacency.GetTwins().data();
  if (this->Gaps.GetNumberOfRelations() > 0)
  {
    graph.GapOffsets = this->Gaps.GetOffsets().data();
    graph.Gaps = this->Gaps.GetInFront().data();
  }
  return graph;
}

bool vtkVisibilityOrder::Internals::PutOut(const vtkVisibilityGraph& graph,
  std::uint32_t tetrahedron, std::vector<std::uint32_t>& frontToBack)
{
  this->Frames.clear();
  this->Frames.push_back({ tetrahedron, 0 });
  this->States[tetrahedron] = WAITING;
  while (!this->Frames.empty())
  {
    Frame& frame = this->Frames.back();
    const std::uint32_t next = graph.GetNext(frame.Tetrahedron, frame.Position);
    if (next == vtkVisibilityGraph::None)
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

void vtkVisibilityOrder::Internals::Sort(std::vector<std::uint32_t>& frontToBack)
{
  const vtkVisibilityGraph graph = this->GetGraph();
  this->InCycles = 0;
  this->States.assign(this->Centroids.size(), NEW);
  frontToBack.clear();
  frontToBack.reserve(this->Centroids.size());
  // Far enough ahead for what is loaded to be there in time.
  constexpr std::size_t ahead = 24;
  for (std::size_t i = 0; i < this->Centroids.size(); ++i)
  {
    const std::uint32_t tetrahedron = this->Centroids[i];
    if (i + ahead < this->Centroids.size())
    {
      const std::size_t later = this->Centroids[i + ahead];
      Prefetch(graph.Twins + 4 * later);
      Prefetch(graph.InFront + later);
      Prefetch(this->States.data() + later);
    }
    if (this->States[tetrahedron] == NEW && !this->PutOut(graph, tetrahedron, frontToBack))
    {
      // What is put out is not in cycles, nor is anything before it that is not. The rest takes the
      // longer way.
      for (const Frame& frame : this->Frames)
      {
        this->States[frame.Tetrahedron] = NEW;
      }
      vtkCycleOrder cycles;
      this->InCycles = cycles.Append(graph, this->Centroids, this->States, frontToBack);
      break;
    }
  }
}

vtkVisibilityOrder::vtkVisibilityOrder()
  : Internal(std::make_unique<Internals>())
{
}

vtkVisibilityOrder::~vtkVisibilityOrder() = default;

bool vtkVisibilityOrder::Build(const vtkTetrahedraMesh& mesh)
{
  if (!this->Internal->Adjacency.Build(mesh))
  {
    return false;
  }
  this->Internal->Sides.Build(mesh, this->Internal->Adjacency);
  return true;
}

void vtkVisibilityOrder::Compute(
  const vtkTetrahedraMesh& mesh, const vtkViewRays& rays, std::vector<std::uint32_t>& frontToBack)
{
  this->Internal->CentroidOrder.Compute(mesh, rays.Viewpoint, this->Internal->Centroids);
  this->Internal->Sides.Compute(mesh, rays.Viewpoint, this->Internal->InFront);
  this->Internal->Gaps.Compute(mesh, this->Internal->Sides, rays);
  this->Internal->Sort(frontToBack);
}

vtkIdType vtkVisibilityOrder::GetNumberOfTetrahedraInCycles() const
{
  return this->Internal->InCycles;
}

vtkIdType vtkVisibilityOrder::GetNumberOfGapRelations() const
{
  return this->Internal->Gaps.GetNumberOfRelations();
}

const vtkFaceAdjacency& vtkVisibilityOrder::GetAdjacency() const
{
  return this->Internal->Adjacency;
}

std::size_t vtkVisibilityOrder::GetBytes() const
{
  const Internals& held = *this->Internal;
  return held.Adjacency.GetBytes() + held.Sides.GetBytes() + held.CentroidOrder.GetBytes() +
    held.Gaps.GetBytes() + held.InFront.capacity() +
    held.Centroids.capacity() * sizeof(std::uint32_t) + held.GetSearchBytes();
}

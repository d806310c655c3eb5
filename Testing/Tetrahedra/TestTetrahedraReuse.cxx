// SPDX-License-Identifier: BSD-3-Clause
// Tests the orders and images that follow an abort after any stage, and the images of which only
// tiles are drawn again, against new ones.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Tetrahedra/ReferenceTetrahedra.h"

#include "Order/TetrahedraOrder.h"
#include "Software/SoftwareRasterizer.h"
#include "View/OpaqueSceneDepth.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <array>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace reference;
using interlume::SoftwareRasterizer;
using interlume::TetrahedraOrder;

/// A mesh with cell colors, seen by a camera.
struct Scene
{
  Scene()
  {
    CubeMeshSettings form;
    form.Cubes = 6;
    this->Mesh = MakeCubeMesh(form);
    this->Fields.Kind = interlume::TetrahedraFields::CELL_COLORS;
    this->Fields.Colors.assign(this->Mesh.GetNumberOfTetrahedra(), { { 0.3f, 0.2f, 0.1f, 0.4f } });
    this->Window->SetSize(300, 300);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->GetActiveCamera()->SetPosition(0.4, 0.3, 4.0);
  }

  /// Returns a frame for the camera turned by an angle.
  interlume::TetrahedraFrame GetFrame(double azimuth)
  {
    interlume::TetrahedraFrame frame;
    frame.Mesh = &this->Mesh;
    frame.Fields = &this->Fields;
    this->Renderer->GetActiveCamera()->Azimuth(azimuth);
    this->Error = frame.View.Set(this->Renderer, this->Volume, this->Mesh, 1);
    this->Renderer->GetActiveCamera()->Azimuth(-azimuth);
    return frame;
  }

  interlume::TetrahedraMesh Mesh;
  interlume::TetrahedraFields Fields;
  interlume::Error Error;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
};

/// Requests an abort at a call.
struct AbortAt
{
  int Last = -1;
  int Calls = 0;
  bool operator()(double = 0.0) { return this->Calls++ == this->Last; }
};

void CheckOrders(Check& check)
{
  Scene scene;
  const interlume::TetrahedraView before = scene.GetFrame(90.0).View;
  const interlume::TetrahedraView view = scene.GetFrame(0.0).View;
  check.That(!scene.Error, "the view is valid");
  for (const auto kind : { TetrahedraOrder::CENTROID, TetrahedraOrder::VISIBILITY })
  {
    const std::string name = kind == TetrahedraOrder::CENTROID ? "centroids" : "visibility";
    TetrahedraOrder expected;
    AbortAt never;
    check.That(expected.Compute(kind, scene.Mesh, view, std::ref(never)), name + ", complete");
    check.That(never.Calls > 0, name + " can be aborted");
    for (int call = 0; call < never.Calls; ++call)
    {
      const std::string stage = name + ", abort at call " + std::to_string(call);
      TetrahedraOrder order;
      check.That(order.Compute(kind, scene.Mesh, before), stage + ", another view");
      check.That(!order.Compute(kind, scene.Mesh, view, AbortAt{ call }), stage);
      check.That(!order.Get(), stage + ": no order");
      check.That(order.Compute(kind, scene.Mesh, view) && order.WasComputed() &&
          *order.Get() == *expected.Get(),
        stage + ", the next order");
    }
  }
}

void CheckImages(Check& check)
{
  Scene scene;
  const interlume::TetrahedraFrame before = scene.GetFrame(90.0);
  const interlume::TetrahedraFrame frame = scene.GetFrame(0.0);
  SoftwareRasterizer expected;
  AbortAt never;
  check.That(expected.Draw(frame, std::ref(never)), "complete");
  check.That(never.Calls > 4, "aborts before and between the tiles");
  for (int call = 0; call < never.Calls; ++call)
  {
    const std::string stage = "drawing, abort at call " + std::to_string(call);
    SoftwareRasterizer rasterizer;
    check.That(rasterizer.Draw(before), stage + ", another view");
    check.That(!rasterizer.Draw(frame, AbortAt{ call }), stage);
    check.That(rasterizer.Draw(frame) && rasterizer.GetColors() == expected.GetColors() &&
        rasterizer.GetNumberOfDrawnTetrahedra() == expected.GetNumberOfDrawnTetrahedra(),
      stage + ", the next image");
  }
}

/// Changes the depths of opaque surfaces at random, with other cameras and selections in between.
void CheckTiles(Check& check)
{
  Scene scene;
  const std::array<interlume::TetrahedraFrame, 2> frames{ { scene.GetFrame(0.0),
    scene.GetFrame(30.0) } };
  const std::size_t pixels = 300 * 300;
  std::mt19937 random(3);
  std::vector<float> depths(pixels, interlume::OpaqueSceneDepth::NONE);
  SoftwareRasterizer rasterizer;
  int partial = 0;
  for (int i = 0; i < 60; ++i)
  {
    interlume::TetrahedraFrame frame = frames[random() % 8 == 0 ? 1 : 0];
    const std::size_t changed = random() % pixels;
    // Depths are inverse distances, so the mesh has depths of about a quarter.
    depths[changed] = random() % 2 ? 0.25f : interlume::OpaqueSceneDepth::NONE;
    frame.Opaque = random() % 5 == 0 ? nullptr : depths.data();
    frame.IsSelection = random() % 6 == 0;
    SoftwareRasterizer expected;
    const std::string name = "image " + std::to_string(i);
    check.That(rasterizer.Draw(frame) && expected.Draw(frame), name + " is drawn");
    check.That(expected.WasComplete(), name + ": a new image is complete");
    partial += rasterizer.WasComplete() ? 0 : 1;
    if (frame.IsSelection)
    {
      const auto found = rasterizer.ReleaseSeen();
      const auto seen = expected.ReleaseSeen();
      check.That(std::equal(found.begin(), found.end(), seen.begin(), seen.end(),
                   [](const auto& a, const auto& b)
                   { return a.Tetrahedron == b.Tetrahedron && a.Depth == b.Depth; }),
        name + ": selection");
    }
    else
    {
      check.That(rasterizer.GetColors() == expected.GetColors(), name + ": colors");
    }
  }
  check.That(partial > 20, "only tiles are drawn: " + std::to_string(partial));
}
}

int TestTetrahedraReuse(int, char*[])
{
  return RunChecks({ CheckOrders, CheckImages, CheckTiles });
}

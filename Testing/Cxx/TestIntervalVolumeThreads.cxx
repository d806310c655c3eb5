// The same bytes for 1, 2 and 8 threads and every backend.
#include "ReferenceCheck.h"
#include "ReferenceExtraction.h"
#include "ReferenceField.h"
#include "ReferenceGrid.h"
#include "ReferenceLattice.h"
#include "ReferenceMesh.h"

#include "vtkImageData.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <iostream>

namespace
{

using namespace reference;

// ThreadSanitizer sees no locks of libraries that are not built with it.
#ifdef __SANITIZE_THREAD__
const std::vector<const char*> Backends = { "Sequential", "STDThread" };
#else
const std::vector<const char*> Backends = { "Sequential", "STDThread", "TBB", "OpenMP" };
#endif

struct Outputs
{
  Extraction Intervals;
  ContourExtraction Contours;
};

Outputs Extract(vtkDataSet* data)
{
  return { ExtractIntervals(data, { { 0.2, 0.4 }, { 0.4, 0.7 } }),
    ExtractContours(data, { 0.3, 0.8 }) };
}

void CheckForm(const LatticeForm& form, const std::vector<const char*>& backends, Check& check)
{
  vtkSMPTools::SetBackend("Sequential");
  vtkSMPTools::Initialize(1);
  const Outputs expected = Extract(form.Data);
  check.That(expected.Intervals.Volume->GetNumberOfCells() > 0, "there are tetrahedra");
  for (const char* backend : backends)
  {
    vtkSMPTools::SetBackend(backend);
    for (int threads : { 1, 2, 8 })
    {
      check.SetContext(form.Name + ", " + backend + ", " + std::to_string(threads) + " threads");
      vtkSMPTools::Initialize(threads);
      const Outputs found = Extract(form.Data);
      for (const std::string& difference :
        { FindDifference(found.Intervals.Volume, expected.Intervals.Volume),
          FindDifference(found.Intervals.Surface, expected.Intervals.Surface),
          FindDifference(found.Contours.Surface, expected.Contours.Surface) })
      {
        check.That(difference.empty(), difference);
      }
    }
  }
}

}

int TestIntervalVolumeThreads(int, char*[])
{
  Check check;
  std::vector<const char*> backends;
  for (const char* backend : Backends)
  {
    if (vtkSMPTools::SetBackend(backend))
    {
      std::cout << "backend " << backend << '\n';
      backends.push_back(backend);
    }
  }
  check.That(backends.size() >= 2, "there is a backend with threads");
  auto image = MakeImage({ 24, 20, 16 });
  AddRandomField(image, 5);
  for (const LatticeForm& form : FormsOf(image))
  {
    CheckForm(form, backends, check);
  }
  for (MeshKind kind : { MeshKind::Mixed, MeshKind::Kelvin })
  {
    auto mesh = MakeMesh(kind, { 10, 10, 10 });
    AddRandomField(mesh, 5);
    CheckForm({ GetName(kind), mesh }, backends, check);
  }
  return check.Result();
}

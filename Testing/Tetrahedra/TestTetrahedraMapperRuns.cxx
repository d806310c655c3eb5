// SPDX-License-Identifier: BSD-3-Clause
// Tests that the software path renders the same image with any number of threads, and stops when
// the window aborts rendering.
#include "Support/Drawing/DrawingAborts.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExecution.h"
#include "Tetrahedra/MapperImage.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <array>

int TestTetrahedraMapperRuns(int, char*[])
{
  using namespace reference;
  Check check;
  const ImageCase what =
    MakeCase(MakeCube(12), MakeRamp(0.1, 1.0, 2.0), { { 0.6, -1.0, 0.4 } }, false);
  const int software = vtkTimeWeightedTetrahedraMapper::SOFTWARE_PATH;
  CheckSame(
    "software path", [&]() { return DrawByPath(software, what).Values; }, check);

  check.SetContext("abort");
  vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
  Configure(mapper, what);
  mapper->SetRenderPath(software);
  const std::array<int, 2> size{ { 96, 96 } };
  VolumeStage stage(size);
  stage.SetVolume(mapper, what.Property);
  stage.SetCamera(what.Camera);
  CheckDrawingAborts(stage.GetWindow(), check);
  return check.Result();
}

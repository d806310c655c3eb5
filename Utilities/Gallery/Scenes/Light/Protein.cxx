// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Light/Protein.h"

#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageResample.h"
#include "vtkNew.h"
#include "vtkTransform.h"

namespace gallery
{
vtkSmartPointer<vtkSpatialObject> MakeProtein()
{
  vtkSmartPointer<vtkDataSet> data = interlume::ReadData("ironProt.vtk");
  // Cubic interpolation makes the surface smoother than linear interpolation.
  vtkNew<vtkImageResample> finer;
  finer->SetInputData(data);
  finer->SetInterpolationModeToCubic();
  finer->SetAxisMagnificationFactor(0, 2.0);
  finer->SetAxisMagnificationFactor(1, 2.0);
  finer->SetAxisMagnificationFactor(2, 2.0);
  finer->Update();

  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, 0.85, 0.62, 0.38);
  vtkSmartPointer<vtkSpatialImage> protein =
    MakeImageObject(finer->GetOutput(), 20.0, 140.0, colors);
  const double scale = 1.0 / 67.0;
  vtkNew<vtkTransform> transform;
  transform->Scale(scale, scale, scale);
  transform->Translate(-33.5, -33.5, -33.5);
  protein->SetTransform(transform);
  return protein;
}
}

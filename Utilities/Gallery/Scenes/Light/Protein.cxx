// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Light/Protein.h"

#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageGaussianSmooth.h"
#include "vtkImageReslice.h"
#include "vtkNew.h"
#include "vtkTransform.h"

namespace gallery
{
vtkSmartPointer<vtkSpatialObject> MakeProtein()
{
  vtkSmartPointer<vtkDataSet> data = interlume::ReadData("ironProt.vtk");
  // The values are 8-bit and saturated, with steps. The smoothing hides the steps, and rounds the
  // blobs that the boundary of the data cuts.
  vtkNew<vtkImageReslice> finer;
  finer->SetInputData(data);
  finer->SetInterpolationModeToCubic();
  finer->SetOutputScalarType(VTK_FLOAT);
  finer->SetOutputSpacing(0.5, 0.5, 0.5);
  finer->SetOutputExtent(-12, 146, -12, 146, -12, 146);
  finer->SetOutputOrigin(0.0, 0.0, 0.0);
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputConnection(finer->GetOutputPort());
  smooth->SetStandardDeviation(2.5);
  smooth->SetRadiusFactor(2.5);
  smooth->Update();

  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, 0.85, 0.62, 0.38);
  vtkSmartPointer<vtkSpatialImage> protein =
    MakeImageObject(smooth->GetOutput(), 20.0, 140.0, colors);
  const double scale = 1.0 / 67.0;
  vtkNew<vtkTransform> transform;
  transform->Scale(scale, scale, scale);
  transform->Translate(-33.5, -33.5, -33.5);
  protein->SetTransform(transform);
  return protein;
}
}

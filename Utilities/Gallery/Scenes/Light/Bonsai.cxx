// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Light/Bonsai.h"

#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkColorTransferFunction.h"
#include "vtkExtractVOI.h"
#include "vtkImageGaussianSmooth.h"
#include "vtkNew.h"
#include "vtkSpatialOperation.h"
#include "vtkTransform.h"

namespace gallery
{
namespace
{
/// Returns the part of the scan in the extent \a box, smoothed by a Gaussian with a standard
/// deviation of \a blur voxels.
vtkSmartPointer<vtkImageData> Cut(vtkDataSet* scan, const int box[6], double blur)
{
  vtkNew<vtkExtractVOI> part;
  part->SetInputData(scan);
  part->SetVOI(box[0], box[1], box[2], box[3], box[4], box[5]);
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputConnection(part->GetOutputPort());
  smooth->SetStandardDeviation(blur);
  smooth->Update();
  return smooth->GetOutput();
}
}

vtkSmartPointer<vtkSpatialObject> MakeBonsai()
{
  vtkSmartPointer<vtkDataSet> scan = interlume::ReadData("bonsai.vti");

  // Leaves are thin and have low values; the trunk has higher values.
  vtkNew<vtkColorTransferFunction> tree;
  tree->AddRGBPoint(20.0, 0.36, 0.52, 0.20);
  tree->AddRGBPoint(75.0, 0.47, 0.60, 0.26);
  tree->AddRGBPoint(110.0, 0.50, 0.36, 0.22);
  tree->AddRGBPoint(160.0, 0.58, 0.42, 0.27);
  const int crown[6] = { 24, 232, 60, 240, 0, 255 };
  // Below the branches, everything except the trunk is noise.
  vtkNew<vtkSpatialOperation> leaves;
  leaves->SetOperationToTrim();
  leaves->AddOperand(MakeImageObject(Cut(scan, crown, 0.7), 24.0, 40.0, tree));
  leaves->AddOperand(Unite({ MakeBox({ 0.0, 88.0, 0.0 }, { 255.0, 255.0, 255.0 }, PlasterColor()),
    MakeBox({ 96.0, 0.0, 100.0 }, { 150.0, 88.0, 160.0 }, PlasterColor()) }));

  vtkNew<vtkColorTransferFunction> clay;
  clay->AddRGBPoint(60.0, 0.40, 0.27, 0.18);
  clay->AddRGBPoint(175.0, 0.42, 0.28, 0.18);
  clay->AddRGBPoint(198.0, 0.72, 0.44, 0.31);
  const int bowl[6] = { 36, 206, 10, 60, 76, 255 };
  vtkSmartPointer<vtkSpatialObject> pot = MakeImageObject(Cut(scan, bowl, 2.0), 30.0, 110.0, clay);

  // In the scan, +y is up, and the pot is cut off at the maximum of z.
  vtkSmartPointer<vtkSpatialObject> bonsai =
    Unite({ pot, vtkSmartPointer<vtkSpatialObject>(leaves) });
  const double scale = 1.0 / 210.0;
  vtkNew<vtkTransform> transform;
  transform->Scale(scale, scale, scale);
  transform->RotateZ(180.0);
  transform->RotateX(90.0);
  transform->Translate(-124.0, -9.0, -128.0);
  bonsai->SetTransform(transform);
  return bonsai;
}

vtkSmartPointer<vtkImageData> SampleBonsai(int resolution)
{
  return Sample(
    MakeBonsai(), vtkBoundingBox(-0.68, 0.68, -0.68, 0.68, -0.03, 1.1), resolution, 0.5);
}
}

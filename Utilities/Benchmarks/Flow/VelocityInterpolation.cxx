// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/VelocityInterpolation.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStaticCellLocator.h"
#include "vtkVersion.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
#include "vtkCellLocatorStrategy.h"
#include "vtkCompositeInterpolatedVelocityField.h"
#include "vtkMultiBlockDataSet.h"
#else
#include "vtkCellLocatorInterpolatedVelocityField.h"
#include "vtkInterpolatedVelocityField.h"
#endif

namespace
{
using Interpolation = vtkSmartPointer<vtkCompositeInterpolatedVelocityField>;

Interpolation NewComposite(flow::CellSearch search)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  auto interpolation = Interpolation::New();
  if (search != flow::CellSearch::CLOSEST_POINT)
  {
    vtkNew<vtkCellLocatorStrategy> strategy;
    strategy->SetCellLocator(vtkNew<vtkStaticCellLocator>());
    interpolation->SetFindCellStrategy(strategy);
  }
  return interpolation;
#else
  if (search == flow::CellSearch::CLOSEST_POINT)
  {
    return vtkSmartPointer<vtkInterpolatedVelocityField>::New();
  }
  auto interpolation = vtkSmartPointer<vtkCellLocatorInterpolatedVelocityField>::New();
  interpolation->SetCellLocatorPrototype(vtkNew<vtkStaticCellLocator>());
  return interpolation;
#endif
}
}

vtkSmartPointer<vtkAbstractInterpolatedVelocityField> flow::NewInterpolator(CellSearch search)
{
  return NewComposite(search);
}

vtkSmartPointer<vtkAbstractInterpolatedVelocityField> flow::NewInterpolator(
  CellSearch search, vtkDataSet* field)
{
  const Interpolation interpolation = NewComposite(search);
  interpolation->SelectVectors(
    vtkDataObject::FIELD_ASSOCIATION_POINTS, field->GetPointData()->GetVectors()->GetName());
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, field);
  interpolation->Initialize(blocks);
#endif
  interpolation->AddDataSet(field);
  return interpolation;
}

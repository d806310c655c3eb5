// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetrahedralMesher.h"

#include "Common/ArrayCheck.h"
#include "Common/Error.h"
#include "Common/GridCheck.h"
#include "Common/NamedValue.h"
#include "Interpolation/MeshedArrays.h"
#include "Mesh/MeshMeasures.h"
#include "Meshers/Meshers.h"
#include "TetGen/MeshingJob.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <new>

vtkStandardNewMacro(vtkTetrahedralMesher);

namespace
{
constexpr double MinimumQualityBound = 1.0;
constexpr double MaximumQualityBound = 1000.0;

void Measure(interlume::MeshingJob& job)
{
  interlume::TetrahedralMesherReport& report = job.Report;
  interlume::MeshMeasures measures;
  // The bounds do not apply to decomposed cells.
  measures.QualityBound = job.Mesh.Cells.empty() ? job.QualityBound : 0.0;
  measures.MaximumVolume = job.Mesh.Cells.empty() ? job.MaximumVolume : 0.0;
  measures.Add(job.Mesh.Points, job.Mesh.Tetrahedra);
  report.Tetrahedra = static_cast<vtkIdType>(job.Mesh.Tetrahedra.size() / 4);
  report.TetrahedraAboveQualityBound = measures.AboveQualityBound;
  report.TetrahedraAboveMaximumVolume = measures.AboveMaximumVolume;
  report.LargestRadiusEdgeRatio = measures.LargestRadiusEdgeRatio;
  report.SmallestVolume = std::ldexp(measures.SmallestVolume, 3 * job.Mesh.UnitExponent);
  report.LargestVolume = std::ldexp(measures.LargestVolume, 3 * job.Mesh.UnitExponent);
}
}

vtkTetrahedralMesher::vtkTetrahedralMesher()
{
  interlume::TetrahedralMesherReport().CopyTo(this->Report);
  this->AddObserver(vtkCommand::StartEvent, this, &vtkTetrahedralMesher::BeginExecution);
  this->AddObserver(vtkCommand::EndEvent, this, &vtkTetrahedralMesher::WarnIfEmpty);
}

vtkTetrahedralMesher::~vtkTetrahedralMesher() = default;

void vtkTetrahedralMesher::SetQualityBound(double bound)
{
  bound = bound > 0.0 ? std::max(MinimumQualityBound, std::min(bound, MaximumQualityBound)) : 0.0;
  if (this->QualityBound != bound)
  {
    this->QualityBound = bound;
    this->Modified();
  }
}

int vtkTetrahedralMesher::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

int vtkTetrahedralMesher::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  interlume::TetrahedralMesherReport().CopyTo(this->Report);
  vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  this->SetProgressText("Generating tetrahedra");
  interlume::MeshingJob job(*this, input);
  double progress = 0.0;
  job.SetProgress = [this, &progress](double value)
  {
    progress = value;
    this->UpdateProgress(value);
  };
  job.IsCanceled = [this]() { return this->GetAbortExecute() != 0; };
  // A progress observer may abort while TetGen runs.
  job.TetGen.IsCanceled = [this, &progress]()
  {
    this->UpdateProgress(progress);
    return this->GetAbortExecute() != 0;
  };
  interlume::Error error;
  try
  {
    error = this->Mesh(job);
    if (!error && !job.IsCanceled())
    {
      this->FillOutput(job, output);
    }
  }
  catch (const std::bad_alloc&)
  {
    output->Initialize();
    error = interlume::Error("Not enough memory for the mesh. Relax QualityBound or MaximumVolume.",
      interlume::ErrorCode::OutOfMemory);
  }
  if (error)
  {
    vtkErrorMacro(<< error);
  }
  job.Report.CopyTo(this->Report);
  this->IsEmpty = this->IsEmpty && !error && output->GetNumberOfCells() == 0;
  this->Warn(job);
  return 1;
}

interlume::Error vtkTetrahedralMesher::Mesh(interlume::MeshingJob& job)
{
  if (interlume::Error error =
        interlume::ArrayCheck::MakeSentence(interlume::GridCheck::FindError(job.Input)))
  {
    return error;
  }
  int dimension = 0;
  const vtkIdType cells = job.Input->GetNumberOfCells();
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    dimension =
      std::max(dimension, interlume::MeshingJob::GetDimension(job.Input->GetCellType(cell)));
  }
  if (dimension == 3)
  {
    return interlume::Meshers::MeshCells(job);
  }
  return dimension == 2 ? interlume::Meshers::MeshSurface(job)
                        : interlume::Meshers::MeshPoints(job);
}

void vtkTetrahedralMesher::FillOutput(interlume::MeshingJob& job, vtkUnstructuredGrid* output)
{
  const interlume::Tetrahedra& mesh = job.Mesh;
  const auto tetrahedra = static_cast<vtkIdType>(mesh.Tetrahedra.size() / 4);
  if (tetrahedra == 0)
  {
    return;
  }
  job.SetProgress(0.9);
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.Origins.size()));
  double* coordinates = vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0);
  std::transform(mesh.Points.begin(), mesh.Points.end(), coordinates,
    [&mesh](double x) { return std::ldexp(x, mesh.UnitExponent); });
  grid->SetPoints(points);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(tetrahedra + 1);
  for (vtkIdType t = 0; t <= tetrahedra; ++t)
  {
    offsets->SetValue(t, 4 * t);
  }
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(4 * tetrahedra);
  std::copy(mesh.Tetrahedra.begin(), mesh.Tetrahedra.end(), connectivity->GetPointer(0));
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  grid->SetCells(VTK_TETRA, cells);
  if (!interlume::MeshedArrays::InterpolatePointData(job.Input, mesh, job.IsCanceled, grid))
  {
    return;
  }
  if (!mesh.Cells.empty())
  {
    interlume::MeshedArrays::CopyCellData(job.Input, mesh, grid);
  }
  if (!mesh.Regions.empty())
  {
    vtkNew<vtkIntArray> regions;
    regions->SetName("RegionId");
    regions->SetNumberOfValues(tetrahedra);
    std::copy(mesh.Regions.begin(), mesh.Regions.end(), regions->GetPointer(0));
    grid->GetCellData()->AddArray(regions);
  }
  for (const interlume::PointSources& origin : mesh.Origins)
  {
    job.Report.AddedPoints += origin.NumberOfSources != 1;
  }
  Measure(job);
  output->ShallowCopy(grid);
}

void vtkTetrahedralMesher::Warn(const interlume::MeshingJob& job)
{
  const interlume::TetrahedralMesherReport& report = job.Report;
  if (report.UnsupportedCells > 0)
  {
    vtkWarningMacro(<< report.UnsupportedCells
                    << " cells of unsupported types were skipped. Convert them to linear cells.");
  }
  if (report.FoldedFaces > 0)
  {
    vtkWarningMacro(
      << report.FoldedFaces
      << " faces meet themselves: they have coincident points, crossing edges or no "
         "area. They were cleaned and triangulated. The first is a face of cell "
      << report.FirstFoldedCell
      << ". If the mesh is wrong there, move its points, or merge and triangulate the "
         "cells first, in ParaView with Clean to Grid, or with Clean and Triangulate "
         "for a surface.");
  }
  if (report.TetrahedraAboveQualityBound > 0)
  {
    vtkWarningMacro(<< report.TetrahedraAboveQualityBound << " of " << report.Tetrahedra
                    << " tetrahedra exceed QualityBound " << this->QualityBound
                    << ". The largest radius-edge ratio is " << report.LargestRadiusEdgeRatio
                    << ".");
  }
  if (report.TetrahedraAboveMaximumVolume > 0)
  {
    vtkWarningMacro(<< report.TetrahedraAboveMaximumVolume << " of " << report.Tetrahedra
                    << " tetrahedra exceed MaximumVolume " << this->MaximumVolume
                    << ". The largest volume is " << report.LargestVolume << ".");
  }
}

void vtkTetrahedralMesher::BeginExecution()
{
  if (this->Depth++ == 0)
  {
    this->IsEmpty = true;
  }
}

void vtkTetrahedralMesher::WarnIfEmpty()
{
  if (--this->Depth > 0)
  {
    return;
  }
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* information = this->GetOutputInformation(0);
  const bool isPiece = information->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) &&
    information->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1;
  if (this->WarnOnEmptyOutput && this->IsEmpty && !isPiece && !this->GetAbortExecute())
  {
    const double skippedCells =
      this->Report->GetNumber("SkippedCells") + this->Report->GetNumber("UnsupportedCells");
    vtkWarningMacro("The output is empty: "
      << (skippedCells > 0 ? "all " + std::to_string(static_cast<vtkIdType>(skippedCells)) +
               " cells are ghosts, hidden, of an unsupported type or not three-dimensional."
                           : "the input has no points or only cells without volume."));
  }
}

void vtkTetrahedralMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "QualityBound", this->QualityBound },
      { "MinimumDihedralAngle", this->MinimumDihedralAngle },
      { "MaximumVolume", this->MaximumVolume },
      { "MaximumNumberOfAddedPoints", this->MaximumNumberOfAddedPoints },
      { "PreserveBoundary", this->PreserveBoundary },
      { "FillNestedShells", this->FillNestedShells }, { "SplitContacts", this->SplitContacts },
      { "TimeLimit", this->TimeLimit }, { "WorkerFileName", this->WorkerFileName },
      { "WarnOnEmptyOutput", this->WarnOnEmptyOutput } });
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}

#include "vtkFlowRun.h"

#include "vtkAdvection.h"
#include "vtkFlowBatches.h"
#include "vtkFlowDispatch.h"
#include "vtkTerminationSides.h"
#include "vtkTerminationSurface.h"

#include "vtkAlgorithm.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSignedCharArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>
#include <set>

namespace
{
template <typename Array>
Array* Add(vtkDataSet* samples, const std::string& name, int components)
{
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(samples->GetNumberOfPoints());
  samples->GetPointData()->AddArray(array);
  return array;
}
}

/// What is kept of the samples; null is not.
struct vtkFlowRun::Arrays
{
  vtkUnsignedCharArray* Status;
  vtkIntArray* Id;
  vtkDoubleArray* Parameters;
  vtkDoubleArray* Time;
  vtkSignedCharArray* Side;
  vtkDoubleArray* MaximumSpeed = nullptr;
  vtkDoubleArray* ArcLength = nullptr;
  vtkDoubleArray* MeanVorticity = nullptr;
  std::vector<vtkDoubleArray*> Means;
  vtkIntArray* Steps = nullptr;
  vtkIntArray* StiffSteps = nullptr;

  void Set(vtkIdType id, const vtkAdvectionResult& result)
  {
    this->Status->SetValue(id, static_cast<unsigned char>(result.Status));
    this->Id->SetValue(id, result.Id);
    this->Parameters->SetTypedTuple(id, result.Parameters);
    this->Time->SetValue(id, result.Time);
    const auto set = [id](vtkDoubleArray* array, double value)
    {
      if (array)
      {
        array->SetValue(id, value);
      }
    };
    set(this->MaximumSpeed, result.MaximumSpeed);
    set(this->ArcLength, result.ArcLength);
    set(this->MeanVorticity, result.MeanVorticity);
    for (std::size_t i = 0; i < this->Means.size(); ++i)
    {
      this->Means[i]->SetValue(id, i < result.Means.size() ? result.Means[i] : 0.0);
    }
    if (this->Steps)
    {
      this->Steps->SetValue(id, result.Steps);
      this->StiffSteps->SetValue(id, result.StiffSteps);
    }
  }
};

//------------------------------------------------------------------------------
vtkFlowRun::vtkFlowRun(vtkAlgorithm* owner, const vtkAdvectionOptions& options)
  : Owner(owner)
  , Options(options)
{
}

//------------------------------------------------------------------------------
void vtkFlowRun::SetField(
  vtkDataSet* field, vtkDataArray* vectors, const std::vector<std::string>& means)
{
  this->Field = field;
  this->Vectors = vectors;
  this->Means = means;
}

//------------------------------------------------------------------------------
void vtkFlowRun::SetAutomatic(double error, double speed)
{
  this->AutomaticError = error;
  this->AutomaticSpeed = speed;
}

//------------------------------------------------------------------------------
std::string vtkFlowRun::FindArrays(std::vector<vtkDataArray*>& means) const
{
  for (const std::string& mean : this->Means)
  {
    vtkDataArray* array = this->Field->GetPointData()->GetArray(mean.c_str());
    if (!array || array->GetNumberOfComponents() != 1)
    {
      return "The field has no point array \"" + mean + "\" of one component to take the mean of.";
    }
    means.push_back(array);
  }
  return {};
}

//------------------------------------------------------------------------------
std::string vtkFlowRun::Execute(vtkDataSet* samples)
{
  std::vector<vtkDataArray*> means;
  std::string error = this->FindArrays(means);
  if (!error.empty())
  {
    return error;
  }
  for (std::size_t i = 0; i < means.size(); ++i)
  {
    this->Options.MeanArrays.push_back(static_cast<int>(i));
  }
  Arrays arrays;
  arrays.Status = Add<vtkUnsignedCharArray>(samples, vtkFlowStatus::StatusArray(), 1);
  arrays.Id = Add<vtkIntArray>(samples, vtkFlowStatus::IdArray(), 1);
  arrays.Parameters = Add<vtkDoubleArray>(samples, vtkFlowStatus::ParametersArray(), 2);
  arrays.Time = Add<vtkDoubleArray>(samples, vtkFlowStatus::TimeArray(), 1);
  arrays.Side = Add<vtkSignedCharArray>(samples, vtkFlowStatus::SideArray(), 1);
  if (this->Options.HasMaximumSpeed)
  {
    arrays.MaximumSpeed = Add<vtkDoubleArray>(samples, "MaximumSpeed", 1);
  }
  if (this->Options.HasArcLength)
  {
    arrays.ArcLength = Add<vtkDoubleArray>(samples, "ArcLength", 1);
  }
  if (this->Options.HasMeanVorticity)
  {
    arrays.MeanVorticity = Add<vtkDoubleArray>(samples, "MeanVorticity", 1);
  }
  for (const std::string& mean : this->Means)
  {
    arrays.Means.push_back(Add<vtkDoubleArray>(samples, "Mean" + mean, 1));
  }
  if (this->KeepSteps)
  {
    arrays.Steps = Add<vtkIntArray>(samples, "AdvectionSteps", 1);
    arrays.StiffSteps = Add<vtkIntArray>(samples, "StiffSteps", 1);
  }
  error = vtkFlowDispatch::Execute(
    this->Field, this->Vectors, means,
    [&](const auto& walker)
    {
      const double largestSpeed = walker.GetField().GetMaximumSpeed();
      if (this->AutomaticError > 0.0)
      {
        // A field that is 0 throughout has no error.
        this->Options.MaximumError =
          std::max(this->AutomaticError * largestSpeed, std::numeric_limits<double>::min());
      }
      if (this->AutomaticSpeed > 0.0)
      {
        this->Options.MinimumSpeed =
          std::max(this->AutomaticSpeed * largestSpeed, std::numeric_limits<double>::min());
      }
      this->Follow(walker, samples, arrays);
    },
    vtkFlowProgress(this->Owner, 0.0, vtkFlowDispatch::BuildingPart));
  this->AddSurfaces(samples);
  return error;
}

//------------------------------------------------------------------------------
template <typename Walker>
void vtkFlowRun::Follow(const Walker& walker, vtkDataSet* samples, Arrays& arrays)
{
  vtkSMPThreadLocal<vtkFlowReport> reports;
  const vtkIdType number = samples->GetNumberOfPoints();
  if (number > 0)
  {
    // What the dataset makes at the first call is there for threads.
    double x[3];
    samples->GetPoint(0, x);
  }
  vtkTerminationSides sides(this->Options);
  sides.SetNumberOfSamples(number);
  vtkFlowBatches::Run(number, this->Owner, vtkFlowDispatch::BuildingPart, 1.0,
    [&](vtkIdType first, vtkIdType end)
    {
      vtkAdvection<Walker> advection(walker, this->Options);
      vtkFlowReport& report = reports.Local();
      vtkAdvectionResult result;
      for (vtkIdType id = first; id < end; ++id)
      {
        double x[3];
        samples->GetPoint(id, x);
        advection.Follow(x, result);
        arrays.Set(id, result);
        sides.Add(id, x, result);
        report.Add(result);
      }
    });
  FindSides(walker, samples, sides, arrays);
  this->Report = vtkFlowReport();
  for (const vtkFlowReport& report : reports)
  {
    this->Report.Add(report);
  }
  this->Report.MaximumError = this->Options.MaximumError;
  this->Report.MinimumSpeed = this->Options.MinimumSpeed;
}

//------------------------------------------------------------------------------
template <typename Walker>
void vtkFlowRun::FindSides(
  const Walker& walker, vtkDataSet* samples, const vtkTerminationSides& sides, Arrays& arrays)
{
  arrays.Side->Fill(0);
  const std::vector<vtkIdType> corners = sides.FindCorners(samples, arrays.Id->GetPointer(0));
  vtkSMPTools::For(0, static_cast<vtkIdType>(corners.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      Walker field(walker);
      for (vtkIdType i = first; i < last; ++i)
      {
        const vtkIdType id = corners[static_cast<std::size_t>(i)];
        double x[3];
        double p[3];
        double rate[3];
        double velocity[3];
        samples->GetPoint(id, x);
        if (field.Locate(x, p))
        {
          field.GetVelocity(p, rate);
          field.GetWorldVector(p, rate, velocity);
          arrays.Side->SetValue(id, sides.GetSide(id, arrays.Id->GetValue(id), x, velocity));
        }
      }
    });
}

//------------------------------------------------------------------------------
void vtkFlowRun::AddSurfaces(vtkDataSet* samples) const
{
  vtkNew<vtkIntArray> table;
  table->SetName(vtkFlowStatus::SurfacesArray());
  table->SetNumberOfComponents(3);
  std::set<int> known;
  const auto add = [&](int id, bool isPeriodicU, bool isPeriodicV)
  {
    if (known.insert(id).second)
    {
      const int tuple[3] = { id, isPeriodicU ? 1 : 0, isPeriodicV ? 1 : 0 };
      table->InsertNextTypedTuple(tuple);
    }
  };
  for (const vtkAdvectionOptions::Surface& surface : this->Options.Surfaces)
  {
    for (int part = 0; part < surface.Shape->GetNumberOfParts(); ++part)
    {
      add(
        surface.Id + part, surface.Shape->IsPeriodic(0, part), surface.Shape->IsPeriodic(1, part));
    }
  }
  for (int face = 0; this->Options.HasDomainFaces && face < 6; ++face)
  {
    add(this->Options.DomainFaceId + face, false, false);
  }
  samples->GetFieldData()->AddArray(table);
}

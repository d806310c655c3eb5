// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/ImplicitFlowRun.h"

#include "Advection/AdvectionOptions.h"
#include "Checkpoint/CheckpointedStreamlines.h"
#include "Checkpoint/FlowCheckpoint.h"
#include "Common/ArrayCheck.h"
#include "Common/Vectors.h"
#include "Fields/BoundaryPatches.h"
#include "Fields/FieldDispatch.h"
#include "Fields/OpenInterfaces.h"
#include "Samples/BeyondCorners.h"
#include "Samples/BeyondSamples.h"
#include "Samples/BeyondTrace.h"
#include "Samples/CellRefinement.h"
#include "Samples/ImplicitFlowArrays.h"
#include "Samples/ReachedBoundary.h"
#include "Samples/SampleOrder.h"
#include "Samples/SamplingCheck.h"
#include "Samples/SharedLattice.h"
#include "Samples/TerminationSides.h"
#include "Streams/LocalStreamlines.h"
#include "Streams/RankField.h"
#include "Streams/RankStreamlines.h"

#include "vtkAlgorithm.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSignedCharArray.h"
#include "vtkTerminationSurface.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>

namespace interlume
{

namespace
{
constexpr double AutomaticError = 1e-6;
constexpr double AutomaticSpeed = 1e-9;
// The progress when all samples are followed, and what is beside them is not.
constexpr double SamplesEnd = 0.98;

int GetAutomaticSteps(vtkIdType cells)
{
  constexpr double least = 2000.0;
  return static_cast<int>(std::max(least, 20.0 * std::cbrt(static_cast<double>(cells))));
}

template <typename Array>
Array* Add(vtkFieldData* data, const std::string& name, int components, vtkIdType number)
{
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(number);
  data->AddArray(array);
  return array;
}
}

/// The arrays that are kept of the samples; those that are not kept are null.
struct ImplicitFlowRun::Arrays
{
  vtkUnsignedCharArray* Status = nullptr;
  vtkIntArray* Id = nullptr;
  vtkDoubleArray* Parameters = nullptr;
  vtkDoubleArray* Time = nullptr;
  vtkSignedCharArray* Side = nullptr;
  vtkDoubleArray* MaximumSpeed = nullptr;
  vtkDoubleArray* ArcLength = nullptr;
  vtkDoubleArray* MeanVorticity = nullptr;
  std::vector<vtkDoubleArray*> Means;
  vtkIntArray* Steps = nullptr;
  vtkIntArray* StiffSteps = nullptr;

  /// Calls visit(array, name, components) for the arrays that are kept.
  template <typename Visit>
  void ForEach(const ImplicitFlowRun& run, Visit&& visit)
  {
    visit(this->Status, vtkFlowStatus::StatusArray(), 1);
    visit(this->Id, vtkFlowStatus::IdArray(), 1);
    visit(this->Parameters, vtkFlowStatus::ParametersArray(), 2);
    visit(this->Time, vtkFlowStatus::TimeArray(), 1);
    visit(this->Side, vtkFlowStatus::SideArray(), 1);
    const auto visitIf = [&visit](bool isKept, auto& array, const char* name)
    {
      if (isKept)
      {
        visit(array, name, 1);
      }
    };
    visitIf(run.Options.ComputeMaximumSpeed, this->MaximumSpeed, "MaximumSpeed");
    visitIf(run.Options.ComputeArcLength, this->ArcLength, "ArcLength");
    visitIf(run.Options.ComputeMeanVorticity, this->MeanVorticity, "MeanVorticity");
    this->Means.resize(run.Options.MeanArrays.size());
    for (std::size_t i = 0; i < this->Means.size(); ++i)
    {
      visit(this->Means[i], "Mean" + run.Options.MeanArrays[i], 1);
    }
    visitIf(run.Options.KeepSteps, this->Steps, "AdvectionSteps");
    visitIf(run.Options.KeepSteps, this->StiffSteps, "StiffSteps");
  }

  /// Makes the arrays and adds them to samples.
  void Make(const ImplicitFlowRun& run, vtkDataSet* samples)
  {
    this->ForEach(run,
      [samples](auto& array, const std::string& name, int components)
      {
        array = Add<std::remove_reference_t<decltype(*array)>>(
          samples->GetPointData(), name, components, samples->GetNumberOfPoints());
      });
  }
  /// Makes the arrays of the samples beyond and adds them to field data.
  void MakeBeyond(const ImplicitFlowRun& run, vtkFieldData* data, vtkIdType number)
  {
    this->ForEach(run,
      [data, number](auto& array, const std::string& name, int components)
      {
        array = Add<std::remove_reference_t<decltype(*array)>>(
          data, BeyondSamples::GetName(name), components, number);
      });
  }
  /// Takes the arrays that samples have.
  void Find(const ImplicitFlowRun& run, vtkDataSet* samples)
  {
    this->ForEach(run,
      [samples](auto& array, const std::string& name, int)
      {
        array = std::remove_reference_t<decltype(*array)>::SafeDownCast(
          samples->GetPointData()->GetArray(name.c_str()));
      });
  }

  void Set(vtkIdType id, const AdvectionResult& result)
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

  AdvectionResult Get(vtkIdType id) const
  {
    AdvectionResult result;
    result.Status = this->Status->GetValue(id);
    result.Id = this->Id->GetValue(id);
    this->Parameters->GetTypedTuple(id, result.Parameters);
    result.Time = this->Time->GetValue(id);
    const auto get = [id](const vtkDoubleArray* array)
    { return array ? array->GetValue(id) : 0.0; };
    result.MaximumSpeed = get(this->MaximumSpeed);
    result.ArcLength = get(this->ArcLength);
    result.MeanVorticity = get(this->MeanVorticity);
    for (const vtkDoubleArray* mean : this->Means)
    {
      result.Means.push_back(get(mean));
    }
    result.Steps = this->Steps ? this->Steps->GetValue(id) : 0;
    result.StiffSteps = this->StiffSteps ? this->StiffSteps->GetValue(id) : 0;
    return result;
  }
};

ImplicitFlowRun::ImplicitFlowRun(
  vtkAlgorithm* owner, const AdvectionOptions& options, vtkDataSet* field, vtkDataArray* vectors)
  : Owner(owner)
  , Options(options)
  , Field(field)
  , Data(field)
  , Vectors(vectors)
{
}

void ImplicitFlowRun::SetRanks(RankField* ranks)
{
  this->Ranks = ranks;
  this->Field = ranks->GetWhole();
  this->Data = ranks->GetData();
}

void ImplicitFlowRun::ReplaceAutomatic(double speed)
{
  const auto replace = [](auto& value, auto automatic) { value = value > 0 ? value : automatic; };
  // A field that is 0 throughout has no error.
  constexpr double least = std::numeric_limits<double>::min();
  replace(this->Options.MaximumError, std::max(AutomaticError * speed, least));
  replace(this->Options.MinimumSpeed, std::max(AutomaticSpeed * speed, least));
  replace(this->Options.MaximumTime, VTK_DOUBLE_MAX);
  const vtkIdType cells =
    this->Ranks ? this->Ranks->GetNumberOfCells() : this->Field->GetNumberOfCells();
  replace(this->Options.MaximumNumberOfSteps, GetAutomaticSteps(cells));
}

std::string ImplicitFlowRun::FindArrays(std::vector<vtkDataArray*>& means) const
{
  for (const std::string& mean : this->Options.MeanArrays)
  {
    const std::string wrong = ArrayCheck::FindPointFault(this->Data, "field", mean, 1);
    if (!wrong.empty())
    {
      return "There is no mean: " + wrong + ".";
    }
    means.push_back(this->Data->GetPointData()->GetArray(mean.c_str()));
  }
  return {};
}

std::string ImplicitFlowRun::Execute(vtkDataSet* samples)
{
  std::vector<vtkDataArray*> means;
  const bool isEmpty = this->Ranks && this->Ranks->IsEmpty();
  std::string error = isEmpty ? std::string() : this->FindArrays(means);
  error = this->Ranks ? this->Ranks->GetExchange().FindFirst(error) : error;
  if (!error.empty())
  {
    return error;
  }
  for (std::size_t i = 0; i < this->Options.MeanArrays.size(); ++i)
  {
    this->Options.MeanNumbers.push_back(static_cast<int>(i));
  }
  const auto count = [this](vtkDataArray* array)
  { this->Report.FieldBytes += array->GetNumberOfValues() * array->GetDataTypeSize(); };
  if (!isEmpty)
  {
    count(this->Vectors);
    std::for_each(means.begin(), means.end(), count);
  }
  Arrays arrays;
  arrays.Make(*this, samples);
  return this->Ranks ? this->ExecuteInRanks(means, samples) : this->ExecuteAlone(means, samples);
}

std::string ImplicitFlowRun::ExecuteAlone(
  const std::vector<vtkDataArray*>& means, vtkDataSet* samples)
{
  return FieldDispatch::Execute(
    this->Field, this->Vectors, means,
    [&](const auto& walker)
    {
      auto own = walker;
      int domainFaces = 6;
      BoundaryPatches patches;
      this->Describe(walker.GetField());
      if constexpr (std::is_same_v<decltype(own), UnstructuredWalker>)
      {
        this->Mesh = walker.GetField().GetMesh();
        if (this->Options.DomainFaces)
        {
          const UnstructuredFlowField& field = walker.GetField();
          patches.Build(
            field.GetOuterFaces(),
            [&field](vtkIdType face, vtkIdType* points)
            { return field.GetFacePoints(face, points); },
            field.GetPositions());
          own.SetPatches(&patches);
          domainFaces = patches.GetNumberOfPatches();
        }
      }
      LocalStreamlines<decltype(own)> streamlines(own, this->Owner);
      this->FollowAll(streamlines, samples, domainFaces);
    },
    StageProgress(this->Owner, 0.0, FieldDispatch::BuildingPart));
}

std::string ImplicitFlowRun::ExecuteInRanks(
  const std::vector<vtkDataArray*>& means, vtkDataSet* samples)
{
  std::string error;
  const std::unique_ptr<RankStreamlines> streamlines =
    RankStreamlines::Make(*this->Ranks, this->Vectors, means, this->Owner, error);
  if (!streamlines)
  {
    return error;
  }
  this->HasObstacles = this->Ranks->GetExchange().IsAnywhere(this->HasObstacles);
  this->Describe(streamlines->GetField());
  streamlines->Describe(this->Report);
  const int domainFaces = this->Options.DomainFaces ? streamlines->FindDomainFaces() : 0;
  this->FollowAll(*streamlines, samples, domainFaces);
  RankExchange& exchange = this->Ranks->GetExchange();
  std::vector<vtkIdType> steps(static_cast<std::size_t>(exchange.GetNumberOfRanks()), 0);
  steps[static_cast<std::size_t>(exchange.GetRank())] = streamlines->GetNumberOfSteps();
  exchange.Add(steps);
  std::vector<vtkIdType> handedOn{ streamlines->GetNumberOfHandedOn() };
  exchange.Add(handedOn);
  this->Report.StepsOfRanks = steps;
  this->Report.HandedOn = handedOn[0];
  return {};
}

void ImplicitFlowRun::FollowAll(Streamlines& streamlines, vtkDataSet* samples, int domainFaces)
{
  if (!this->Checkpoint)
  {
    this->FollowLevels(streamlines, samples, domainFaces);
    return;
  }
  CheckpointedStreamlines recorded(
    streamlines, *this->Checkpoint, this->Ranks ? &this->Ranks->GetExchange() : nullptr);
  this->FollowLevels(recorded, samples, domainFaces);
  this->Report.ResumedStreamlines = this->Checkpoint->GetNumberOfResumed();
  this->Report.Checkpoints = this->Checkpoint->GetNumberOfFiles();
}

void ImplicitFlowRun::FollowLevels(Streamlines& streamlines, vtkDataSet* samples, int domainFaces)
{
  this->ReplaceAutomatic(streamlines.GetField().GetSpeedScale());
  this->AddSurfaces(samples, this->Options.DomainFaces ? domainFaces : 0);
  this->Report.MaximumError = this->Options.MaximumError;
  this->Report.MinimumSpeed = this->Options.MinimumSpeed;
  double bounds[6];
  samples->GetBounds(bounds);
  TerminationSides sides(this->Options, bounds);
  bool goesOn = this->Follow(streamlines, samples, 0, 0, sides);
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  if (goesOn && this->Options.RefinementLevels > 0)
  {
    grid = CellRefinement::MakeGrid(samples);
  }
  for (int level = 1; goesOn && level <= this->Options.RefinementLevels; ++level)
  {
    goesOn = this->FindBeyond(streamlines, grid, false);
    if (!goesOn)
    {
      break;
    }
    const vtkIdType before = grid->GetNumberOfPoints();
    const CellRefinement::Result refined = CellRefinement::Refine(grid);
    grid = refined.Grid;
    this->Report.RefinedCells.push_back(refined.MixedCells);
    this->Report.AddedSamples.push_back(grid->GetNumberOfPoints() - before);
    goesOn = this->Follow(streamlines, grid, before, level, sides);
  }
  goesOn = goesOn && this->FindBeyond(streamlines, grid ? grid.GetPointer() : samples, true);
  if (goesOn && !grid && this->Options.SamplingChecks > 0)
  {
    goesOn = this->CheckSampling(streamlines, samples);
  }
  this->Refined = goesOn ? grid : nullptr;
  this->Aborted = !goesOn;
}

template <typename FieldType>
void ImplicitFlowRun::Describe(const FieldType& field)
{
  this->Report.NonFiniteVectors = field.GetNumberOfNonFiniteVectors();
  this->HasObstacles = this->HasObstacles || this->Report.NonFiniteVectors > 0;
  this->Report.MaximumSpeed = field.GetMaximumSpeed();
  this->Report.FillValues = field.GetFillValues().Number;
  this->Report.FillValue = field.GetFillValues().Value;
  this->Report.SpeedScale = field.GetSpeedScale();
  this->Report.CellsOfFewerDimensions = field.GetNumberOfFlatCells();
  if constexpr (std::is_same_v<FieldType, StructuredFlowField> ||
    std::is_same_v<FieldType, UnstructuredFlowField>)
  {
    this->Report.JoinedFaces = field.GetJoins().Number;
    this->Report.LargestJoinedGap = field.GetJoins().LargestGap;
    const auto find = [&field]() -> std::pair<vtkIdType, vtkIdType>
    {
      const interlume::OpenInterfaces open = interlume::OpenInterfaces::Find(field);
      return { open.Number, open.FirstCell };
    };
    if constexpr (std::is_same_v<FieldType, UnstructuredFlowField>)
    {
      this->Report.KeptFaces = field.GetNumberOfKeptFaces();
      std::tie(this->Report.OpenInterfaces, this->Report.FirstOpenCell) =
        field.GetMesh()->GetOpenInterfaces(find);
    }
    else
    {
      std::tie(this->Report.OpenInterfaces, this->Report.FirstOpenCell) = find();
    }
  }
}

bool ImplicitFlowRun::Follow(Streamlines& streamlines, vtkDataSet* samples, vtkIdType first,
  int level, TerminationSides& sides)
{
  Arrays arrays;
  arrays.Find(*this, samples);
  vtkSMPThreadLocal<vtkFlowReport> reports;
  const vtkIdType number = samples->GetNumberOfPoints();
  if (number > 0)
  {
    // Makes the data that the dataset makes at the first call, before threads need them.
    double x[3];
    samples->GetPoint(0, x);
  }
  sides.SetNumberOfSamples(number);
  constexpr double start = FieldDispatch::BuildingPart;
  const double part = (SamplesEnd - start) / (this->Options.RefinementLevels + 1.0);
  const auto take = [&](vtkIdType id, const double x[3], const AdvectionResult& result)
  {
    arrays.Set(id, result);
    sides.Add(id, x, result);
    reports.Local().Add(result);
  };
  vtkIdType done = 0;
  const auto getProgress = [&]
  {
    const double share = static_cast<double>(done) / std::max<vtkIdType>(1, number - first);
    return start + (level + share) * part;
  };
  const auto follow = [&](const SampleOrder& order)
  {
    const double before = getProgress();
    done += order.GetNumber();
    this->Progress = getProgress();
    return streamlines.Follow(
      this->Options, order.GetNumber(),
      [&](vtkIdType i, double x[3]) { samples->GetPoint(order[i], x); },
      [&](vtkIdType i, const AdvectionResult& result)
      {
        double x[3];
        samples->GetPoint(order[i], x);
        take(order[i], x, result);
      },
      before, this->Progress);
  };
  int dimensions[3];
  const bool isShared = this->Options.ShareStreamlines && level == 0 && !this->HasExtras() &&
    SharedLattice::GetDimensions(samples, dimensions);
  const bool isDone = isShared ? this->FollowShared(dimensions, samples, arrays,
                                   streamlines.GetField().GetSpeedScale(), follow, take)
                               : follow(SampleOrder(samples, first));
  for (const vtkFlowReport& report : reports)
  {
    this->Report.Add(report);
  }
  if (isDone)
  {
    FindSides(streamlines, samples, sides, arrays);
  }
  return isDone;
}

bool ImplicitFlowRun::HasExtras() const
{
  return this->Options.ComputeMaximumSpeed || this->Options.ComputeArcLength ||
    this->Options.ComputeMeanVorticity || !this->Options.MeanNumbers.empty();
}

double ImplicitFlowRun::GetFieldLength() const
{
  double bounds[6];
  this->Field->GetBounds(bounds);
  return Vectors::SafeLength(
    { bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
}

double ImplicitFlowRun::GetDistance(int id, const double first[2], const double other[2]) const
{
  for (const AdvectionOptions::Surface& surface : this->Options.Surfaces)
  {
    const int part = id - surface.Id;
    double x[3];
    double y[3];
    if (part >= 0 && part < surface.Shape->GetNumberOfParts())
    {
      return surface.Shape->EvaluatePoint(part, first, x) &&
          surface.Shape->EvaluatePoint(part, other, y)
        ? Vectors::SafeLength(Vectors::Difference(x, y))
        : std::numeric_limits<double>::infinity();
    }
  }
  // No face of the domain is wider than the field.
  return this->GetFieldLength() *
    std::max(std::abs(first[0] - other[0]), std::abs(first[1] - other[1]));
}

template <typename FollowSome, typename TakeResult>
bool ImplicitFlowRun::FollowShared(const int dimensions[3], vtkDataSet* samples,
  const Arrays& arrays, double speed, FollowSome&& follow, TakeResult&& take)
{
  const double length = this->GetFieldLength();
  SharedLattice lattice(
    dimensions,
    { arrays.Status->GetPointer(0), arrays.Id->GetPointer(0), arrays.Parameters->GetPointer(0),
      arrays.Time->GetPointer(0) },
    [&](const SharedLattice::Answer& guess, const double* uv, double time)
    {
      const double error = std::max(
        this->GetDistance(guess.Id, guess.Parameters, uv), speed * std::abs(guess.Time - time));
      // What rounding leaves of numbers as large is no error.
      constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
      return error / (this->Options.MaximumError * time + rounding * length);
    },
    [this](int id) -> std::array<bool, 2>
    {
      for (const AdvectionOptions::Surface& surface : this->Options.Surfaces)
      {
        const int part = id - surface.Id;
        if (part >= 0 && part < surface.Shape->GetNumberOfParts())
        {
          return { { surface.Shape->IsPeriodic(0, part), surface.Shape->IsPeriodic(1, part) } };
        }
      }
      return { { false, false } };
    });
  bool goesOn = follow(SampleOrder(samples, lattice.GetFirst()));
  while (goesOn && lattice.Next())
  {
    goesOn = follow(SampleOrder(samples, lattice.GetFollowed())) &&
      follow(SampleOrder(samples, lattice.CheckMiddles()));
    if (goesOn)
    {
      lattice.Share(
        [&](vtkIdType id, const SharedLattice::Answer& answer)
        {
          AdvectionResult result;
          result.Status = vtkFlowStatus::REACHED_SURFACE;
          result.Id = answer.Id;
          std::copy_n(answer.Parameters, 2, result.Parameters);
          result.Time = answer.Time;
          double x[3];
          samples->GetPoint(id, x);
          take(id, x, result);
          ++this->Report.SharedSamples;
        });
    }
  }
  this->Report.SharedChecks = lattice.GetNumberOfChecks();
  this->Report.LargestSharedError = lattice.GetLargestError();
  this->Report.MeanSharedError = lattice.GetMeanError();
  return goesOn;
}

void ImplicitFlowRun::FindSides(
  Streamlines& streamlines, vtkDataSet* samples, const TerminationSides& sides, Arrays& arrays)
{
  arrays.Side->Fill(0);
  const std::vector<vtkIdType> corners = sides.FindCorners(samples, arrays.Id->GetPointer(0));
  const std::vector<Streamlines::Velocity> velocities = streamlines.GetVelocities(
    static_cast<vtkIdType>(corners.size()),
    [&](vtkIdType i, double x[3]) { samples->GetPoint(corners[static_cast<std::size_t>(i)], x); });
  vtkSMPTools::For(0, static_cast<vtkIdType>(corners.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      {
        if (velocities[i].IsInField)
        {
          const vtkIdType id = corners[i];
          double x[3];
          samples->GetPoint(id, x);
          arrays.Side->SetValue(id, sides.GetSide(id, arrays.Id->GetValue(id), x, velocities[i].V));
        }
      }
    });
}

bool ImplicitFlowRun::FindBeyond(Streamlines& streamlines, vtkDataSet* samples, bool isLast) const
{
  vtkFieldData* data = samples->GetFieldData();
  BeyondSamples::Remove(data);
  ImplicitFlowArrays known;
  std::vector<BeyondCorners::Corner> corners;
  std::vector<BeyondCorners::Pair> pairs;
  const bool hasBoundary = isLast && this->HasObstacles;
  if (known.Find(samples).empty())
  {
    corners = BeyondCorners::Find(samples, known, this->Options, hasBoundary ? &pairs : nullptr);
  }
  BeyondTrace trace(streamlines, this->Options, samples, this->Progress);
  std::vector<BeyondTrace::Answer> answers;
  bool isDone = trace.Find(corners, answers);
  std::vector<ReachedBoundary::Answer> beside;
  if (isDone && hasBoundary)
  {
    Arrays own;
    own.Find(*this, samples);
    ReachedBoundary boundary(streamlines, this->Options, samples, known, this->Progress);
    isDone = boundary.Find(
      pairs, [&own](vtkIdType sample) { return own.Get(sample); }, beside);
  }
  const auto first = static_cast<vtkIdType>(corners.size());
  const vtkIdType number = first + static_cast<vtkIdType>(beside.size());
  if (number == 0 || !isDone)
  {
    return isDone;
  }
  using Beyond = BeyondSamples;
  auto* points = Add<vtkIdTypeArray>(data, Beyond::GetName(Beyond::Point), 1, number);
  auto* positions = Add<vtkDoubleArray>(data, Beyond::GetName(Beyond::Position), 3, number);
  auto* distances = Add<vtkDoubleArray>(data, Beyond::GetName(Beyond::Distance), 1, number);
  auto* normals = Add<vtkDoubleArray>(data, Beyond::GetName(Beyond::Normal), 3, number);
  auto* surfaces = Add<vtkIntArray>(data, Beyond::GetName(Beyond::Surface), 1, number);
  Arrays arrays;
  arrays.MakeBeyond(*this, data, number);
  for (vtkIdType row = 0; row < first; ++row)
  {
    const auto i = static_cast<std::size_t>(row);
    points->SetValue(row, corners[i].Sample);
    positions->SetTuple(row, samples->GetPoint(corners[i].Sample));
    distances->SetValue(row, std::abs(corners[i].Distance));
    normals->SetTuple(row, answers[i].Normal);
    surfaces->SetValue(row, answers[i].IsStill ? Beyond::StandsStill : corners[i].Surface);
    arrays.Set(row, answers[i].Beyond);
    arrays.Side->SetValue(row, answers[i].Side);
  }
  for (vtkIdType row = first; row < number; ++row)
  {
    const ReachedBoundary::Answer& answer = beside[static_cast<std::size_t>(row - first)];
    constexpr double unknown[3] = { 0.0, 0.0, 0.0 };
    points->SetValue(row, answer.Sample);
    positions->SetTuple(row, samples->GetPoint(answer.Sample));
    distances->SetValue(row, answer.Distance);
    normals->SetTuple(row, unknown);
    surfaces->SetValue(row, Beyond::NoSurface);
    arrays.Set(row, answer.Beyond);
    arrays.Side->SetValue(row,
      static_cast<signed char>(answer.IsReached ? vtkFlowStatus::TOWARDS : -vtkFlowStatus::AWAY));
  }
  // The id tells whether something is reached.
  data->RemoveArray(Beyond::GetName(vtkFlowStatus::StatusArray()).c_str());
  return true;
}

bool ImplicitFlowRun::CheckSampling(Streamlines& streamlines, vtkDataSet* samples)
{
  ImplicitFlowArrays arrays;
  if (!arrays.Find(samples).empty())
  {
    return true;
  }
  SamplingCheck check(samples, arrays, this->Options.SamplingChecks);
  const bool isDone = streamlines.Follow(
    this->Options, check.GetNumber(), [&](vtkIdType i, double x[3]) { check.GetMiddle(i, x); },
    [&](vtkIdType i, const AdvectionResult& result) { check.Set(i, result); }, this->Progress, 1.0);
  if (isDone)
  {
    this->Report.Sampling = check.GetReport();
    SamplingCheck::AddArrays(this->Report.Sampling, samples->GetFieldData());
  }
  return isDone;
}

void ImplicitFlowRun::AddSurfaces(vtkDataSet* samples, int domainFaces) const
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
  for (const AdvectionOptions::Surface& surface : this->Options.Surfaces)
  {
    for (int part = 0; part < surface.Shape->GetNumberOfParts(); ++part)
    {
      add(
        surface.Id + part, surface.Shape->IsPeriodic(0, part), surface.Shape->IsPeriodic(1, part));
    }
  }
  for (int face = 0; face < domainFaces; ++face)
  {
    add(this->Options.DomainFaceId + face, false, false);
  }
  samples->GetFieldData()->AddArray(table);
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FinerPicture.h"
#include "Benchmarks/Approximations/PictureFamilies.h"
#include "Benchmarks/Shadows/ShadowsMethods.h"
#include "Benchmarks/Shadows/ShadowsScene.h"
#include "Support/Pictures/ReferenceShadowPicture.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace approximations
{
namespace
{
using Mapper = vtkShadowedSliceMapper;
using Change = std::function<void(Mapper*)>;

const char* const FrameLabel = "time of a frame (s)";
const char* const Norm = "channel difference, mean";
const char* const Automatic = "automatic";

/// A scene, its picture in double precision, and all ways to draw it.
class Scene
{
public:
  Scene(const shadows::Case& what, const BenchOptions& options)
    : Scene(what, options, reference::MakeShadowPicture(what.Scene))
  {
  }

  Scene(
    const shadows::Case& what, const BenchOptions& options, const reference::RgbaPicture& expected)
    : What(what.Scene)
    , Options(options)
    , Stage(what.Scene.Size)
    , Expected(expected)
  {
    this->AllTrials.SetSize("voxels along an edge", what.Scene.Image->GetDimensions()[0]);
    this->AllTrials.SetSize("pixels along an edge", what.Scene.Size[0]);
  }

  void Add(const std::string& method, const std::string& setting, Maker maker, const Change& change)
  {
    this->AddDrawn(method, setting, maker, shadows::MakeSlices(this->Stage, this->What, change));
  }

  /// Of other scenes that are to give the same picture, and of VTK's mapper.
  void AddDrawn(
    const std::string& method, const std::string& setting, Maker maker, shadows::MethodPointer made)
  {
    const std::shared_ptr<shadows::Method> drawn = std::move(made);
    this->AllTrials.Add(method, setting, maker, drawn->GetFrame(this->Options.Threads),
      [this, drawn]()
      { return reference::ComparePictures(drawn->Capture(), this->Expected).Mean; });
  }

  /// The default's distance of slices, in world units.
  double FindSpacing()
  {
    const shadows::MethodPointer plain = shadows::MakeSlices(this->Stage, this->What);
    plain->Capture();
    return plain->GetSlices()->GetReport().SliceSpacing;
  }

  void Run(const Question& question, BenchRows& rows)
  {
    this->AllTrials.Run(question, this->Options, rows, ClockOf(this->Stage.GetWindow()));
  }

  const reference::ShadowScene& Get() const { return this->What; }
  reference::VolumeStage& GetStage() { return this->Stage; }

private:
  reference::ShadowScene What;
  BenchOptions Options;
  reference::VolumeStage Stage;
  reference::RgbaPicture Expected;
  Trials AllTrials;
};

/// A case that scatters light evenly, in the picture's size of the suite.
shadows::Case MakeScattering(const shadows::Case& what, const BenchOptions& options)
{
  return shadows::MakeScattering(shadows::WithPixels({ what }, options.Pick(192, 64, 16)).front());
}

int PickPoints(const BenchOptions& options)
{
  return options.Pick(64, 32, 12);
}

void AddLookupRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  Scene scene(MakeScattering(shadows::MakeRings(PickPoints(options)), options), options);
  for (const int lookup : { Mapper::BILINEAR_LIGHT, Mapper::NEAREST_LIGHT })
  {
    const bool isUsual = lookup == Mapper::BILINEAR_LIGHT;
    const char* method = isUsual ? "bilinear" : "nearest";
    for (const int size : options.Pick<std::vector<int>>(
           { 0, 32, 64, 128, 256, 512 }, { 0, 32, 64, 128, 256 }, { 0, 16 }))
    {
      scene.Add(method, size == 0 ? Automatic : NumberText(size),
        isUsual && size == 0 ? Maker::Default : Maker::Own,
        [lookup, size](Mapper* mapper)
        {
          mapper->SetLightLookup(lookup);
          mapper->SetLightBufferSize(size);
        });
    }
  }
  scene.Run(question, rows);
}

void AddImageSampleRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  shadows::Case what = MakeScattering(shadows::MakeRings(PickPoints(options)), options);
  what.Scene.Shadows = false;
  reference::ShadowScene finer = what.Scene;
  finer.Size = { { Finer * what.Scene.Size[0], Finer * what.Scene.Size[1] } };
  Scene scene(what, options, MakeCoarser(reference::MakeShadowPicture(finer)));
  const double voxel = what.Scene.Image->GetSpacing()[0];
  for (const double distance : options.Pick<std::vector<double>>(
         { 0.5, 1.0, 2.0, 4.0, 8.0 }, { 0.5, 1.0, 2.0, 4.0 }, { 1.0, 2.0 }))
  {
    scene.Add("slices", NumberText(distance), distance == 1.0 ? Maker::Default : Maker::Own,
      [distance](Mapper* mapper) { mapper->SetImageSampleDistance(distance); });
    // VTK's mapper has no less than a ray for each pixel.
    if (distance >= 1.0)
    {
      vtkNew<vtkGPUVolumeRayCastMapper> rays;
      rays->SetInputData(what.Scene.Image);
      rays->AutoAdjustSampleDistancesOff();
      rays->SetImageSampleDistance(static_cast<float>(distance));
      rays->SetSampleDistance(static_cast<float>(0.5 * voxel));
      scene.AddDrawn(shadows::GpuPeer, NumberText(distance), Maker::Peer,
        std::make_unique<shadows::Method>(scene.GetStage(), scene.Get(), rays));
    }
  }
  scene.Run(question, rows);
}

void AddTransmissionRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  shadows::Case what = MakeScattering(shadows::MakeSmoke(PickPoints(options)), options);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.9, 0.5, 0.1);
  color->AddRGBPoint(1.0, 0.8, 0.3, 0.05);
  what.Scene.TransmissionColor = color;
  Scene scene(what, options);
  const double spacing = scene.FindSpacing();
  for (const double factor : options.Pick<std::vector<double>>(
         { 0.25, 0.5, 1.0, 2.0, 4.0 }, { 0.5, 1.0, 2.0 }, { 1.0, 2.0 }))
  {
    const auto add = [&](const char* method, vtkColorTransferFunction* function, Maker maker)
    {
      scene.Add(method, NumberText(factor), maker,
        [=](Mapper* mapper)
        {
          mapper->SetTransmissionColor(function);
          mapper->SetSliceSpacing(factor * spacing);
        });
    };
    add("three channels", color, factor == 1.0 ? Maker::Default : Maker::Own);
    add("one channel", nullptr, Maker::Own);
  }
  scene.Run(question, rows);
}

/// The scene with its scalars, 0 to 1, as integers or numbers of another type, 0 to \a scale.
reference::ShadowScene WithScalars(const reference::ShadowScene& from, int type, double scale)
{
  reference::ShadowScene made = from;
  vtkDataArray* values = from.Image->GetPointData()->GetScalars();
  auto scalars = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  scalars->SetNumberOfTuples(values->GetNumberOfTuples());
  for (vtkIdType id = 0; id < values->GetNumberOfTuples(); ++id)
  {
    const double value = scale * values->GetTuple1(id);
    scalars->SetTuple1(id, scale == 1.0 ? value : std::round(value));
  }
  made.Image = vtkSmartPointer<vtkImageData>::New();
  made.Image->CopyStructure(from.Image);
  made.Image->GetPointData()->SetScalars(scalars);
  made.Property = vtkSmartPointer<vtkVolumeProperty>::New();
  made.Property->DeepCopy(from.Property);
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const double node : { 0.0, 1.0 })
  {
    double rgb[3];
    from.Property->GetRGBTransferFunction()->GetColor(node, rgb);
    color->AddRGBPoint(scale * node, rgb[0], rgb[1], rgb[2]);
    opacity->AddPoint(scale * node, from.Property->GetScalarOpacity()->GetValue(node));
  }
  made.Property->SetColor(color);
  made.Property->SetScalarOpacity(opacity);
  return made;
}

void AddScalarTypeRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  shadows::Case what = MakeScattering(shadows::MakeSmoke(PickPoints(options)), options);
  Scene scene(what, options);
  const double spacing = 0.25 * scene.FindSpacing();
  const struct
  {
    const char* Name;
    int Type;
    double Scale;
  } types[] = { { "float", VTK_FLOAT, 1.0 }, { "double", VTK_DOUBLE, 1.0 },
    { "short", VTK_SHORT, 32767.0 }, { "unsigned char", VTK_UNSIGNED_CHAR, 255.0 },
    { "of 4 bits", VTK_UNSIGNED_CHAR, 15.0 } };
  for (const auto& type : types)
  {
    const reference::ShadowScene typed = WithScalars(what.Scene, type.Type, type.Scale);
    for (const double distance : { spacing, 4.0 * spacing })
    {
      scene.AddDrawn(type.Name, distance == spacing ? "slices 0.25" : "slices 1",
        type.Type == VTK_FLOAT && distance > spacing ? Maker::Default : Maker::Own,
        shadows::MakeSlices(scene.GetStage(), typed,
          [distance](Mapper* mapper) { mapper->SetSliceSpacing(distance); }));
    }
  }
  scene.Run(question, rows);
}
}

Family MakeLightLookupFamily()
{
  return { { "light-lookup", "Looking light up in its buffer: error against time of a frame",
             "Is light to be looked up in one texel of its buffer or in four?",
             "Rings under one light, all matter scattering evenly, columns of the light's buffer "
             "at each point; against a ray marcher with shadow rays in double precision.",
             FrameLabel, Norm },
    AddLookupRows };
}

Family MakeImageSampleFamily()
{
  return { { "image-sample-distance", "Coarser pictures: error against time of a frame",
             "How many pixels of the viewport for one of the picture?",
             "Rings without shadows, pixels of the viewport along an edge of one of the picture at "
             "each point; gpu is vtkGPUVolumeRayCastMapper with two samples a voxel; against a ray "
             "marcher in double precision, nine lines of sight a pixel.",
             FrameLabel, Norm },
    AddImageSampleRows };
}

Family MakeTransmissionFamily()
{
  return { { "coloured-transmission",
             "Light through coloured matter: error against time of a frame",
             "What do light's colours cost, and what is lost without them?",
             "Smoke that lets red pass better than blue, distance of slices over the default one "
             "at each point; light of three channels or of one, as without TransmissionColor; "
             "against a ray marcher with shadow rays in double precision.",
             FrameLabel, Norm },
    AddTransmissionRows };
}

Family MakeScalarTypeFamily()
{
  return { { "texel-rounding", "Types of scalars: error against time of a frame",
             "Does it matter how texels round scalars?",
             "Smoke as scalars of several types, slices a quarter of the default distance apart "
             "and the default one; against a ray marcher in double precision on the floats that "
             "the others are rounded from.",
             FrameLabel, Norm },
    AddScalarTypeRows };
}
}

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceGroup_h
#define interlume_SliceGroup_h

#include "Draw/SliceRenderer.h"

#include "vtkShadowedSliceReport.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkImageData;
class vtkLight;
class vtkRenderer;
class vtkVolume;
class vtkWindow;

namespace interlume
{

class SliceRasterizer;
struct SliceScene;

/**
 * @class   SliceGroup
 * @brief   draws volumes of several mappers in one set of slices
 *
 * All volumes move to one unit space; one plan, one picture and one buffer for each light serve
 * them. Each keeps its samples, blocks, transfer functions, textures and programs. Settings of what
 * is shared are those of vtkShadowedScenePass.h. The picture does not depend on the order in which
 * volumes are added: they are put into that of their bounds.
 */
class SliceGroup
{
public:
  SliceGroup();
  ~SliceGroup();

  /// Begins a picture without volumes.
  void Clear();
  /// Adds a volume, whose mapper has this renderer. The group uses both until Draw has
  /// returned.
  void Add(SliceRenderer* renderer, vtkVolume* volume, const SliceRenderer::Request& request);

  /**
   * Draws the picture ahead, as a part of \a scene. Volumes with a fault are left out. Returns why
   * the volumes cannot be drawn together, or nothing; nothing is drawn then, nor where fewer than
   * two volumes are left.
   */
  std::string Draw(vtkRenderer* renderer, SliceScene* scene);

  /// What a volume has of the picture: the report, with what is shared by all and its own textures,
  /// and warnings.
  struct Share
  {
    vtkShadowedSliceReport Report;
    std::vector<std::string> Warnings;
  };
  /// Returns the share of the volume of this renderer in the picture; null where it is not in it.
  const Share* Find(const SliceRenderer* renderer) const;

  /// Shows the picture, the first time after Draw.
  void Show(vtkRenderer* renderer);

  /// Does what vtkShadowedSliceMapper::ReadLightBuffer documents.
  bool ReadLightBuffer(vtkRenderer* renderer, vtkLight* light, vtkImageData* image);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Member
  {
    SliceRenderer* Renderer;
    vtkVolume* Volume;
    SliceRenderer::Request Request;
    Share Result;
  };

  void Sort();
  /// Gives all requests what the volumes share.
  void ShareSettings(SliceScene* scene);
  /// Moves all volumes to one unit space.
  void ShareSpace();
  double ChooseCoarseness() const;
  /// Plans the picture, for all volumes. Returns why it cannot be drawn, or nothing.
  std::string MakePlan(double coarseness, vtkShadowedSliceReport& report);
  bool HasTooManySlices(const std::vector<SlicePlan::Matter>& matter, double coarseness) const;
  /// Finds the light that is scattered in the matter of all volumes. Returns what is wrong, or
  /// nothing.
  std::string Scatter(vtkRenderer* renderer);
  std::string DrawMembers(vtkRenderer* renderer, SliceScene* scene);

  std::vector<Member> Members;
  /// What the last picture was drawn with, whatever becomes of its members.
  SlicePlan Plan;
  std::vector<LightSource> Lights;
  UnitSpace Space;
  /// Whether the members are what the last picture shows.
  bool IsDrawn = false;
  bool IsShown = false;
  std::map<vtkWindow*, std::unique_ptr<SliceRasterizer>> Windows;
  /// The least columns of a light's buffer where their number is automatic.
  int LeastBufferSize = 0;
  /// The seconds of the last picture, and how coarse it was.
  double LastSeconds = 0.0;
  double LastCoarseness = 1.0;
};

}

#endif

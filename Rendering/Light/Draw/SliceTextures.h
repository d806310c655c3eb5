#ifndef interlume_SliceTextures_h
#define interlume_SliceTextures_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkProjectiveLight;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

class MaterialTable;
class VolumeSamples;

/**
 * @class   SliceTextures
 * @brief   volume, transfer functions and light screens on the graphics card
 */
class SliceTextures
{
public:
  SliceTextures();
  ~SliceTextures();

  ///@{
  /// Bytes on the graphics card.
  static vtkIdType GetBytes(const VolumeSamples& samples);
  static vtkIdType GetBytes(const MaterialTable& material);
  ///@}

  ///@{
  /// Sends to the graphics card. Returns what is wrong, or nothing.
  std::string Upload(vtkOpenGLRenderWindow* window, const VolumeSamples& samples);
  std::string Upload(vtkOpenGLRenderWindow* window, const MaterialTable& material);
  ///@}

  /**
   * The texture of a light's screen, RGB in floats, made where \a light is new or has changed. \a
   * bytes grows by what was sent.
   */
  vtkTextureObject* GetScreen(
    vtkOpenGLRenderWindow* window, vtkProjectiveLight* light, vtkIdType& bytes);
  /// Gives back the screens of lights that are not among \a lights.
  void KeepScreens(const std::vector<vtkProjectiveLight*>& lights, vtkWindow* window);

  ///@{
  /// Makes what \a program reads ready for it, and gives it back.
  void Activate(vtkShaderProgram* program);
  void Deactivate();
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Screen
  {
    vtkSmartPointer<vtkTextureObject> Texture;
    vtkMTimeType Time = 0;
  };

  vtkNew<vtkTextureObject> Volume;
  vtkNew<vtkTextureObject> Mask;
  vtkNew<vtkTextureObject> Colors;
  vtkNew<vtkTextureObject> Extinctions;
  vtkNew<vtkTextureObject> ExtinctionSums;
  vtkNew<vtkTextureObject> GradientOpacities;
  vtkNew<vtkTextureObject> Transmissions;
  vtkNew<vtkTextureObject> Bends;
  /// What ExtinctionSums has yet to get.
  std::vector<float> SumTexels;
  std::map<vtkProjectiveLight*, Screen> Screens;
  std::vector<vtkTextureObject*> Active;
};

}

#endif

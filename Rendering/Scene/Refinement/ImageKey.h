// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImageKey_h
#define interlume_ImageKey_h

#include "InterlumeSceneModule.h"

#include <cstdint>
#include <vector>

class vtkAbstractVolumeMapper;
class vtkMatrix4x4;
class vtkObject;
class vtkRenderer;
class vtkVolume;

namespace interlume
{

/**
 * @class   ImageKey
 * @brief   identifies the state that determines a mapper's image of a volume
 *
 * Keys are equal only if the images are equal. A key contains the window, viewport, camera, lights,
 * the depths of opaque surfaces, and the modification times of the volume's property, the mapper
 * and its inputs.
 */
class INTERLUMESCENE_EXPORT ImageKey
{
public:
  /// Creates an empty key, which is equal only to itself.
  ImageKey() = default;
  /// Reads the state. The scene's opaque surfaces must already be drawn.
  ImageKey(vtkRenderer* renderer, vtkVolume* volume, vtkAbstractVolumeMapper* mapper);

  /// Adds the address and the modification time of an object, which may be null.
  void Add(vtkObject* object);

  bool operator==(const ImageKey& other) const
  {
    return this->Values == other.Values && this->Depths == other.Depths;
  }

private:
  void Add(const double* numbers, int count);
  void Add(vtkMatrix4x4* matrix);
  void AddView(vtkRenderer* renderer);
  void AddLights(vtkRenderer* renderer);
  void AddDepths(vtkRenderer* renderer, vtkVolume* volume);

  std::vector<std::uint64_t> Values;
  std::vector<float> Depths;
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkShaderFeatures_h
#define vtkShaderFeatures_h

#include "InterlumeSceneModule.h" // for the export macro

#include <string> // for sources

/**
 * @class   vtkShaderFeatures
 * @brief   puts the features of a shader in its source
 */
class INTERLUMESCENE_EXPORT vtkShaderFeatures
{
public:
  /**
   * Returns \a source with one `#define` for each word of \a features, a name or name=value, in the
   * place of the line `//INTERLUME::FEATURES`, and in the place of `//INTERLUME::CUTS` what cuts
   * lines to the box of a volume, to clipping planes (CLIPPING_PLANES, their number) and to regions
   * (CROPPING).
   */
  static std::string Insert(const std::string& source, const std::string& features);
};

#endif

#ifndef vtkShaderFeatures_h
#define vtkShaderFeatures_h

#include <string>

/**
 * @class   vtkShaderFeatures
 * @brief   puts the features of a shader in its source
 */
class vtkShaderFeatures
{
public:
  /**
   * \a source with one `#define` for each word of \a features in the place of the line
   * `//INTERLUME::FEATURES`.
   */
  static std::string Insert(const std::string& source, const std::string& features);
};

#endif

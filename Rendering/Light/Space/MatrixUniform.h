// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MatrixUniform_h
#define interlume_MatrixUniform_h

#include "vtkShaderProgram.h"

#include <string>

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

namespace interlume
{

/**
 * @class   MatrixUniform
 * @brief   sets a matrix of a shader, which has single precision
 */
struct MatrixUniform
{
  static void Set(vtkShaderProgram* program, const std::string& name, const glm::dmat4& matrix)
  {
    glm::mat4 rounded(matrix);
    program->SetUniformMatrix4x4(name.c_str(), glm::value_ptr(rounded));
  }
};

}

#endif

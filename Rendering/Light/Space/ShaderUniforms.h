// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ShaderUniforms_h
#define interlume_ShaderUniforms_h

#include "vtkShaderProgram.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace interlume
{

/**
 * @class   ShaderUniforms
 * @brief   sets uniforms of a shader program in single precision
 *
 * Uniforms that the program does not use are skipped.
 */
class ShaderUniforms
{
public:
  /// \a suffix is appended to all names.
  explicit ShaderUniforms(vtkShaderProgram* program, std::string suffix = {})
    : Program(program)
    , Suffix(std::move(suffix))
  {
  }

  void Set(const std::string& name, int value) const
  {
    this->Program->SetUniformi(this->GetName(name).c_str(), value);
  }
  void Set(const std::string& name, double value) const
  {
    this->Program->SetUniformf(this->GetName(name).c_str(), static_cast<float>(value));
  }
  void Set(const std::string& name, const glm::dvec2& value) const
  {
    const glm::vec2 rounded(value);
    this->Program->SetUniform2f(this->GetName(name).c_str(), glm::value_ptr(rounded));
  }
  void Set(const std::string& name, const glm::dvec3& value) const
  {
    const glm::vec3 rounded(value);
    this->Program->SetUniform3f(this->GetName(name).c_str(), glm::value_ptr(rounded));
  }
  void Set(const std::string& name, const glm::dvec4& value) const
  {
    const glm::vec4 rounded(value);
    this->Program->SetUniform4f(this->GetName(name).c_str(), glm::value_ptr(rounded));
  }
  void Set(const std::string& name, const std::array<double, 4>& value) const
  {
    this->Set(name, glm::dvec4(glm::make_vec4(value.data())));
  }
  /// \a value contains the columns of the matrix.
  void Set(const std::string& name, const std::array<double, 9>& value) const
  {
    glm::mat3 rounded(glm::make_mat3(value.data()));
    this->Program->SetUniformMatrix3x3(this->GetName(name).c_str(), glm::value_ptr(rounded));
  }
  void Set(const std::string& name, const glm::dmat4& value) const
  {
    glm::mat4 rounded(value);
    this->Program->SetUniformMatrix4x4(this->GetName(name).c_str(), glm::value_ptr(rounded));
  }

  ///@{
  /// Set an array.
  void Set(const std::string& name, const std::vector<float>& values) const
  {
    this->Program->SetUniform1fv(
      this->GetName(name).c_str(), static_cast<int>(values.size()), values.data());
  }
  void Set(const std::string& name, const std::vector<glm::vec2>& values) const
  {
    this->Program->SetUniform2fv(
      this->GetName(name).c_str(), static_cast<int>(values.size()), GetFloats(values));
  }
  void Set(const std::string& name, const std::vector<glm::vec3>& values) const
  {
    this->Program->SetUniform3fv(
      this->GetName(name).c_str(), static_cast<int>(values.size()), GetFloats(values));
  }
  void Set(const std::string& name, const std::vector<glm::vec4>& values) const
  {
    this->Program->SetUniform4fv(
      this->GetName(name).c_str(), static_cast<int>(values.size()), GetFloats(values));
  }
  void Set(const std::string& name, const std::vector<glm::mat4>& values) const
  {
    this->Program->SetUniformMatrix4x4v(this->GetName(name).c_str(),
      static_cast<int>(values.size()), const_cast<float*>(GetFloats(values)));
  }
  ///@}

private:
  std::string GetName(const std::string& name) const { return name + this->Suffix; }

  template <typename Value>
  static const float* GetFloats(const std::vector<Value>& values)
  {
    return values.empty() ? nullptr : glm::value_ptr(values.front());
  }

  vtkShaderProgram* Program;
  std::string Suffix;
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/OpenGLRasterizer.h"

#include "Frame/BoundaryShading.h"
#include "Loader/OpenGLFunctions.h"
#include "Loader/ScopedGLState.h"
#include "Offscreen/FloatTexture.h"
#include "Offscreen/SceneDepth.h"
#include "Offscreen/ShaderFeatures.h"

#include "InterlumeResolveFS.h"
#include "InterlumeSilhouette.h"
#include "InterlumeTetrahedraFS.h"
#include "InterlumeTetrahedraGS.h"
#include "InterlumeTetrahedraPullVS.h"
#include "InterlumeTetrahedraVS.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{

// Returns true if pixels store the largest scalar instead of a color. The scalar is -1 in pixels
// that no tetrahedron covers.
bool HoldsScalars(const TetrahedraFrame& frame)
{
  return frame.Blend == TetrahedraFrame::MAXIMUM && frame.Fields->Kind == TetrahedraFields::SCALARS;
}

// Computes six times the volume of each tetrahedron, in double precision before points are rounded
// to float.
std::vector<float> MakeVolumes(const TetrahedraMesh& mesh)
{
  std::vector<float> volumes(mesh.GetNumberOfTetrahedra());
  for (std::uint32_t t = 0; t < mesh.GetNumberOfTetrahedra(); ++t)
  {
    volumes[t] = static_cast<float>(mesh.GetVolumeTimesSix(t));
  }
  return volumes;
}

// Returns the points as four floats each, with w = 0.
std::vector<float> MakePoints(const TetrahedraMesh& mesh)
{
  const std::size_t points = mesh.Points.size() / 3;
  std::vector<float> values(4 * points);
  for (std::size_t p = 0; p < points; ++p)
  {
    for (int i = 0; i < 3; ++i)
    {
      values[4 * p + i] = static_cast<float>(mesh.Points[3 * p + i]);
    }
  }
  return values;
}

/// Returns true if the boundary triangles have several materials or a texture.
bool HasMaterials(const TetrahedraFrame& frame)
{
  return frame.Surface &&
    (!frame.Fields->FaceMaterials.empty() || !frame.Surface->GetImages().empty());
}

/// Returns four vectors for each material: color, coefficients, specular color and high part of the
/// texture's first pixel in MakePixels(), and low part of this pixel, width (0 without a texture),
/// height, and number of levels, negative if it is not repeated. The high part counts 4096 pixels,
/// since floats have 24 bits.
std::vector<float> MakeMaterials(const BoundaryShading& shading)
{
  std::vector<std::size_t> firsts = { 0 };
  for (const BoundaryShading::Image& image : shading.GetImages())
  {
    firsts.push_back(firsts.back() + image.GetPixels().size());
  }
  std::vector<float> values;
  for (const BoundaryShading::Material& material : shading.GetMaterials())
  {
    values.insert(values.end(), material.Base.begin(), material.Base.end());
    values.insert(values.end(), material.Coefficients.begin(), material.Coefficients.end());
    values.insert(values.end(), material.SpecularColor.begin(), material.SpecularColor.end());
    if (material.Texture < 0)
    {
      values.insert(values.end(), 5, 0.0f);
      continue;
    }
    const auto texture = static_cast<std::size_t>(material.Texture);
    const BoundaryShading::Image& image = shading.GetImages()[texture];
    values.insert(values.end(),
      { static_cast<float>(firsts[texture] / 4096), static_cast<float>(firsts[texture] % 4096),
        static_cast<float>(image.GetWidth()), static_cast<float>(image.GetHeight()),
        static_cast<float>(image.GetNumberOfLevels()) * (image.IsRepeated() ? 1.0f : -1.0f) });
  }
  return values;
}

/// Returns the pixels of all textures, and one that is not used, since a buffer must not be empty.
std::vector<BoundaryShading::Color> MakePixels(const BoundaryShading& shading)
{
  std::vector<BoundaryShading::Color> pixels;
  for (const BoundaryShading::Image& image : shading.GetImages())
  {
    pixels.insert(pixels.end(), image.GetPixels().begin(), image.GetPixels().end());
  }
  pixels.emplace_back();
  return pixels;
}

/// Maximum number of tetrahedra per draw call. The indices of their vertices, four per tetrahedron,
/// must fit in 16 bits.
constexpr int STRIPS = 1 << 14;
/// A strip of four vertices as two triangles. The provoking (last) vertex of the second triangle is
/// vertex 3.
constexpr std::array<std::uint16_t, 6> STRIP = { { 0, 1, 2, 2, 1, 3 } };

/// Returns the shader with the given features and the GLSL code that computes the silhouette.
std::string MakeSilhouetteShader(const char* shader, const std::string& features)
{
  std::string source = ShaderFeatures::Insert(shader, features);
  vtkShaderProgram::Substitute(source, "//INTERLUME::SILHOUETTE", InterlumeSilhouette);
  return source;
}

bool IsDepthSum(const TetrahedraFrame& frame)
{
  return frame.Blend == TetrahedraFrame::OPTICAL_DEPTH || frame.Blend == TetrahedraFrame::PRIORITY;
}
}

OpenGLRasterizer::OpenGLRasterizer() = default;

OpenGLRasterizer::~OpenGLRasterizer() = default;

Error OpenGLRasterizer::FindError(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame) const
{
  window->MakeCurrent();
  if (!HasOpenGL32())
  {
    return { "OpenGL 3.2 is not supported", ErrorCode::OpenGL };
  }
  GLint texels = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
  const std::size_t needed =
    std::max<std::size_t>(frame.Mesh->GetNumberOfTetrahedra(), frame.Mesh->Points.size() / 3);
  if (needed > static_cast<std::size_t>(texels))
  {
    return { "texture buffers have at most " + std::to_string(texels) +
        " texels, but the mesh needs " + std::to_string(needed),
      ErrorCode::OpenGL };
  }
  return {};
}

std::string OpenGLRasterizer::GetFeatures(const TetrahedraFrame& frame, bool hasOpaque) const
{
  const TetrahedraFields& fields = *frame.Fields;
  std::string features = fields.Kind == TetrahedraFields::SCALARS ? "SCALARS"
    : fields.Kind == TetrahedraFields::POINT_COLORS               ? "POINT_COLORS"
                                                                  : "CELL_COLORS";
  features += frame.View.IsParallel() ? "" : " PERSPECTIVE";
  features += fields.DeltaT.empty() ? "" : " DELTA_T";
  features += hasOpaque ? " OPAQUE" : "";
  features += frame.IsExact ? " EXACT" : "";
  if (frame.Surface)
  {
    features += HasMaterials(frame) ? " SURFACE SURFACE_MATERIALS" : " SURFACE";
  }
  features += frame.Order ? " ORDERED" : "";
  if (frame.Blend == TetrahedraFrame::MAXIMUM)
  {
    features += " MAXIMUM";
  }
  else
  {
    features += IsDepthSum(frame) ? "" : " OPACITY";
  }
  return features;
}

void OpenGLRasterizer::Upload(
  vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame, TetrahedraReport& report)
{
  using Changes = TetrahedraFrame::Changes;
  const TetrahedraMesh& mesh = *frame.Mesh;
  const TetrahedraFields& fields = *frame.Fields;
  const bool isSameCut = this->Planes == frame.Planes &&
    (frame.Planes.empty() || this->Uploaded.Mesh == frame.Versions.Mesh);
  const auto isNew = [&](int Changes::*part)
  { return !isSameCut || this->Uploaded.*part != frame.Versions.*part; };
  vtkIdType& bytes = report.UploadedStaticBytes;
  if (isNew(&Changes::Mesh))
  {
    bytes += this->Upload(window, "points", TextureBuffer::FLOAT4, MakePoints(mesh));
    bytes += this->Upload(window, "corners", TextureBuffer::UINT4, mesh.Corners);
    bytes += this->Upload(window, "volumes", TextureBuffer::FLOAT, MakeVolumes(mesh));
  }
  if (isNew(&Changes::Values) && !fields.DeltaT.empty())
  {
    bytes += this->Upload(window, "deltaTs", TextureBuffer::FLOAT, fields.DeltaT);
  }
  if (isNew(&Changes::Values) && fields.Kind == TetrahedraFields::SCALARS)
  {
    bytes += this->Upload(window, "scalars", TextureBuffer::FLOAT, fields.Scalars);
  }
  if (isNew(&Changes::Colors) && fields.Kind != TetrahedraFields::SCALARS)
  {
    bytes += this->Upload(window, "colors", TextureBuffer::FLOAT4, fields.Colors);
  }
  else if (isNew(&Changes::Colors))
  {
    bytes += this->Upload(window, "pieces", TextureBuffer::FLOAT4, frame.Pieces->GetPieces());
    bytes += this->Upload(window, "starts", TextureBuffer::FLOAT, frame.Pieces->GetStarts());
    bytes += this->Upload(window, "buckets", TextureBuffer::INT, frame.Pieces->GetBuckets());
  }
  if (frame.Surface &&
    (isNew(&Changes::Boundary) || isNew(&Changes::Mesh) || !this->Buffers["faces"].IsAllocated()))
  {
    bytes += this->UploadSurface(window, frame);
  }
  if (HasMaterials(frame) &&
    (isNew(&Changes::Surface) || isNew(&Changes::Boundary) ||
      !this->Buffers["surfaceMaterials"].IsAllocated()))
  {
    bytes += this->Upload(
      window, "surfaceMaterials", TextureBuffer::FLOAT4, MakeMaterials(*frame.Surface));
  }
  TextureBuffer& order = this->Buffers["order"];
  if (!frame.Order)
  {
    order.Release(window);
  }
  else if (isNew(&Changes::Order) || !order.IsAllocated())
  {
    // Blending requires back-to-front order, and layers in ascending priority.
    report.UploadedOrderBytes = this->Upload(window, "order", TextureBuffer::UINT,
      std::vector<std::uint32_t>(frame.Order->rbegin(), frame.Order->rend()));
  }
  if (frame.IsPulled && !this->Strips)
  {
    bytes += this->UploadStrips();
  }
  this->Uploaded = frame.Versions;
  this->Planes = frame.Planes;
}

template <typename Value>
vtkIdType OpenGLRasterizer::Upload(vtkOpenGLRenderWindow* window, const char* name,
  TextureBuffer::Formats format, const std::vector<Value>& values)
{
  return this->Buffers[name].Upload(window, format, values.data(), values.size() * sizeof(Value));
}

vtkIdType OpenGLRasterizer::UploadSurface(
  vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame)
{
  const TetrahedraFields& fields = *frame.Fields;
  std::vector<float> points;
  points.reserve(8 * fields.Normals.size());
  for (std::size_t p = 0; p < fields.Normals.size(); ++p)
  {
    const std::array<float, 3>& normal = fields.Normals[p];
    points.insert(points.end(), { normal[0], normal[1], normal[2], 0.0f });
    const bool has = !fields.TextureCoordinates.empty();
    points.insert(points.end(),
      { has ? fields.TextureCoordinates[p][0] : 0.0f, has ? fields.TextureCoordinates[p][1] : 0.0f,
        0.0f, 0.0f });
  }
  vtkIdType bytes = this->Upload(window, "faces", TextureBuffer::INT,
    std::vector<std::int32_t>(fields.Faces.begin(), fields.Faces.end()));
  bytes += this->Upload(window, "surfacePoints", TextureBuffer::FLOAT4, points);
  if (HasMaterials(frame))
  {
    std::vector<std::uint32_t> materials(fields.Faces.size(), 0);
    for (std::size_t t = 0; t < fields.FaceMaterials.size(); ++t)
    {
      const std::array<unsigned char, 4>& of = fields.FaceMaterials[t];
      materials[t] = of[0] | of[1] << 8 | of[2] << 16 | static_cast<std::uint32_t>(of[3]) << 24;
    }
    bytes += this->Upload(window, "faceMaterials", TextureBuffer::UINT, materials);
    bytes +=
      this->Upload(window, "surfacePixels", TextureBuffer::FLOAT4, MakePixels(*frame.Surface));
  }
  return bytes;
}

void OpenGLRasterizer::SetSurfaceUniforms(vtkShaderProgram* program, const TetrahedraFrame& frame)
{
  const BoundaryShading& shading = *frame.Surface;
  float positions[BoundaryShading::MAXIMUM_LIGHTS][4] = {};
  float colors[BoundaryShading::MAXIMUM_LIGHTS][3] = {};
  const auto lights = static_cast<int>(shading.GetLights().size());
  for (int i = 0; i < lights; ++i)
  {
    const BoundaryShading::Light& light = shading.GetLights()[i];
    std::copy_n(glm::value_ptr(light.Position), 3, positions[i]);
    positions[i][3] = light.IsPositional ? 1.0f : 0.0f;
    std::copy(light.Color.begin(), light.Color.end(), colors[i]);
  }
  program->SetUniformi("numberOfLights", lights);
  program->SetUniform4fv("lightPositions", BoundaryShading::MAXIMUM_LIGHTS, positions);
  program->SetUniform3fv("lightColors", BoundaryShading::MAXIMUM_LIGHTS, colors);
  program->SetUniform3fv("normalRows", 3, shading.GetNormalMatrix().data());
  if (HasMaterials(frame))
  {
    return;
  }
  const BoundaryShading::Material& material = shading.GetMaterials().front();
  program->SetUniform4f("surfaceColor", material.Base.data());
  program->SetUniform4f("surfaceCoefficients", material.Coefficients.data());
  program->SetUniform3f("specularColor", material.SpecularColor.data());
}

vtkIdType OpenGLRasterizer::UploadStrips()
{
  std::vector<std::uint16_t> indices;
  indices.reserve(STRIPS * STRIP.size());
  for (int i = 0; i < STRIPS; ++i)
  {
    for (const std::uint16_t corner : STRIP)
    {
      indices.push_back(static_cast<std::uint16_t>(4 * i + corner));
    }
  }
  const std::size_t bytes = indices.size() * sizeof(std::uint16_t);
  glGenBuffers(1, &this->Strips);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->Strips);
  glBufferData(
    GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), indices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  return static_cast<vtkIdType>(bytes);
}

bool OpenGLRasterizer::PrepareTarget(
  vtkOpenGLRenderWindow* window, int width, int height, bool hasLayers)
{
  FloatTexture::Allocate(window, this->Sums, width, height, 4, true);
  if (hasLayers)
  {
    FloatTexture::Allocate(window, this->Layers, width, height, 4, true);
  }
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Sums);
  this->Framebuffer->ActivateDrawBuffer(0);
  const char* status = nullptr;
  return vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_DRAW_FRAMEBUFFER, status);
}

void OpenGLRasterizer::SetUniforms(
  vtkShaderProgram* program, const TetrahedraFrame& frame, bool hasOpaque)
{
  const TetrahedraView& view = frame.View;
  const std::array<double, 12> matrix = view.GetPixelsFromMesh();
  float rows[3][4];
  for (int i = 0; i < 12; ++i)
  {
    rows[i / 4][i % 4] = static_cast<float>(matrix[i]);
  }
  program->SetUniform4fv("eyeRows", 3, rows);
  program->SetUniform2f("pixelOffset", glm::value_ptr(glm::vec2(view.GetPixelOffset())));
  const float viewport[2] = { static_cast<float>(view.GetWidth()),
    static_cast<float>(view.GetHeight()) };
  program->SetUniform2f("viewport", viewport);
  const double determinant = matrix[0] * (matrix[5] * matrix[10] - matrix[6] * matrix[9]) -
    matrix[1] * (matrix[4] * matrix[10] - matrix[6] * matrix[8]) +
    matrix[2] * (matrix[4] * matrix[9] - matrix[5] * matrix[8]);
  program->SetUniformf("volumeScale", static_cast<float>(-determinant));
  program->SetUniformf("lengthScale",
    view.IsParallel() ? static_cast<float>(view.GetViewRayLengthRatio(0.0, 0.0)) : 1.0f);
  if (!view.IsParallel() || frame.Surface)
  {
    const std::array<glm::dvec3, 2> eye = view.GetEyeFromPixels();
    const glm::vec3 coefficients[2] = { glm::vec3(eye[0]), glm::vec3(eye[1]) };
    program->SetUniform3fv("eyeOfPixel", 2, glm::value_ptr(coefficients[0]));
  }
  if (view.IsParallel() && frame.Surface)
  {
    program->SetUniform2f("tilt", glm::value_ptr(glm::vec2(view.GetTilt())));
  }
  if (hasOpaque)
  {
    const glm::vec4 depth(view.GetDepthFromBuffer());
    program->SetUniform4f("depthOfBuffer", glm::value_ptr(depth));
    program->SetUniformi("opaqueDepth", this->Depth->GetTextureUnit());
    program->SetUniformi("pixelStride", frame.PixelStride);
  }
  if (frame.Blend == TetrahedraFrame::MAXIMUM && frame.Fields->Kind != TetrahedraFields::SCALARS)
  {
    program->SetUniformf("opacityOfExtinction", static_cast<float>(1.0 / frame.ExtinctionUnit));
  }
}

void OpenGLRasterizer::Clear(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame)
{
  window->GetState()->vtkglClearColor(HoldsScalars(frame) ? -1.0f : 0.0f, 0.0f, 0.0f, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT);
}

void OpenGLRasterizer::DrawRange(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame,
  std::size_t first, std::size_t number)
{
  vtkOpenGLState* state = window->GetState();
  const bool isOver = frame.Blend == TetrahedraFrame::COMPOSITE;
  state->vtkglBlendFunc(GL_ONE, isOver ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE);
  state->vtkglBlendEquation(frame.Blend == TetrahedraFrame::MAXIMUM ? GL_MAX : GL_FUNC_ADD);
  this->Vertices->Bind();
  if (frame.IsPulled)
  {
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->Strips);
    for (std::size_t i = 0; i < number; i += STRIPS)
    {
      const std::size_t strips = std::min<std::size_t>(STRIPS, number - i);
      glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(strips * STRIP.size()),
        GL_UNSIGNED_SHORT, nullptr, static_cast<GLint>(4 * (first + i)));
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  }
  else
  {
    glDrawArrays(GL_POINTS, static_cast<GLint>(first), static_cast<GLsizei>(number));
  }
  this->Vertices->Release();
  state->vtkglBlendEquation(GL_FUNC_ADD);
}

void OpenGLRasterizer::Resolve(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame,
  vtkTextureObject* texture, bool isResolved)
{
  if (!isResolved && HoldsScalars(frame))
  {
    this->ResolveQuad.DrawWithShader(window, texture,
      ShaderFeatures::Insert(InterlumeResolveFS, "LARGEST_SCALAR"),
      [&](vtkShaderProgram* program)
      {
        this->ActivateBuffers(program);
        program->SetUniformf("opacityOfExtinction", static_cast<float>(1.0 / frame.ExtinctionUnit));
      });
    this->DeactivateBuffers();
    return;
  }
  if (!isResolved && IsDepthSum(frame))
  {
    this->ResolveQuad.DrawWithShader(
      window, texture, ShaderFeatures::Insert(InterlumeResolveFS, "OPTICAL_DEPTH"));
    return;
  }
  this->Quad.Draw(window, texture, frame.Blend == TetrahedraFrame::ADDITIVE ? "SATURATE" : "");
}

bool OpenGLRasterizer::DrawLayers(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame,
  const std::string& features, bool hasOpaque)
{
  const std::size_t number =
    frame.Order ? frame.Order->size() : frame.Mesh->GetNumberOfTetrahedra();
  if (frame.Blend != TetrahedraFrame::PRIORITY)
  {
    Clear(window, frame);
    return number == 0 || this->DrawLayer(window, frame, features, hasOpaque, 0, number);
  }
  this->Framebuffer->AddColorAttachment(0, this->Layers);
  window->GetState()->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  // The uploaded order is the reverse of frame.Order.
  const auto layer = [&](std::size_t i)
  { return frame.Fields->Layers[(*frame.Order)[number - 1 - i]]; };
  std::size_t first = 0;
  while (first < number)
  {
    std::size_t last = first + 1;
    while (last < number && layer(last) == layer(first))
    {
      ++last;
    }
    this->Framebuffer->AddColorAttachment(0, this->Sums);
    Clear(window, frame);
    if (!this->DrawLayer(window, frame, features, hasOpaque, first, last - first))
    {
      return false;
    }
    this->Framebuffer->AddColorAttachment(0, this->Layers);
    this->Resolve(window, frame, this->Sums, false);
    first = last;
  }
  return true;
}

bool OpenGLRasterizer::DrawLayer(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame,
  const std::string& features, bool hasOpaque, std::size_t first, std::size_t number)
{
  const std::string vertexShader = frame.IsPulled
    ? MakeSilhouetteShader(InterlumeTetrahedraPullVS, features)
    : ShaderFeatures::Insert(InterlumeTetrahedraVS, features);
  const std::string geometryShader =
    frame.IsPulled ? std::string() : MakeSilhouetteShader(InterlumeTetrahedraGS, features);
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(vertexShader.c_str(),
    ShaderFeatures::Insert(InterlumeTetrahedraFS, features).c_str(), geometryShader.c_str());
  if (!program)
  {
    return false;
  }
  this->ActivateBuffers(program);
  if (frame.Surface)
  {
    this->SetSurfaceUniforms(program, frame);
  }
  if (hasOpaque)
  {
    this->Depth->Activate();
  }
  this->SetUniforms(program, frame, hasOpaque);
  this->DrawRange(window, frame, first, number);
  if (hasOpaque)
  {
    this->Depth->Deactivate();
  }
  this->DeactivateBuffers();
  return true;
}

void OpenGLRasterizer::ActivateBuffers(vtkShaderProgram* program)
{
  for (auto& [name, buffer] : this->Buffers)
  {
    if (buffer.IsAllocated() && program->IsUniformUsed(name.c_str()))
    {
      buffer.Activate(program, name.c_str());
    }
  }
}

void OpenGLRasterizer::DeactivateBuffers()
{
  for (auto& [name, buffer] : this->Buffers)
  {
    buffer.Deactivate();
  }
}

Error OpenGLRasterizer::Draw(
  vtkRenderer* renderer, const TetrahedraFrame& frame, bool hasOpaque, TetrahedraReport& report)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  this->Upload(window, frame, report);
  if (hasOpaque)
  {
    this->Depth->SetContext(window);
    hasOpaque = SceneDepth::CopyTo(renderer, this->Depth);
  }
  report.Features = this->GetFeatures(frame, hasOpaque);

  // Framebuffer bindings are restored explicitly, other drawing state at the end of the block.
  state->PushFramebufferBindings();
  {
    const ScopedGLState scoped(state);
    const int width = frame.View.GetWidth();
    const int height = frame.View.GetHeight();
    const bool hasLayers = frame.Blend == TetrahedraFrame::PRIORITY;
    if (!this->PrepareTarget(window, width, height, hasLayers))
    {
      state->PopFramebufferBindings();
      return { "floating-point framebuffers are not supported", ErrorCode::OpenGL };
    }
    state->vtkglViewport(0, 0, width, height);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglEnable(GL_BLEND);
    state->vtkglDepthMask(GL_FALSE);
    if (!this->DrawLayers(window, frame, report.Features, hasOpaque))
    {
      state->PopFramebufferBindings();
      return { "the shaders cannot be compiled", ErrorCode::OpenGL };
    }
  }
  state->PopFramebufferBindings();
  const bool isResolved = frame.Blend == TetrahedraFrame::PRIORITY;
  this->Resolve(window, frame, isResolved ? this->Layers : this->Sums, isResolved);
  this->ReportBuffers(frame, hasOpaque, report);
  return {};
}

void OpenGLRasterizer::ReportBuffers(
  const TetrahedraFrame& frame, bool hasOpaque, TetrahedraReport& report)
{
  const vtkIdType sums = frame.Blend == TetrahedraFrame::PRIORITY ? 2 : 1;
  const vtkIdType pixels = static_cast<vtkIdType>(frame.View.GetWidth()) * frame.View.GetHeight();
  report.Buffers = static_cast<int>(sums) + (hasOpaque ? 1 : 0);
  report.BufferBytes = 16 * pixels * sums + (hasOpaque ? 4 * pixels : 0);
  for (const auto& [name, buffer] : this->Buffers)
  {
    report.BufferBytes += static_cast<vtkIdType>(buffer.GetBytes());
  }
  report.BufferBytes +=
    this->Strips ? static_cast<vtkIdType>(STRIPS * STRIP.size() * sizeof(std::uint16_t)) : 0;
}

void OpenGLRasterizer::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& [name, buffer] : this->Buffers)
  {
    buffer.Release(window);
  }
  this->Uploaded = NONE;
  if (this->Strips)
  {
    glDeleteBuffers(1, &this->Strips);
    this->Strips = 0;
  }
  this->Sums->ReleaseGraphicsResources(window);
  this->Layers->ReleaseGraphicsResources(window);
  this->Depth->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Vertices->ReleaseGraphicsResources();
  this->Quad.ReleaseGraphicsResources(window);
  this->ResolveQuad.ReleaseGraphicsResources(window);
}

}

// SPDX-License-Identifier: BSD-3-Clause
// Tests that rendering restores the OpenGL state for reading and writing pixels. The test then
// reads an RGB image of odd width, whose row length in bytes is not a multiple of four.
#include "Support/Drawing/ImageCases.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Tetrahedra/MapperImage.h"

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "Loader/OpenGLFunctions.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <map>
#include <string>

namespace
{

using namespace reference;

const std::map<std::string, GLenum> STATES = { { "pack alignment", GL_PACK_ALIGNMENT },
  { "pack row length", GL_PACK_ROW_LENGTH }, { "unpack alignment", GL_UNPACK_ALIGNMENT },
  { "unpack row length", GL_UNPACK_ROW_LENGTH },
  { "framebuffer to read", GL_READ_FRAMEBUFFER_BINDING },
  { "framebuffer to draw to", GL_DRAW_FRAMEBUFFER_BINDING } };

std::map<std::string, GLint> GetStates(vtkRenderWindow* window)
{
  window->Render();
  window->MakeCurrent();
  std::map<std::string, GLint> values;
  for (const auto& state : STATES)
  {
    glGetIntegerv(state.second, &values[state.first]);
  }
  return values;
}

}

int TestTetrahedraMapperState(int, char*[])
{
  Check check;
  for (int path : AllRenderPaths())
  {
    check.SetContext(GetPathName(path));
    vtkNew<vtkCubeSource> cube;
    cube->SetCenter(0.5, 0.5, 0.5);
    cube->SetXLength(0.3);
    vtkNew<vtkPolyDataMapper> cubeMapper;
    cubeMapper->SetInputConnection(cube->GetOutputPort());
    vtkNew<vtkActor> opaque;
    opaque->SetMapper(cubeMapper);
    vtkNew<vtkRenderer> renderer;
    renderer->AddActor(opaque);
    vtkNew<vtkRenderWindow> window;
    window->OffScreenRenderingOn();
    window->SetMultiSamples(0);
    window->SetSize(101, 75);
    window->AddRenderer(renderer);
    const std::map<std::string, GLint> before = GetStates(window);

    ImageCase what;
    what.Grid = MakeCube(4);
    vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
    Configure(mapper, what);
    mapper->SetRenderPath(path);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    volume->SetProperty(MakeRamp(0.1, 1.0, 0.25));
    renderer->AddVolume(volume);
    const std::map<std::string, GLint> after = GetStates(window);
    check.That(mapper->GetReport()->GetNumber("TetrahedraDrawn") > 0, "the volume is drawn");
    for (const auto& state : before)
    {
      check.Equal(after.at(state.first), state.second, state.first);
    }
  }
  return check.Result();
}

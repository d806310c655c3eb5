// SPDX-License-Identifier: BSD-3-Clause
#include "Offscreen/PeelingDeferral.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkCommand.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

namespace interlume
{

namespace
{
bool IsPeeled(vtkVolume* volume)
{
  vtkInformation* keys = volume->GetPropertyKeys();
  const int passes = keys && keys->Has(vtkOpenGLRenderPass::RenderPasses())
    ? keys->Length(vtkOpenGLRenderPass::RenderPasses())
    : 0;
  for (int i = 0; i < passes; ++i)
  {
    if (vtkDualDepthPeelingPass::SafeDownCast(keys->Get(vtkOpenGLRenderPass::RenderPasses(), i)))
    {
      return true;
    }
  }
  return false;
}

// Draws the volume at the end of the frame.
class EndCommand : public vtkCommand
{
public:
  static EndCommand* New();
  vtkTypeMacro(EndCommand, vtkCommand);

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    auto* renderer = vtkRenderer::SafeDownCast(caller);
    if (this->Mapper && this->Volume && renderer)
    {
      this->Mapper->Render(renderer, this->Volume);
    }
  }

  vtkWeakPointer<vtkAbstractVolumeMapper> Mapper;
  vtkWeakPointer<vtkVolume> Volume;
};
vtkStandardNewMacro(EndCommand);
}

PeelingDeferral::~PeelingDeferral()
{
  this->RemoveObserver();
}

void PeelingDeferral::RemoveObserver()
{
  if (this->Renderer && this->Tag > 0)
  {
    this->Renderer->RemoveObserver(this->Tag);
  }
  this->Tag = 0;
}

bool PeelingDeferral::Defer(
  vtkAbstractVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  // Register one command for all peels of a frame, and none without peeling.
  this->RemoveObserver();
  if (!IsPeeled(volume))
  {
    return false;
  }
  vtkNew<EndCommand> command;
  command->Mapper = mapper;
  command->Volume = volume;
  this->Renderer = renderer;
  this->Tag = renderer->AddObserver(vtkCommand::EndEvent, command);
  if (!this->HasWarned)
  {
    vtkWarningWithObjectMacro(mapper,
      << "UseDepthPeelingForVolumes is not supported and is ignored: the volume is drawn over "
         "translucent polygons. Turn off UseDepthPeelingForVolumes to avoid this warning.");
    this->HasWarned = true;
  }
  return true;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "pqSourceCells.h"

#include "pqActiveObjects.h"
#include "pqCoreUtilities.h"
#include "pqOutputPort.h"
#include "pqPVApplicationCore.h"
#include "pqPipelineFilter.h"
#include "pqSelectionManager.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "pqTimeKeeper.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPVDataMover.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkSelectionNode.h"

#include <QAction>
#include <QMessageBox>

#include <array>
#include <set>
#include <vector>

namespace
{
/// Composite index (0 if not composite), process and id of a cell.
using CellIndex = std::array<vtkIdType, 3>;

struct SourceCells
{
  std::set<CellIndex> Cells;
  bool IsComposite = false;

  /// Adds the source cells of the selected cells of a process.
  void Add(vtkDataObject* selected, int process)
  {
    auto* composite = vtkCompositeDataSet::SafeDownCast(selected);
    if (!composite)
    {
      this->AddBlock(selected, 0, process);
      return;
    }
    this->IsComposite = true;
    const auto block = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
    {
      this->AddBlock(block->GetCurrentDataObject(), block->GetCurrentFlatIndex(), process);
    }
  }

  void AddBlock(vtkDataObject* data, vtkIdType block, int process)
  {
    auto* grid = vtkDataSet::SafeDownCast(data);
    auto* origins =
      grid ? vtkIdTypeArray::SafeDownCast(grid->GetCellData()->GetArray("OriginCell")) : nullptr;
    for (vtkIdType i = 0; origins && i < origins->GetNumberOfValues(); ++i)
    {
      this->Cells.insert({ { block, process, origins->GetValue(i) } });
    }
  }
};

/// Returns a selected output of a filter that can generate origins, or null.
pqOutputPort* FindSelectedPort()
{
  // The selection manager does not list selections of Python scripts.
  const auto filters =
    pqApplicationCore::instance()->getServerManagerModel()->findItems<pqPipelineFilter*>();
  for (const pqPipelineFilter* filter : filters)
  {
    for (pqOutputPort* port : filter->getOutputPorts())
    {
      if (filter->getAnyInput() && filter->getProxy()->GetProperty("GenerateOriginArrays") &&
        port->getSelectionInput())
      {
        return port;
      }
    }
  }
  return nullptr;
}

/// Fetches the cells that are selected in an output.
SourceCells FetchSourceCells(pqOutputPort* port)
{
  vtkSMSourceProxy* selected = port->getSourceProxy()->GetSelectionOutput(port->getPortNumber());
  selected->UpdatePipeline(port->getServer()->getTimeKeeper()->getTime());
  const auto mover = vtkSmartPointer<vtkSMProxy>::Take(
    selected->GetSessionProxyManager()->NewProxy("misc", "DataMover"));
  vtkSMPropertyHelper(mover, "Producer").Set(selected);
  vtkSMPropertyHelper(mover, "PortNumber").Set(0);
  vtkSMPropertyHelper(mover, "SkipEmptyDataSets").Set(1);
  mover->UpdateVTKObjects();
  mover->InvokeCommand("Execute");
  auto* moved = vtkPVDataMover::SafeDownCast(mover->GetClientSideObject());
  SourceCells cells;
  for (unsigned int i = 0; i < moved->GetNumberOfDataSets(); ++i)
  {
    cells.Add(moved->GetDataSetAtIndex(i), moved->GetDataSetRank(i));
  }
  return cells;
}

/// Selects cells in an output.
void Select(pqOutputPort* port, const SourceCells& source)
{
  std::vector<vtkIdType> ids;
  for (const CellIndex& cell : source.Cells)
  {
    ids.insert(ids.end(), cell.begin() + (source.IsComposite ? 0 : 1), cell.end());
  }
  vtkSMSessionProxyManager* manager = port->getSourceProxy()->GetSessionProxyManager();
  const auto selection =
    vtkSmartPointer<vtkSMSourceProxy>::Take(vtkSMSourceProxy::SafeDownCast(manager->NewProxy(
      "sources", source.IsComposite ? "CompositeDataIDSelectionSource" : "IDSelectionSource")));
  vtkSMPropertyHelper(selection, "FieldType").Set(vtkSelectionNode::CELL);
  vtkSMPropertyHelper(selection, "IDs").Set(ids.data(), static_cast<unsigned int>(ids.size()));
  selection->UpdateVTKObjects();
  const auto appended = vtkSmartPointer<vtkSMSourceProxy>::Take(vtkSMSourceProxy::SafeDownCast(
    vtkSMSelectionHelper::NewAppendSelectionsFromSelectionSource(selection)));
  port->setSelectionInput(appended, 0);
  pqPVApplicationCore::instance()->selectionManager()->select(port);
}

/// Shows the outline of hidden data.
void ShowOutline(pqOutputPort* port)
{
  const pqView* view = pqActiveObjects::instance().activeView();
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  vtkSMSourceProxy* source = port->getSourceProxy();
  const int number = port->getPortNumber();
  if (view && !controller->GetVisibility(source, number, view->getViewProxy()))
  {
    vtkSMProxy* display = controller->Show(source, number, view->getViewProxy());
    vtkSMRepresentationProxy::SetRepresentationType(display, "Outline");
  }
}
}

pqSourceCells::pqSourceCells(QObject* parent)
  : Superclass(parent)
{
  auto* action = new QAction(tr("Select Source Cells"), this);
  action->setObjectName("actionSelectSourceCells");
  action->setToolTip(tr("Select the cells of the input that contain the selected cells"));
  this->addAction(action);
  QObject::connect(action, &QAction::triggered, this, &pqSourceCells::select);
}

pqSourceCells::~pqSourceCells() = default;

void pqSourceCells::select()
{
  pqOutputPort* port = FindSelectedPort();
  const SourceCells source = port ? FetchSourceCells(port) : SourceCells();
  if (source.Cells.empty())
  {
    QMessageBox box(QMessageBox::Information, tr("Select Source Cells"),
      port
        ? tr("The selected cells have no array OriginCell. Turn on Generate Origin Arrays of %1, "
             "press Apply, and select cells.")
            .arg(port->getSource()->getSMName())
        : tr("Select cells in the output of an Interval Volume first."),
      QMessageBox::Ok, pqCoreUtilities::mainWidget());
    box.setObjectName("SourceCellsMessage");
    box.exec();
    return;
  }
  pqOutputPort* input = qobject_cast<pqPipelineFilter*>(port->getSource())->getAnyInput();
  BEGIN_UNDO_SET(tr("Select Source Cells"));
  ShowOutline(input);
  END_UNDO_SET();
  SCOPED_UNDO_EXCLUDE();
  port->getSourceProxy()->CleanSelectionInputs(port->getPortNumber());
  Select(input, source);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "pqSourceCells.h"

#include "pqCoreUtilities.h"
#include "pqOutputPort.h"
#include "pqPVApplicationCore.h"
#include "pqPipelineFilter.h"
#include "pqSelectionManager.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkIdTypeArray.h"
#include "vtkPVDataMover.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSelectionNode.h"

#include <QMainWindow>
#include <QStatusBar>

#include <array>
#include <set>
#include <vector>

namespace
{
/// Composite index, process and id of a cell.
using CellIndex = std::array<vtkIdType, 3>;

void AddOrigins(vtkDataObject* data, vtkIdType block, int process, std::set<CellIndex>& cells)
{
  auto* grid = vtkDataSet::SafeDownCast(data);
  auto* origins =
    grid ? vtkIdTypeArray::SafeDownCast(grid->GetCellData()->GetArray("OriginCell")) : nullptr;
  for (vtkIdType i = 0; origins && i < origins->GetNumberOfValues(); ++i)
  {
    cells.insert({ { block, process, origins->GetValue(i) } });
  }
}

/// Adds the source cells of the selected cells. Returns true if the data are composite.
bool AddBlocks(vtkDataObject* data, int process, std::set<CellIndex>& cells)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    AddOrigins(data, 0, process, cells);
    return false;
  }
  const auto block = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
  {
    AddOrigins(block->GetCurrentDataObject(), block->GetCurrentFlatIndex(), process, cells);
  }
  return true;
}

bool SelectsCells(vtkSMSourceProxy* selection)
{
  vtkSMPropertyHelper inputs(selection, "Input");
  for (unsigned int i = 0; i < inputs.GetNumberOfElements(); ++i)
  {
    vtkSMProperty* type = inputs.GetAsProxy(i)->GetProperty("FieldType");
    if (!type || vtkSMPropertyHelper(type).GetAsInt() != vtkSelectionNode::CELL)
    {
      return false;
    }
  }
  return true;
}
}

pqSourceCells::pqSourceCells(QObject* parent)
  : Superclass(parent)
{
}

pqSourceCells::~pqSourceCells() = default;

void pqSourceCells::startup()
{
  QObject::connect(pqPVApplicationCore::instance()->selectionManager(),
    &pqSelectionManager::selectionChanged, this, &pqSourceCells::update);
}

void pqSourceCells::shutdown()
{
  if (pqPVApplicationCore* core = pqPVApplicationCore::instance())
  {
    QObject::disconnect(core->selectionManager(), nullptr, this, nullptr);
  }
}

void pqSourceCells::clear()
{
  if (this->Source)
  {
    this->Source->setSelectionInput(nullptr, 0);
    this->Source->renderAllViews(false);
    this->Source = nullptr;
  }
}

void pqSourceCells::update(pqOutputPort* port)
{
  if (this->IsUpdating)
  {
    return;
  }
  this->IsUpdating = true;
  if (port != this->Source)
  {
    this->clear();
  }
  auto* filter = port ? qobject_cast<pqPipelineFilter*>(port->getSource()) : nullptr;
  vtkSMSourceProxy* selection = port ? port->getSelectionInput() : nullptr;
  if (filter && filter->getProxy()->GetProperty("GenerateOriginArrays") && selection &&
    SelectsCells(selection))
  {
    this->Source = filter->getAnyInput();
    if (const auto cells = makeSelection(port))
    {
      this->Source->setSelectionInput(cells, 0);
      this->Source->renderAllViews(false);
    }
    else if (auto* window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget()))
    {
      window->statusBar()->showMessage(
        tr("To select the source cells as well, turn on Generate Origin Arrays of this filter."),
        8000);
    }
  }
  this->IsUpdating = false;
}

vtkSmartPointer<vtkSMSourceProxy> pqSourceCells::makeSelection(pqOutputPort* port)
{
  vtkSMSourceProxy* tetrahedra = port->getSourceProxy();
  vtkSMSourceProxy* extract = tetrahedra->GetSelectionOutput(port->getPortNumber());
  vtkSMSessionProxyManager* manager = tetrahedra->GetSessionProxyManager();
  const auto mover = vtkSmartPointer<vtkSMProxy>::Take(manager->NewProxy("misc", "DataMover"));
  extract->UpdatePipeline();
  vtkSMPropertyHelper(mover, "Producer").Set(extract);
  vtkSMPropertyHelper(mover, "PortNumber").Set(0);
  vtkSMPropertyHelper(mover, "SkipEmptyDataSets").Set(1);
  mover->UpdateVTKObjects();
  mover->InvokeCommand("Execute");
  auto* moved = vtkPVDataMover::SafeDownCast(mover->GetClientSideObject());
  std::set<CellIndex> cells;
  bool isComposite = false;
  for (unsigned int i = 0; i < moved->GetNumberOfDataSets(); ++i)
  {
    isComposite = AddBlocks(moved->GetDataSetAtIndex(i), moved->GetDataSetRank(i), cells);
  }
  if (cells.empty())
  {
    return nullptr;
  }
  std::vector<vtkIdType> ids;
  for (const CellIndex& cell : cells)
  {
    ids.insert(ids.end(), cell.begin() + (isComposite ? 0 : 1), cell.end());
  }
  const auto source =
    vtkSmartPointer<vtkSMSourceProxy>::Take(vtkSMSourceProxy::SafeDownCast(manager->NewProxy(
      "sources", isComposite ? "CompositeDataIDSelectionSource" : "IDSelectionSource")));
  vtkSMPropertyHelper(source, "FieldType").Set(vtkSelectionNode::CELL);
  vtkSMPropertyHelper(source, "IDs").Set(ids.data(), static_cast<unsigned int>(ids.size()));
  source->UpdateVTKObjects();
  return vtkSmartPointer<vtkSMSourceProxy>::Take(vtkSMSourceProxy::SafeDownCast(
    vtkSMSelectionHelper::NewAppendSelectionsFromSelectionSource(source)));
}

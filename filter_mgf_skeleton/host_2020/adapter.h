// SPDX-License-Identifier: GPL-3.0-or-later
// The plugin as MeshLab 2020.09 loads it.
#pragma once

#include <QObject>
#include <memory>

#include "filter_mgf_skeleton/filter.h"
#include "host_headers.h"

/// Offers every filter of `all_filters()` to MeshLab; a filter's id is its position there.
class MgfSkeletonPlugin : public QObject, public MeshFilterInterface {
  Q_OBJECT
  MESHLAB_PLUGIN_IID_EXPORTER(MESH_FILTER_INTERFACE_IID)
  Q_INTERFACES(MeshFilterInterface)

 public:
  MgfSkeletonPlugin();

  QString pluginName() const override;
  QString filterName(FilterIDType id) const override;
  QString filterInfo(FilterIDType id) const override;
  FilterClass getClass(QAction* action) override;
  int getPreConditions(QAction* action) const override;
  int postCondition(QAction* action) const override;
  FILTER_ARITY filterArity(QAction* action) const override;
  void initParameterSet(QAction* action, MeshDocument& document, RichParameterList& list) override;
  bool applyFilter(QAction* action, MeshDocument& document, const RichParameterList& list,
                   vcg::CallBackPos* callback) override;

 private:
  const mgf::plugin::Filter& filter(QAction* action) const;
  bool fail(const mgf::plugin::Failure& failure);
  bool apply(const mgf::plugin::Filter& filter, MeshDocument& document,
             const RichParameterList& list, vcg::CallBackPos* callback);
  void log(const mgf::plugin::FilterOutput& output);

  std::shared_ptr<mgf::plugin::Workbench> workbench_ = mgf::plugin::make_workbench();
  bool running_ = false;  ///< the progress callback lets the user start a filter within a filter
};

// SPDX-License-Identifier: GPL-3.0-or-later
// Brings the driver into any Qt 5 program, unchanged: QT_QPA_GENERIC_PLUGINS=meshlab_driver with
// QT_PLUGIN_PATH, MESHLAB_DRIVER_SCRIPT and MESHLAB_DRIVER_TRANSCRIPT set.
#include <QGenericPlugin>

#include "meshlab_driver.h"

class DriverPlugin : public QGenericPlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID QGenericPluginFactoryInterface_iid FILE "meshlab_driver.json")

 public:
  QObject* create(const QString& /*key*/, const QString& /*specification*/) override {
    return new mgf::driver::MeshlabDriver(qEnvironmentVariable("MESHLAB_DRIVER_SCRIPT"),
                                          qEnvironmentVariable("MESHLAB_DRIVER_TRANSCRIPT"));
  }
};

#include "driver_plugin.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Does in MeshLab's window what a user would do, command by command, and writes down what it sees.
// It knows widgets by what stands on them, never by their place, and no type of MeshLab's own.
#pragma once

#include <QFile>
#include <QJsonObject>
#include <QObject>
#include <QStringList>
#include <QTimer>

class QAction;
class QDockWidget;
class QMessageBox;
class QPushButton;
class QTreeWidget;
class QWidget;

namespace mgf::driver {

/// Runs the commands of a script, one a line, words separated by tabs:
///
///   wait_layers N         until MeshLab shows N layers
///   filters               the names in the Filters menu
///   start FILTER          chooses a filter of the menu
///   dialog                title, help and parameter labels of the open filter dialog
///   set LABEL VALUE       fills in a parameter
///   apply                 clicks Apply and waits for the filter to end
///   apply_twice           the same, and clicks Apply once more while the filter runs
///   close                 closes the filter dialog
///   layers                the names of the layers
///   log                   the text of the log
///   select NAME           makes a layer the current one
///   show NAME...          makes these layers visible, and only them
///   action TEXT [TIMES]   triggers any other action of the window
///   zoom STEPS            turns the mouse wheel over the view
///   grab FILE             saves what the three-dimensional view shows
///   quit
///
/// Each command leaves a line of JSON in the transcript, {"command": ..., "ok": true, ...}, with
/// what it saw or, when it failed, "error". Message boxes are written down, {"box": text}, and
/// closed.
class MeshlabDriver : public QObject {
 public:
  MeshlabDriver(const QString& script_file, const QString& transcript_file);

 private:
  void run_next_command();
  void fill_screen() const;
  void close_message_box();
  /// Carries out a command; false: not yet possible, try again. Throws std::runtime_error.
  bool run(const QStringList& words, QJsonObject& seen);
  void write(const QJsonObject& line);

  void start_filter(const QString& name);
  void set_parameter(const QString& label, const QString& value);
  void select_layer(const QString& name);
  void show_layers(const QStringList& names);
  void zoom(int steps);
  void grab(const QString& file);

  QWidget* main_window() const;
  QDockWidget* filter_dialog() const;
  QPushButton* button(const QString& text) const;  ///< of the filter dialog
  QWidget* view() const;
  QTreeWidget* layer_tree() const;
  QStringList layer_names() const;
  QList<QAction*> filter_actions() const;

  QList<QStringList> commands_;
  QFile transcript_;
  QTimer command_timer_;
  QTimer box_timer_;
  int waited_ = 0;
  bool busy_ = false;
};

}  // namespace mgf::driver

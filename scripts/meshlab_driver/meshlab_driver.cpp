// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_driver.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QTextDocumentFragment>
#include <QTreeWidget>
#include <QWheelEvent>
#include <stdexcept>

namespace mgf::driver {
namespace {

constexpr int kTickMilliseconds = 50;
constexpr int kPatienceMilliseconds = 60000;

[[noreturn]] void fail(const QString& message) {
  throw std::runtime_error(message.toStdString());
}

/// What the user reads: without the mnemonics of menus and the tags of rich text.
QString plain(QString text) {
  if (Qt::mightBeRichText(text)) text = QTextDocumentFragment::fromHtml(text).toPlainText();
  return text.remove('&').simplified();
}

QList<QStringList> read_commands(const QString& script_file) {
  QFile file(script_file);
  QList<QStringList> commands;
  if (!file.open(QIODevice::ReadOnly | QIODevice::Text)) return commands;
  const QStringList lines = QString::fromUtf8(file.readAll()).split('\n');
  for (const QString& line : lines)
    if (!line.isEmpty()) commands.push_back(line.split('\t'));
  return commands;
}

/// All actions of a menu and its submenus that do something.
QList<QAction*> leaf_actions(const QMenu* menu) {
  QList<QAction*> leaves;
  const QList<QAction*> actions = menu->actions();
  for (QAction* action : actions) {
    if (action->menu() != nullptr) {
      leaves += leaf_actions(action->menu());
    } else if (!action->isSeparator() && !action->text().isEmpty()) {
      leaves.push_back(action);
    }
  }
  return leaves;
}

/// The cell of a grid right of the label with this text; none if there is no such label.
QLayoutItem* cell_beside(const QWidget* parent, const QString& label_text) {
  const QList<QGridLayout*> grids = parent->findChildren<QGridLayout*>();
  for (QGridLayout* grid : grids) {
    for (int row = 0; row < grid->rowCount(); ++row) {
      QLayoutItem* cell = grid->itemAtPosition(row, 0);
      const QLabel* label = cell != nullptr ? qobject_cast<QLabel*>(cell->widget()) : nullptr;
      if (label != nullptr && plain(label->text()) == label_text)
        return grid->itemAtPosition(row, 1);
    }
  }
  return nullptr;
}

/// The first widget in a cell that takes a value: the cell may hold a layout of several.
QWidget* input_widget(QLayoutItem* cell) {
  if (cell->widget() != nullptr) return cell->widget();
  QLayout* layout = cell->layout();
  for (int i = 0; layout != nullptr && i < layout->count(); ++i) {
    QWidget* widget = layout->itemAt(i)->widget();
    if (widget != nullptr && qobject_cast<QLabel*>(widget) == nullptr) return widget;
  }
  return nullptr;
}

void enter(QWidget* widget, const QString& value) {
  if (auto* line = qobject_cast<QLineEdit*>(widget)) {
    line->setText(value);
    Q_EMIT line->editingFinished();
  } else if (auto* spin = qobject_cast<QDoubleSpinBox*>(widget)) {
    spin->setValue(value.toDouble());
  } else if (auto* combo = qobject_cast<QComboBox*>(widget)) {
    const int index = combo->findText(value);
    if (index < 0) fail("no choice '" + value + "'");
    combo->setCurrentIndex(index);
  } else {
    fail("the parameter has no field that this driver knows");
  }
}

constexpr int kEyeColumn = 0;
constexpr int kNameColumn = 2;
const QLatin1String kModifiedMark(" *");  // behind the name of a layer that was changed

/// Whether a layer is shown; its eye is all that tells.
bool is_visible(const QTreeWidgetItem* item) {
  const QSize size(16, 16);
  const QIcon open_eye(":/images/layer_eye_open.png");
  return item->icon(kEyeColumn).pixmap(size).toImage() == open_eye.pixmap(size).toImage();
}

void press(QTreeWidget* tree, int row, int column) {
  Q_EMIT tree->itemPressed(tree->topLevelItem(row), column);
}

}  // namespace

MeshlabDriver::MeshlabDriver(const QString& script_file, const QString& transcript_file)
    : commands_(read_commands(script_file)), transcript_(transcript_file) {
  if (!transcript_.open(QIODevice::WriteOnly | QIODevice::Truncate)) return;
  connect(&command_timer_, &QTimer::timeout, this, &MeshlabDriver::run_next_command);
  connect(&box_timer_, &QTimer::timeout, this, &MeshlabDriver::close_message_box);
  command_timer_.start(kTickMilliseconds);
  box_timer_.start(kTickMilliseconds);
}

void MeshlabDriver::write(const QJsonObject& line) {
  transcript_.write(QJsonDocument(line).toJson(QJsonDocument::Compact) + '\n');
  transcript_.flush();
}

/// A filter runs, and a modal box waits, inside `apply`, with the timers ticking: hence `busy_`.
void MeshlabDriver::run_next_command() {
  if (busy_ || commands_.isEmpty() || main_window() == nullptr) return;
  if (QApplication::activeModalWidget() != nullptr) return;
  busy_ = true;
  fill_screen();
  const QStringList words = commands_.first();
  QJsonObject seen{{"command", words.join(' ')}, {"ok", true}};
  bool done = true;
  try {
    done = run(words, seen);
    if (!done && (waited_ += kTickMilliseconds) > kPatienceMilliseconds) fail("waited in vain");
  } catch (const std::exception& error) {
    done = true;
    seen["ok"] = false;
    seen["error"] = QString::fromUtf8(error.what());
  }
  if (done) {
    waited_ = 0;
    commands_.removeFirst();
    write(seen);
  }
  busy_ = false;
}

/// There may be no window manager that would maximise the window.
void MeshlabDriver::fill_screen() const {
  const QRect screen = QGuiApplication::primaryScreen()->geometry();
  if (main_window()->geometry() != screen) main_window()->setGeometry(screen);
}

void MeshlabDriver::close_message_box() {
  auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
  if (box == nullptr) return;
  write({{"box", plain(box->text())}});
  box->accept();
}

bool MeshlabDriver::run(const QStringList& words, QJsonObject& seen) {
  const QString& command = words.first();
  const QString argument = words.value(1);
  if (command == "wait_layers") return layer_names().size() == argument.toInt();
  if (command == "filters") {
    QJsonArray names;
    const QList<QAction*> actions = filter_actions();
    for (const QAction* action : actions) names.push_back(plain(action->text()));
    seen["filters"] = names;
  } else if (command == "start") {
    start_filter(argument);
  } else if (command == "dialog") {
    const QDockWidget* dialog = filter_dialog();
    if (dialog == nullptr) fail("no filter dialog is open");
    seen["title"] = dialog->windowTitle();
    QJsonArray texts;
    const QList<QLabel*> labels = dialog->findChildren<QLabel*>();
    for (const QLabel* label : labels) texts.push_back(plain(label->text()));
    seen["labels"] = texts;
  } else if (command == "set") {
    set_parameter(argument, words.value(2));
  } else if (command == "apply") {
    button("Apply")->click();
  } else if (command == "apply_twice") {
    // Comes due when the filter first lets events through.
    QTimer::singleShot(0, button("Apply"), &QPushButton::click);
    button("Apply")->click();
  } else if (command == "close") {
    button("Close")->click();
  } else if (command == "layers") {
    seen["layers"] = QJsonArray::fromStringList(layer_names());
  } else if (command == "log") {
    const auto* log = main_window()->findChild<QPlainTextEdit*>("logPlainTextEdit");
    if (log == nullptr) fail("there is no log");
    seen["log"] = log->toPlainText();
  } else if (command == "select") {
    select_layer(argument);
  } else if (command == "show") {
    show_layers(words.mid(1));
  } else if (command == "action") {
    const QList<QAction*> actions = main_window()->findChildren<QAction*>();
    QAction* found = nullptr;
    for (QAction* action : actions)
      if (found == nullptr && plain(action->text()) == argument) found = action;
    if (found == nullptr) fail("no action '" + argument + "'");
    for (int times = qMax(1, words.value(2).toInt()); times > 0; --times) found->trigger();
  } else if (command == "zoom") {
    zoom(argument.toInt());
  } else if (command == "grab") {
    grab(argument);
  } else if (command == "quit") {
    QMetaObject::invokeMethod(qApp, "quit", Qt::QueuedConnection);
  } else {
    fail("no such command");
  }
  return true;
}

void MeshlabDriver::start_filter(const QString& name) {
  const QList<QAction*> actions = filter_actions();
  for (QAction* action : actions) {
    if (plain(action->text()) != name) continue;
    action->trigger();
    return;
  }
  fail("no filter '" + name + "' in the menu");
}

void MeshlabDriver::set_parameter(const QString& label, const QString& value) {
  const QDockWidget* dialog = filter_dialog();
  if (dialog == nullptr) fail("no filter dialog is open");
  const QList<QCheckBox*> boxes = dialog->findChildren<QCheckBox*>();
  for (QCheckBox* box : boxes) {
    if (plain(box->text()) == label) {
      box->setChecked(value == "true");
      return;
    }
  }
  QLayoutItem* cell = cell_beside(dialog, label);
  QWidget* widget = cell != nullptr ? input_widget(cell) : nullptr;
  if (widget == nullptr) fail("no parameter '" + label + "' in the dialog");
  enter(widget, value);
}

QPushButton* MeshlabDriver::button(const QString& text) const {
  const QDockWidget* dialog = filter_dialog();
  if (dialog == nullptr) fail("no filter dialog is open");
  const QList<QPushButton*> buttons = dialog->findChildren<QPushButton*>();
  for (QPushButton* button : buttons)
    if (plain(button->text()) == text) return button;
  fail("the dialog has no button '" + text + "'");
}

void MeshlabDriver::show_layers(const QStringList& names) {
  QTreeWidget* tree = layer_tree();
  const QStringList layers = layer_names();
  for (const QString& name : names)
    if (!layers.contains(name)) fail("no layer '" + name + "'");
  for (int i = 0; i < layers.size(); ++i)
    if (names.contains(layers[i]) != is_visible(tree->topLevelItem(i))) press(tree, i, kEyeColumn);
}

void MeshlabDriver::select_layer(const QString& name) {
  const int row = layer_names().indexOf(name);
  if (row < 0) fail("no layer '" + name + "'");
  press(layer_tree(), row, kNameColumn);
}

/// The three-dimensional view.
QWidget* MeshlabDriver::view() const {
  const QList<QWidget*> widgets = main_window()->findChildren<QWidget*>();
  for (QWidget* widget : widgets)
    if (widget->inherits("GLArea") && widget->isVisible()) return widget;
  fail("there is no three-dimensional view");
}

/// Each step comes nearer by a notch of the mouse wheel.
void MeshlabDriver::zoom(int steps) {
  constexpr int kNotch = 120;  // Qt's eighths of a degree
  const QPointF middle = view()->rect().center();
  for (; steps > 0; --steps) {
    QWheelEvent event(middle, view()->mapToGlobal(middle.toPoint()), QPoint(), QPoint(0, -kNotch),
                      Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(view(), &event);
  }
}

void MeshlabDriver::grab(const QString& file) {
  const QPoint corner = view()->mapToGlobal(QPoint(0, 0));
  const QPixmap picture = QGuiApplication::primaryScreen()->grabWindow(
      0, corner.x(), corner.y(), view()->width(), view()->height());
  if (!picture.save(file)) fail("can't write '" + file + "'");
}

QWidget* MeshlabDriver::main_window() const {
  const QWidgetList windows = QApplication::topLevelWidgets();
  for (QWidget* window : windows)
    if (qobject_cast<QMainWindow*>(window) != nullptr && window->isVisible()) return window;
  return nullptr;
}

QDockWidget* MeshlabDriver::filter_dialog() const {
  const QList<QDockWidget*> docks = main_window()->findChildren<QDockWidget*>();
  for (QDockWidget* dock : docks)
    if (dock->inherits("MeshlabStdDialog") && dock->isVisible()) return dock;
  return nullptr;
}

QTreeWidget* MeshlabDriver::layer_tree() const {
  return main_window()->findChild<QTreeWidget*>("meshTreeWidget");
}

QStringList MeshlabDriver::layer_names() const {
  QStringList names;
  const QTreeWidget* tree = layer_tree();
  for (int i = 0; tree != nullptr && i < tree->topLevelItemCount(); ++i) {
    QString name = tree->topLevelItem(i)->text(kNameColumn);
    if (name.endsWith(kModifiedMark)) name.chop(kModifiedMark.size());
    names.push_back(name);
  }
  return names;
}

QList<QAction*> MeshlabDriver::filter_actions() const {
  const QList<QAction*> bar = main_window()->findChild<QMenuBar*>()->actions();
  for (const QAction* top : bar)
    if (plain(top->text()) == "Filters") return leaf_actions(top->menu());
  fail("there is no menu 'Filters'");
}

}  // namespace mgf::driver

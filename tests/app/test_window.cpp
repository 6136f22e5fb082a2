#include "tests/app/test_window.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProcess>
#include <QTreeWidget>
#include <QWheelEvent>
#include <algorithm>
#include <fstream>

#include "app/commands/objects/edit_keys.h"
#include "app/document/paths.h"
#include "app/files/scene_files.h"
#include "app/view/surface_picker.h"
#include "app/viewport/viewport.h"
#include "app/widgets/application.h"
#include "app/widgets/mnemonics.h"
#include "app/widgets/number_field.h"
#include "app/widgets/value_field.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/desk.h"

namespace brume {

Scene small_scene() {
  Scene scene;
  scene.camera.eye = {0.0, 0.0, 6.0};
  scene.film = {120, 90};
  for (const glm::dvec3 center :
       {glm::dvec3(-1.2, 0.6, 0.0), glm::dvec3(1.2, 0.7, 0.0), glm::dvec3(0.0, -0.8, 0.5),
        glm::dvec3(-1.1, -0.9, -0.5), glm::dvec3(0.1, 0.5, 0.25)}) {
    scene.medium.append({center, 0.4 + 0.1 * center.x, 0.8});
  }
  Light light;
  light.position = {1.0, 2.0, 2.0};
  light.intensity = glm::dvec3(12.0, 10.0, 8.0);
  scene.lights.push_back(light);
  return scene;
}

Scene tiny_scene() {
  Scene scene = small_scene();
  scene.film = {32, 24};
  return scene;
}

TestWindow::TestWindow(const Scene& scene, const QSize& size)
    : window_(std::make_unique<MainWindow>()) {
  use_mouse_in(window_->viewport(), window_->viewport());
  save_document(scene, file("scene.brume"));
  window_->resize(size);
  window_->show();
  window_->activateWindow();
  if (!open("scene.brume") || !QTest::qWaitForWindowActive(window_.get(), patience) || !settle()) {
    qFatal("the window did not come up");
  }
}

bool TestWindow::open(const char* name) {
  QSignalSpy opened(&window_->files(), &SceneFiles::opened);
  window_->files().open_file(file(name));
  return QTest::qWaitFor([this] { return !window_->files().loading().is_running(); }, patience) &&
         opened.count() == 1;
}

std::filesystem::path TestWindow::file(const char* name) const {
  return to_path(folder_.filePath(name));
}

bool TestWindow::settle() {
  Viewport& view = window_->viewport();
  return QTest::qWaitFor(
      [&view] { return view.frames().is_measured() && view.surfaces().is_ready(); }, patience);
}

const JobBar& TestWindow::bar(const BackgroundJob& job) const {
  const QList<JobBar*> bars = window_->findChildren<JobBar*>();
  return **std::ranges::find_if(bars, [&](const JobBar* bar) { return &bar->job() == &job; });
}

const RenderedFrame& TestWindow::shown() {
  return *window_->viewport().frames().shown();
}

void ViewMouse::click(QPoint position, Qt::KeyboardModifiers modifiers) {
  QTest::mouseClick(widget_, Qt::LeftButton, modifiers, position);
}

void ViewMouse::press(QPoint position, Qt::KeyboardModifiers modifiers) {
  QTest::mousePress(widget_, Qt::LeftButton, modifiers, position);
}

void ViewMouse::release(QPoint position, Qt::KeyboardModifiers modifiers) {
  QTest::mouseRelease(widget_, Qt::LeftButton, modifiers, position);
}

QPoint ViewMouse::handle(std::size_t index) {
  return handle_position(*view_, index);
}

void ViewMouse::move(QPointF to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
  move_mouse(*widget_, to, button, modifiers);
}

void ViewMouse::drag(QPoint from, QPoint to, Qt::MouseButton button,
                     Qt::KeyboardModifiers modifiers) {
  drag_mouse(*widget_, from, to, button, modifiers);
}

void TestWindow::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
  // A question may have taken the activity, and shortcuts want it.
  window_->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(window_.get(), patience));
  window_->viewport().setFocus();
  QTest::keyClick(&window_->viewport(), key, modifiers);
}

std::vector<Gaussian> gaussians_after(const Document& document, std::size_t count) {
  std::vector<Gaussian> gaussians;
  for (std::size_t i = count; i < document.medium().size(); ++i) {
    gaussians.push_back(document.medium().gaussian(i));
  }
  return gaussians;
}

QPoint handle_position(const View& view, std::size_t index) {
  const glm::dvec3& position = view.handles().position(index);
  return QPointF(position.x, position.y).toPoint();
}

QPoint film_position(const View& view, const glm::dvec3& point) {
  const glm::dvec3 position = view.rays().project(point);
  return QPointF(position.x, position.y).toPoint();
}

QString last_step(Document& document) {
  return document.undo_stack().undoText();
}

int step_count(Document& document) {
  return document.undo_stack().count();
}

void prepare_application_in(const QTemporaryDir& folder) {
  for (const char* name : {"XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME"}) {
    qputenv(name, folder.path().toUtf8());
  }
  qputenv("LC_ALL", "C.UTF-8");  // texts and numbers are compared in English
  prepare_application();
}

void show_scene(MainWindow& window, const std::filesystem::path& file) {
  window.resize(1280, 800);
  window.show();
  window.files().open_file(file);
  while (window.files().loading().is_running()) QTest::qWait(5);
}

bool is_undone(Document& document, const Scene& before) {
  document.undo_stack().setIndex(0);
  return document.scene() == before;
}

bool is_cancelled_by_escape(QWidget& view, Document& document, QPoint from, QPoint to) {
  const Scene before = document.scene();
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  move_mouse(view, to);
  const bool changed = !(document.scene() == before);
  QTest::keyClick(&view, Qt::Key_Escape);
  const bool is_back = document.scene() == before;
  QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
  return changed && is_back && document.scene() == before;
}

void move_mouse(QWidget& widget, QPointF to, Qt::MouseButton button,
                Qt::KeyboardModifiers modifiers) {
  QMouseEvent event(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, button, modifiers);
  QApplication::sendEvent(&widget, &event);
  if (auto* view = qobject_cast<Viewport*>(&widget)) view->finish_input();
  if (auto* view = qobject_cast<DeskView*>(&widget)) view->finish_input();
}

void drag_mouse(QWidget& widget, QPointF from, QPointF to, Qt::MouseButton button,
                Qt::KeyboardModifiers modifiers) {
  QTest::mousePress(&widget, button, modifiers, from.toPoint());
  constexpr int steps = 5;
  for (int k = 1; k <= steps; ++k) {
    move_mouse(widget, from + (to - from) * k / steps, button, modifiers);
  }
  QTest::mouseRelease(&widget, button, modifiers, to.toPoint());
}

void turn_wheel(QWidget& widget, QPointF place, int angle, Qt::KeyboardModifiers modifiers) {
  QWheelEvent event(place, widget.mapToGlobal(place), {}, {0, angle}, Qt::NoButton, modifiers,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &event);
}

bool drop_at(QWidget& widget, QPoint place, const QMimeData& data) {
  QDragEnterEvent enter(place, Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(&widget, &enter);
  QDragMoveEvent move(place, Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(&widget, &move);
  QDropEvent drop(place, Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(&widget, &drop);
  return enter.isAccepted();
}

void start_test(QProcess& process, const QStringList& test, const QString& variable,
                const QString& value) {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(variable, value);
  process.setProcessEnvironment(environment);
  process.start(QCoreApplication::applicationFilePath(), test);
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

Track find_track(const Scene& scene, const char* title) {
  for (const Track& track : tracks(scene)) {
    if (track.title() == title) return track;
  }
  qFatal("there is no track %s", title);
}

void set_key(Document& document, const char* title) {
  set_keys(document, find_track(document.scene(), title));
}

std::string bytes_of(const Document& document) {
  return document_to_json({document.scene(), document.extras()}, "/");
}

void enter(QWidget& window, const char* field, const QString& text) {
  auto* line = window.findChild<ValueField*>(field)->findChild<NumberField*>();
  line->setText(text);
  line->setModified(true);
  QTest::keyClick(line, Qt::Key_Return);
}

void click(QWidget& window, const char* name) {
  auto* button = window.findChild<QAbstractButton*>(name);
  QVERIFY2(button && button->isEnabled(), name);
  button->click();
}

void choose(QWidget& window, const char* name, int index) {
  auto* box = window.findChild<QComboBox*>(name);
  box->setCurrentIndex(index);
  Q_EMIT box->activated(index);
}

void type(QWidget& window, const char* name, const QString& text) {
  auto* line = window.findChild<QLineEdit*>(name);
  line->selectAll();
  line->setFocus();
  QTest::keyClicks(line, text);
  QTest::keyClick(line, Qt::Key_Return);
}

QString value(QWidget& window, const char* field) {
  return window.findChild<ValueField*>(field)->findChild<NumberField*>()->text();
}

void invoke(QWidget& window, const char* action) {
  window.findChild<QAction*>(action)->trigger();
}

void trigger(QWidget& window, const QString& text) {
  for (QAction* action : window.findChildren<QAction*>()) {
    if (without_mnemonic(action->text()).contains(text)) return action->trigger();
  }
  QFAIL(qPrintable(text));
}

bool choose_from_menu(QWidget& widget, QPoint place, const QString& text) {
  QContextMenuEvent event(QContextMenuEvent::Mouse, place, widget.mapToGlobal(place));
  QApplication::sendEvent(&widget, &event);
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  bool is_chosen = false;
  const QMenu* shown = menu;
  for (const QString& part : text.split('/')) {
    if (!shown) break;
    const auto actions = shown->actions();
    const auto found = std::ranges::find(
        actions, part, [](const QAction* action) { return without_mnemonic(action->text()); });
    shown = found == actions.end() ? nullptr : (*found)->menu();
    if (found == actions.end() || shown) continue;
    is_chosen = (*found)->isEnabled();
    (*found)->trigger();
  }
  if (menu) menu->close();
  return is_chosen;
}

QString label_text(const QWidget& window, const char* name) {
  return window.findChild<QLabel*>(name)->text();
}

QPoint cell_position(QTreeWidget& tree, QTreeWidgetItem* item, int column) {
  tree.scrollToItem(item);
  const int x = tree.columnViewportPosition(column) + tree.columnWidth(column) / 2;
  return {x, tree.visualItemRect(item).center().y()};
}

void drag_title(QWidget& window, const char* field, int pixels) {
  auto* title = window.findChild<QLabel*>(QString(field) + "_title");
  if (!title) title = window.findChild<ValueField*>(field)->findChild<QLabel*>();
  drag_mouse(*title, {3, 3}, {3.0 + pixels, 3});
}

}  // namespace brume

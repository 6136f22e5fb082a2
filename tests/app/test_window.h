#pragma once

#include <QTemporaryDir>
#include <QtTest/QtTest>
#include <filesystem>
#include <memory>
#include <string>

#include "app/document/time/keyframe_tracks.h"
#include "app/jobs/job_bar.h"
#include "app/window/main_window.h"
#include "brume/scene.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {

// How long a condition is waited for [ms]: only what hangs takes so long. Beside a full load OpenGL
// in software compiles shaders for more than a minute.
inline constexpr int patience = 300'000;

}  // namespace brume

// Qt's own wait five seconds.
#undef QTRY_VERIFY
#define QTRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, brume::patience)
#undef QTRY_COMPARE
#define QTRY_COMPARE(value, expected) QTRY_COMPARE_WITH_TIMEOUT(value, expected, brume::patience)

class QMimeData;
class QProcess;
class QTreeWidget;
class QTreeWidgetItem;

namespace brume {

class View;
class Viewport;
struct RenderedFrame;

// Five Gaussians well apart on screen, two of them behind each other's plane, and a light.
Scene small_scene();
Scene tiny_scene();  // the same in 32 x 24 pixels

// The mouse in a view; the left button where none is named.
class ViewMouse {
 public:
  void click(QPoint position, Qt::KeyboardModifiers modifiers = {});
  void press(QPoint position, Qt::KeyboardModifiers modifiers = {});
  void release(QPoint position, Qt::KeyboardModifiers modifiers = {});
  // The position of a Gaussian's handle.
  QPoint handle(std::size_t index);
  void move(QPointF to, Qt::MouseButton button = Qt::LeftButton,
            Qt::KeyboardModifiers modifiers = Qt::NoModifier);
  void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton,
            Qt::KeyboardModifiers modifiers = Qt::NoModifier);

 protected:
  void use_mouse_in(QWidget& widget, const View& view) {
    widget_ = &widget;
    view_ = &view;
  }

 private:
  QWidget* widget_ = nullptr;
  const View* view_ = nullptr;
};

// A main window that shows a scene from a file, active and with its first full frame.
//
// Tests wait for conditions: on a busy machine a moment is any length. Only what must not happen is
// given a time.
class TestWindow : public ViewMouse {
 public:
  // By default a picture high enough to tell handles apart.
  explicit TestWindow(const Scene& scene = small_scene(), const QSize& size = {800, 660});

  MainWindow& operator*() { return *window_; }
  operator QWidget&() { return *window_; }
  MainWindow* operator->() { return window_.get(); }
  Document& document() { return window_->document(); }
  const Scene& scene() { return document().scene(); }
  // The frame that the viewport shows.
  const RenderedFrame& shown();
  Viewport& view() { return window_->viewport(); }
  [[nodiscard]] std::filesystem::path file(const char* name) const;

  // Opens a file of this window's folder; whether it is there.
  bool open(const char* name);
  // Waits until the viewport shows the present state at full resolution, and how wrong it is.
  bool settle();
  // The bar that shows a job.
  [[nodiscard]] const JobBar& bar(const BackgroundJob& job) const;
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);

 private:
  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

void write_text(const std::filesystem::path& file, const std::string& text);

// Programs beside the tests have settings and caches in that folder.
void prepare_application_in(const QTemporaryDir& folder);
// Shows a window of 1280 x 800 logical pixels with the scene of a file.
void show_scene(MainWindow& window, const std::filesystem::path& file);

// The step that undo would undo, and how many there are.
QString last_step(Document& document);
int step_count(Document& document);
// Undoes everything; whether all is as it was, to the last bit.
bool is_undone(Document& document, const Scene& before);
// Whether a drag changes the scene, and Escape within it takes that back.
bool is_cancelled_by_escape(QWidget& view, Document& document, QPoint from, QPoint to);

// Moves of the mouse with a button down, worked off at once: QTest::mouseMove knows of none.
void move_mouse(QWidget& widget, QPointF to, Qt::MouseButton button = Qt::LeftButton,
                Qt::KeyboardModifiers modifiers = Qt::NoModifier);
// In steps.
void drag_mouse(QWidget& widget, QPointF from, QPointF to, Qt::MouseButton button = Qt::LeftButton,
                Qt::KeyboardModifiers modifiers = Qt::NoModifier);

// Turns the wheel over a place, up if positive.
void turn_wheel(QWidget& widget, QPointF place, int angle, Qt::KeyboardModifiers modifiers = {});
// Lets what is dragged fall at a place, if that takes it; whether it does.
bool drop_at(QWidget& widget, QPoint place, const QMimeData& data);
// Starts this program's test of a name in another process, with a variable of the environment.
void start_test(QProcess& process, const QStringList& test, const QString& variable,
                const QString& value);

// The track of a title that a scene has: "Light 1 position"; and sets its keyframe.
Track find_track(const Scene& scene, const char* title);
void set_key(Document& document, const char* title);

// The text of a document's scene file, all values included.
std::string bytes_of(const Document& document);

// Gaussians after the first `count`.
std::vector<Gaussian> gaussians_after(const Document& document, std::size_t count);

// Where a Gaussian's handle is in a view.
QPoint handle_position(const View& view, std::size_t index);
// Where a point is in a view.
QPoint film_position(const View& view, const glm::dvec3& point);

// Types into a ValueField, by name; its text.
void enter(QWidget& window, const char* field, const QString& text);
// Act on widgets with a name: press a button, choose from a box, type into a line.
void click(QWidget& window, const char* button);
void choose(QWidget& window, const char* box, int index);
void type(QWidget& window, const char* line, const QString& text);
QString value(QWidget& window, const char* field);
// Triggers an action by its name, and that of a menu by a part of its text.
void invoke(QWidget& window, const char* action);
void trigger(QWidget& window, const QString& text);
// Chooses from the context menu at a place, "Move into/a" from a menu in it; whether it has that
// and it is enabled.
bool choose_from_menu(QWidget& widget, QPoint place, const QString& text);
QString label_text(const QWidget& window, const char* name);
// The middle of a cell of a tree, once that is scrolled to.
QPoint cell_position(QTreeWidget& tree, QTreeWidgetItem* item, int column = 0);
// Drags a ValueField's title by some pixels, in steps.
void drag_title(QWidget& window, const char* field, int pixels);

// A suite of test_app, by name: a class of test functions, run with the arguments of
// QTest::qExec().
class AppSuite {
 public:
  AppSuite(const char* name, int (*run)(int, char**));
};

}  // namespace brume

#define BRUME_APP_SUITE(name, Test)                                           \
  static const brume::AppSuite Test##_suite(name, [](int argc, char** argv) { \
    Test test;                                                                \
    return QTest::qExec(&test, argc, argv);                                   \
  });

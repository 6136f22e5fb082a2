// The window as a whole: table, keys, history, files.

#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QProcess>
#include <QStatusBar>
#include <QToolButton>
#include <QUndoView>
#include <fstream>

#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/gaussians/select_command.h"
#include "app/files/scene_files.h"
#include "app/panels/gaussians/gaussian_panel.h"
#include "app/viewport/viewport.h"
#include "app/window/pages/message_bar.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/desk.h"
#include "tests/app/file_jobs.h"
#include "tests/app/question.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

QTableView* table_of(const QWidget& window) {
  return window.findChild<GaussianPanel*>()->table();
}

// Types into the table's current cell.
void type(QTableView* table, const QString& text) {
  table->setFocus();
  QTest::keyClick(table, Qt::Key_F2);
  auto* editor = table->viewport()->findChild<QLineEdit*>();
  QVERIFY(editor);
  editor->selectAll();
  QTest::keyClicks(editor, text);
  QTest::keyClick(editor, Qt::Key_Return);
  // Qt commits a cell a little later.
  QTRY_VERIFY(!table->viewport()->findChild<QLineEdit*>());
}

Scene fog_of(int count) {
  Scene scene = small_scene();
  scene.medium = {};
  for (int k = 0; k < count; ++k) scene.medium.append({{0.001 * k, 0.0, 0.0}, 0.1, 0.001});
  return scene;
}

struct Ended {
  int code = -1;  // or -1 if it did not exit by itself
  QByteArray out;
  QByteArray err;
};

// Runs the program; an empty variable is not set.
Ended run_editor(const QStringList& arguments, const QHash<QString, QString>& variables) {
  QProcess editor;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (auto variable = variables.begin(); variable != variables.end(); ++variable) {
    if (variable->isEmpty()) {
      environment.remove(variable.key());
    } else {
      environment.insert(variable.key(), *variable);
    }
  }
  editor.setProcessEnvironment(environment);
  editor.start(BRUME_EDITOR, arguments);
  if (!editor.waitForFinished(patience)) return {};
  return {editor.exitStatus() == QProcess::NormalExit ? editor.exitCode() : -1,
          editor.readAllStandardOutput(), editor.readAllStandardError()};
}

}  // namespace

class EditorTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_cell_writes_to_all_selected_rows_as_one_step() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    QTableView* table = table_of(desk);
    document.select({1, 3, 4});
    table->selectionModel()->setCurrentIndex(table->model()->index(2, 3),
                                             QItemSelectionModel::NoUpdate);
    type(table, "0.75");
    QCOMPARE(step_count(document), 1);
    QCOMPARE(last_step(document), "Set radius of 3 Gaussians to 0.75");
    for (const std::size_t k : {0U, 2U, 3U}) QCOMPARE(document.medium().radii()[k], 0.75);
    QCOMPARE(document.medium().radii()[1], before.medium.radii()[1]);
    QCOMPARE(table->model()->index(0, 3).data().toString(), "0.75");
    QCOMPARE(document.selection().size(), 3u);
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(document.scene() == before);
  }

  void a_cell_outside_the_selection_writes_to_its_row() {
    Desk desk;
    QAbstractItemModel* model = table_of(desk)->model();
    desk.document().select({1, 2});
    QVERIFY(model->setData(model->index(4, 4), "0.125", Qt::EditRole));
    QCOMPARE(desk.document().medium().densities()[4], 0.125);
    QCOMPARE(desk.document().medium().densities()[0], 0.8);
  }

  void opening_a_cell_changes_nothing() {
    Desk desk;
    select_all(desk.document());
    QTableView* table = table_of(desk);
    table->setFocus();
    QTest::keyClick(table, Qt::Key_F2);
    auto* editor = table->viewport()->findChild<QLineEdit*>();
    QVERIFY(editor);
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_VERIFY(!table->viewport()->findChild<QLineEdit*>());
    QVERIFY(!desk.document().is_modified());
  }

  void a_bad_value_is_refused_with_a_message() {
    TestWindow window;
    QTableView* table = table_of(*window);
    window->document().select({2});
    for (const char* bad : {"0", "-1", "nan", "1e999", "fog", ""}) {
      table->selectionModel()->setCurrentIndex(table->model()->index(1, 3),
                                               QItemSelectionModel::NoUpdate);
      window->statusBar()->clearMessage();
      table->model()->setData(table->model()->index(1, 3), bad, Qt::EditRole);
      QVERIFY2(window->statusBar()->currentMessage().contains("Radius"), bad);
    }
    QVERIFY(!window->document().is_modified());
  }

  void add_delete_undo_all_redo_all() {
    TestWindow window;
    Document& document = window->document();
    const Scene before = document.scene();
    window.key(Qt::Key_A, Qt::ShiftModifier);
    QCOMPARE(document.medium().size(), 6u);
    QCOMPARE(document.selection().size(), 1u);
    window.click(window.handle(0));
    window.drag(window.handle(0), window.handle(0) + QPoint(20, 20));
    window.key(Qt::Key_A, Qt::ControlModifier);
    window.key(Qt::Key_I, Qt::ControlModifier);
    QVERIFY(document.selection().empty());
    document.select({2, 4});
    window.key(Qt::Key_Delete);
    QCOMPARE(document.medium().size(), 4u);
    QVERIFY(document.selection().empty());
    QCOMPARE(table_of(*window)->model()->rowCount(), 4);
    const Scene after = document.scene();
    // Add, select, move, select all, select nothing, delete; and where it began.
    QCOMPARE(window->findChild<QUndoView*>()->model()->rowCount(), 7);
    for (int k = 0; k < 6; ++k) window.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(document.scene() == before);
    QVERIFY(!window->isWindowModified());
    for (int k = 0; k < 6; ++k) {
      window.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    }
    QVERIFY(document.scene() == after);
    QVERIFY(window.settle());
  }

  void save_and_open_again_is_the_same_scene() {
    TestWindow window;
    Document& document = window->document();
    QCOMPARE(window->windowTitle(), "scene.brume[*] – Brume");
    window.key(Qt::Key_A, Qt::ShiftModifier);
    QVERIFY(window->isWindowModified());
    window.key(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(!window->isWindowModified());
    window.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window->isWindowModified());
    window.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!window->isWindowModified());
    QVERIFY(window->files().save_to(window.file("other.brume")));
    const Scene saved = document.scene();
    QVERIFY(window->files().create());
    QVERIFY(document.medium().empty() && document.file().empty());
    QVERIFY(window.open("other.brume"));
    QCOMPARE(document.name(), "other.brume");
    QVERIFY(std::ranges::equal(document.medium().centers(), saved.medium.centers()));
    QVERIFY(std::ranges::equal(document.medium().radii(), saved.medium.radii()));
    QVERIFY(std::ranges::equal(document.medium().densities(), saved.medium.densities()));
    QVERIFY(document.scene().lights == saved.lights);
    QVERIFY(document.scene().camera == saved.camera);
    QMenu recent;
    window->files().fill_recent_menu(recent);
    QCOMPARE(recent.actions().first()->text(), "other.brume");
  }

  void unsaved_work_is_asked_about_once() {
    TestWindow window;
    window.key(Qt::Key_A, Qt::ShiftModifier);
    answer(QMessageBox::Cancel);
    QVERIFY(!window->close());
    QVERIFY(window->isVisible());
    answer(QMessageBox::Save);
    QVERIFY(window->files().create());
    QCOMPARE(load_scene(window.file("scene.brume")).medium.size(), 6u);
    window.key(Qt::Key_A, Qt::ShiftModifier);
    answer(QMessageBox::Discard);
    QVERIFY(window->close());
  }

  void a_broken_file_is_reported_and_nothing_is_lost() {
    TestWindow window;
    auto* bar = window->findChild<MessageBar*>();
    QVERIFY(!bar->isVisible());
    QVERIFY(!window.open("missing.brume"));
    QVERIFY(bar->isVisible());
    QVERIFY(bar->message().contains("missing.brume"));
    std::ofstream(window.file("broken.brume")) << "{ \"brume\": ";
    QVERIFY(!window.open("broken.brume"));
    QVERIFY(bar->message().contains("broken.brume"));
    QCOMPARE(window->document().name(), "scene.brume");
    QCOMPARE(window->document().medium().size(), 5u);
    QVERIFY(window.open("scene.brume"));
    QVERIFY(!bar->isVisible());
  }

  void a_screenshot_of_a_missing_scene_is_an_error() {
    const QTemporaryDir folder;
    const QString picture = folder.filePath("s.png");
    const Ended editor = run_editor({folder.filePath("nosuch.brume"), "--screenshot", picture},
                                    {{"QT_LOGGING_RULES", "*=false"}});  // Qt's, about platforms
    QCOMPARE(editor.code, 2);
    QVERIFY(!QFile::exists(picture));
    QVERIFY2(editor.err.contains("nosuch.brume") && editor.err.count('\n') == 1, editor.err);
  }

  void help_and_version_work_without_a_display() {
    const QHash<QString, QString> nowhere{{"QT_QPA_PLATFORM", "xcb"}, {"DISPLAY", ":6789"}};
    const Ended version = run_editor({"--version"}, nowhere);
    QCOMPARE(version.code, 0);
    QVERIFY2(version.out.startsWith("Brume ") && version.err.isEmpty(), version.err);
    const Ended help = run_editor({"-h"}, nowhere);
    QCOMPARE(help.code, 0);
    QVERIFY(help.out.contains("--screenshot"));
  }

  void a_missing_display_is_one_clear_error() {
    for (const char* display : {"", ":6789"}) {
      const Ended editor = run_editor(
          {"x.brume"}, {{"QT_QPA_PLATFORM", "xcb"}, {"DISPLAY", display}, {"WAYLAND_DISPLAY", ""}});
      QCOMPARE(editor.code, 2);
      QVERIFY2(editor.err.startsWith("brume-editor: error: no display: "), editor.err);
      QVERIFY2(editor.err.count('\n') == 1 && editor.err.contains("DISPLAY") == (*display == 0),
               editor.err);
    }
  }

  void a_dropped_scene_opens() {
    TestWindow window;
    QVERIFY(window->files().create());
    drop(window, {window.file("scene.brume")});
    QTRY_COMPARE(window->document().medium().size(), 5u);
  }

  void the_present_scene_stays_until_the_other_is_complete() {
    TestWindow window;
    save_document(fog_of(20000), window.file("big.brume"));
    BackgroundJob& loading = window->files().loading();
    const JobBar& bar = window.bar(loading);
    QVERIFY(!bar.isVisible());
    window->files().open_file(window.file("big.brume"));
    QVERIFY(bar.isVisible());
    window.key(Qt::Key_Plus);  // the window goes on
    QVERIFY(window->document().medium().size() == 5 || !loading.is_running());
    QTRY_VERIFY(!loading.is_running());
    QVERIFY(!bar.isVisible());
    QCOMPARE(window->document().medium().size(), 20000u);
    QCOMPARE(window->document().name(), "big.brume");
  }

  void opening_can_be_cancelled_and_the_last_one_wins() {
    TestWindow window;
    save_document(fog_of(20000), window.file("big.brume"));
    save_document(fog_of(7), window.file("seven.brume"));
    QSignalSpy opened(&window->files(), &SceneFiles::opened);
    window->files().open_file(window.file("big.brume"));
    const JobBar& bar = window.bar(window->files().loading());
    QTest::mouseClick(bar.findChild<QToolButton*>(), Qt::LeftButton);
    QVERIFY(!bar.isVisible());
    QCOMPARE(window->document().medium().size(), 5u);
    window->files().open_file(window.file("big.brume"));
    QVERIFY(window.open("seven.brume"));
    QCOMPARE(window->document().medium().size(), 7u);
    QTest::qWait(300);
    QCOMPARE(opened.count(), 1);  // the big ones never came
  }

  void work_done_while_a_scene_is_read_is_asked_about() {
    TestWindow window;
    window->files().open_file(window.file("scene.brume"));
    add_gaussian(window->document(), {{}, 1.0, 1.0});
    answer(QMessageBox::Cancel);
    QTRY_VERIFY(!window->files().loading().is_running());
    QTRY_VERIFY(!QApplication::activeModalWidget());
    QCOMPARE(window->document().medium().size(), 6u);
    QVERIFY(window->isWindowModified());
    window->document().undo_stack().undo();
  }
};

BRUME_APP_SUITE("editor", EditorTest)
#include "editor_test.moc"

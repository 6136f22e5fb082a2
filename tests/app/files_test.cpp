// The scene's file and those it refers to: changed by others, missing, strangely named; and where
// dialogs look for files.

#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <fstream>

#include "app/commands/gaussians/edit_medium.h"
#include "app/document/paths.h"
#include "app/files/file_dialogs.h"
#include "app/files/scene_files.h"
#include "app/import/scene_import.h"
#include "app/widgets/plain_text.h"
#include "app/window/file_jobs.h"
#include "app/window/pages/message_bar.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/mesh.h"
#include "tests/app/question.h"
#include "tests/app/test_window.h"

using namespace brume;
namespace fs = std::filesystem;

namespace {

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

MessageBar& bar_of(TestWindow& window) {
  return *window->findChild<MessageBar*>();
}

bool has_offer(TestWindow& window, const char* name) {
  const auto* button = bar_of(window).findChild<QPushButton*>(name);
  return button && button->isVisible();
}

void take_offer(TestWindow& window, const char* name) {
  QTest::mouseClick(bar_of(window).findChild<QPushButton*>(name), Qt::LeftButton);
}

// Does what a window manager does when the user comes back to the window.
void come_back(TestWindow& window) {
  QWidget other;
  other.show();
  other.activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&other));
  window->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&*window));
}

// Another window changes the file of this one.
void change_on_disk(TestWindow& window) {
  Document other;
  other.open(load_scene(window.file("scene.brume")), window.file("scene.brume"));
  add_gaussian(other, {{5, 5, 5}, 1.0, 0.5});
  other.save(window.file("scene.brume"));
}

std::size_t count_on_disk(TestWindow& window) {
  return load_scene(window.file("scene.brume")).medium.size();
}

// Chooses a file in the dialog that is about to be shown; `seen` gets what it was like before.
struct SeenDialog {
  QString folder;
  QString title;
};
void choose(const fs::path& file, SeenDialog* seen = nullptr) {
  QTimer::singleShot(50, qApp, [file, seen] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (!dialog) {
      choose(file, seen);
      return;
    }
    if (seen && seen->title.isEmpty()) {
      *seen = {dialog->directory().canonicalPath(), dialog->windowTitle()};
    }
    // While it still reads the folder, the dialog may select the file it was opened with, which
    // then counts for more than the text: selectFile() clears that.
    dialog->selectFile(to_qstring(file));
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(to_qstring(file));
    if (dialog->selectedFiles() != QStringList(to_qstring(file))) {
      choose(file, seen);
      return;
    }
    QMetaObject::invokeMethod(dialog, "accept");
  });
}

bool is_visible(const Surface& surface) {
  return surface.mesh->points[0] != surface.mesh->points[1];
}

// A scene with two files, in a folder of its own.
void write_scene_with_meshes(TestWindow& window) {
  write_text(window.file("a.obj"), triangle);
  write_text(window.file("b.obj"), triangle);
  Scene scene = small_scene();
  for (const char* name : {"a.obj", "b.obj", "a.obj"}) {
    Surface surface;
    surface.mesh_file = window.file(name);
    surface.transfer = Surface::Transfer::shadow;
    scene.surfaces.push_back(surface);
  }
  save_document(scene, window.file("meshes.brume"));
}

}  // namespace

class FilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_file_changed_on_disk_is_reloaded() {
    TestWindow window;
    come_back(window);
    QTest::qWait(50);
    QVERIFY(!bar_of(window).isVisible());
    change_on_disk(window);
    come_back(window);
    QTRY_VERIFY(has_offer(window, "reload"));
    QVERIFY(bar_of(window).message().contains("scene.brume"));
    take_offer(window, "reload");
    QTRY_COMPARE(window->document().medium().size(), 6u);
    QVERIFY(!bar_of(window).isVisible());
  }

  void overwriting_external_changes_is_confirmed() {
    TestWindow window;
    Document& document = window->document();
    document.select({1, 2});
    window.key(Qt::Key_Delete);
    change_on_disk(window);
    QString question;
    answer(QMessageBox::Cancel, &question);
    QVERIFY(!window->files().save());
    QVERIFY2(question.contains("scene.brume"), qPrintable(question));
    QVERIFY(document.is_modified());
    QCOMPARE(count_on_disk(window), 6u);
    answer(QMessageBox::SaveAll);
    choose(window.file("mine.brume"));
    QVERIFY(window->files().save());
    QCOMPARE(document.name(), "mine.brume");
    QCOMPARE(count_on_disk(window), 6u);
    QVERIFY(window->files().save());  // no question: nobody else wrote this one
  }

  void external_changes_can_be_overwritten() {
    TestWindow window;
    change_on_disk(window);
    come_back(window);
    QTRY_VERIFY(has_offer(window, "reload"));
    answer(QMessageBox::Save);
    QVERIFY(window->files().save());
    QVERIFY(!bar_of(window).isVisible());
    QCOMPARE(count_on_disk(window), 5u);
    QVERIFY(window->files().save());
    QCOMPARE(count_on_disk(window), 5u);
  }

  void keeping_own_work_is_asked_once_per_change() {
    TestWindow window;
    change_on_disk(window);
    come_back(window);
    QTRY_VERIFY(has_offer(window, "keep_mine"));
    take_offer(window, "keep_mine");
    QVERIFY(!bar_of(window).isVisible());
    QVERIFY(window->files().save());
    QCOMPARE(count_on_disk(window), 5u);
    change_on_disk(window);
    answer(QMessageBox::Cancel);
    QVERIFY(!window->files().save());
  }

  void a_removed_file_is_told_and_the_scene_is_unsaved() {
    TestWindow window;
    Document& document = window->document();
    fs::rename(window.file("scene.brume"), window.file("moved.brume"));
    QTRY_VERIFY(has_offer(window, "save_missing"));
    QVERIFY(bar_of(window).message().contains("scene.brume"));
    QVERIFY(window->isWindowModified());
    answer(QMessageBox::Cancel);
    QVERIFY(!window->close());
    // Back, and as it was.
    fs::rename(window.file("moved.brume"), window.file("scene.brume"));
    QTRY_VERIFY(!document.is_modified());
    QVERIFY(!bar_of(window).isVisible());
    QVERIFY(!window->isWindowModified());
    fs::remove(window.file("scene.brume"));
    QTRY_VERIFY(has_offer(window, "save_missing"));
    take_offer(window, "save_missing");
    QCOMPARE(count_on_disk(window), 5u);
    QVERIFY(!document.is_modified() && !bar_of(window).isVisible());
  }

  void a_removed_file_that_comes_back_changed_leaves_the_scene_unsaved() {
    TestWindow window;
    fs::copy(window.file("scene.brume"), window.file("copy.brume"));
    change_on_disk(window);
    fs::rename(window.file("scene.brume"), window.file("changed.brume"));
    QTRY_VERIFY(has_offer(window, "save_missing"));
    fs::rename(window.file("changed.brume"), window.file("scene.brume"));
    QTRY_VERIFY(has_offer(window, "reload"));
    QVERIFY(window->document().is_modified());
    fs::rename(window.file("copy.brume"), window.file("scene.brume"));
    come_back(window);
    QTRY_VERIFY(!window->document().is_modified());
  }

  // Files of a folder that is gone are noticed no sooner.
  void closing_asks_for_a_file_that_was_not_noticed_to_be_missing() {
    TestWindow window;
    fs::create_directories(window.file("outer/inner"));
    QVERIFY(window->files().save_to(window.file("outer/inner/deep.brume")));
    fs::rename(window.file("outer"), window.file("other"));
    QString question;
    answer(QMessageBox::Discard, &question);
    QVERIFY(window->close());
    QVERIFY2(question.contains("missing"), qPrintable(question));
  }

  void a_touched_file_is_unchanged() {
    TestWindow window;
    fs::last_write_time(window.file("scene.brume"), fs::file_time_type::clock::now());
    QVERIFY(window->files().save());
    fs::remove(window.file("scene.brume"));
    QVERIFY(window->files().save());  // nothing there that could be lost
    QCOMPARE(count_on_disk(window), 5u);
  }

  void unsaved_work_is_asked_about_before_the_file_is_read_again() {
    TestWindow window;
    window.key(Qt::Key_A, Qt::ShiftModifier);
    window.key(Qt::Key_A, Qt::ShiftModifier);
    change_on_disk(window);
    come_back(window);
    QTRY_VERIFY(has_offer(window, "reload"));
    answer(QMessageBox::Cancel);
    take_offer(window, "reload");
    QCOMPARE(window->document().medium().size(), 7u);
    answer(QMessageBox::Discard);
    window->files().reload();
    QTRY_COMPARE(window->document().medium().size(), 6u);
  }

  void a_scene_opens_without_a_mesh_and_keeps_its_reference() {
    TestWindow window;
    write_scene_with_meshes(window);
    fs::remove(window.file("a.obj"));
    QVERIFY(window.open("meshes.brume"));
    const QString message = bar_of(window).message();
    QVERIFY2(message.contains("a.obj") && !message.contains("b.obj"), qPrintable(message));
    QVERIFY(window.settle());
    const Surfaces& surfaces = window.scene().surfaces;
    QCOMPARE(surfaces.size(), 3u);
    QVERIFY(!is_visible(surfaces[0]));
    QVERIFY(is_visible(surfaces[1]));
    QVERIFY(!window->document().is_modified());
    window.key(Qt::Key_A, Qt::ShiftModifier);
    QVERIFY(window->files().save());
    write_text(window.file("a.obj"), triangle);
    QVERIFY(is_visible(load_scene(window.file("meshes.brume")).surfaces[2]));
  }

  void missing_files_are_found_together() {
    TestWindow window;
    write_scene_with_meshes(window);
    fs::create_directory(window.file("moved"));
    for (const char* name : {"a.obj", "b.obj"}) {
      fs::rename(window.file(name), window.file("moved") / name);
    }
    QVERIFY(window.open("meshes.brume"));
    QVERIFY(has_offer(window, "find_missing"));
    SeenDialog seen;
    choose(window.file("moved") / "a.obj", &seen);
    take_offer(window, "find_missing");
    QCOMPARE(seen.title, "Find a.obj");
    QTRY_VERIFY(is_visible(window.scene().surfaces[0]));
    QVERIFY(is_visible(window.scene().surfaces[1]));
    QVERIFY(!bar_of(window).isVisible());
    QVERIFY(window->document().is_modified());  // until the new places are in the file
    QCOMPARE(window->document().name(), "meshes.brume");
    QVERIFY(window->files().save());
    QVERIFY(load_scene(window.file("meshes.brume")).surfaces[1].mesh_file ==
            window.file("moved") / "b.obj");
  }

  void a_damaged_file_is_reported_and_nothing_is_lost() {
    TestWindow window;
    write_scene_with_meshes(window);
    fs::remove(window.file("a.obj"));
    QVERIFY(window.open("meshes.brume"));
    write_text(window.file("bad.obj"), "f 1 2 3\n");
    choose(window.file("bad.obj"));
    take_offer(window, "find_missing");
    QTRY_VERIFY(bar_of(window).message().contains("bad.obj"));
    QCOMPARE(window.scene().surfaces.size(), 3u);
  }

  void names_are_no_markup() {
    TestWindow window;
    const char* name = "<i>bold<i>.brume";
    fs::copy_file(window.file("scene.brume"), window.file(name));
    QVERIFY(window.open(name));
    write_text(window.file("<i>bold<i>.csv"), "no table");
    window->file_jobs().import().import_file(window.file("<i>bold<i>.csv"));
    QTRY_VERIFY(bar_of(window).isVisible());
    QVERIFY(bar_of(window).message().contains("<i>"));
    for (const QLabel* label : window->findChildren<QLabel*>()) {
      const bool is_fixed = label->textFormat() != Qt::PlainText;
      QVERIFY2(!is_fixed || !label->text().contains("bold"), qPrintable(label->text()));
    }
    // All labels whose text changes, not only those that show the name just now.
    for (const char* shown : {"environment_file", "error", "quality", "panel_error"}) {
      QCOMPARE(window->findChild<QLabel*>(shown)->textFormat(), Qt::PlainText);
    }
    window.key(Qt::Key_A, Qt::ShiftModifier);
    bool is_plain = false;
    QTimer::singleShot(50, qApp, [&is_plain] {
      auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!question) return;
      is_plain = question->textFormat() == Qt::PlainText;
      question->button(QMessageBox::Cancel)->click();
    });
    QVERIFY(!window->files().may_discard());
    QVERIFY(is_plain);
    QVERIFY(plain_tool_tip("a <b>\nb").contains("&lt;b&gt;<br>b"));
  }

  void a_long_name_widens_nothing() {
    TestWindow window;
    for (const char* label : {"environment_file", "panel_error", "interval", "error"}) {
      auto* shown = window->findChild<QLabel*>(label);
      QWidget* around = shown->parentWidget();
      shown->setText("1.4 ± .2 %");
      QCoreApplication::processEvents();
      const int width = around->minimumSizeHint().width();
      shown->setText("816.123456789 ± 2058.123456789 %, or " + QString(200, 'x'));
      QCoreApplication::processEvents();
      QVERIFY2(around->minimumSizeHint().width() == width, label);
    }
    const QString name = QString(200, 'x') + ".brume";
    fs::copy_file(window.file("scene.brume"), window.file(qUtf8Printable(name)));
    const int width = window->minimumSizeHint().width();
    QVERIFY(window.open(qUtf8Printable(name)));
    QCOMPARE(window->minimumSizeHint().width(), width);
  }

  void file_dialogs_remember_the_last_folder() {
    TestWindow window;
    const fs::path scenes = window.file("scenes");
    const fs::path meshes = window.file("meshes");
    for (const fs::path& folder : {scenes, meshes}) fs::create_directory(folder);
    fs::copy_file(window.file("scene.brume"), scenes / "a.brume");
    write_text(meshes / "a.obj", triangle);
    const auto trigger = [&](const char* action, const fs::path& file) {
      SeenDialog seen;
      choose(file, &seen);
      invoke(window, action);
      return seen.folder;
    };
    const QString here = QFileInfo(to_qstring(scenes)).dir().canonicalPath();
    QCOMPARE(trigger("file.open", scenes / "a.brume"), here);
    QTRY_COMPARE(window->document().name(), "a.brume");
    // The first time, where the scene is; then where the last import came from.
    const QString there = QDir(to_qstring(scenes)).canonicalPath();
    QCOMPARE(trigger("file.import", meshes / "a.obj"), there);
    QTRY_COMPARE(window.scene().surfaces.size(), 1u);
    QCOMPARE(trigger("file.import", meshes / "a.obj"), QDir(to_qstring(meshes)).canonicalPath());
    QTRY_COMPARE(window.scene().surfaces.size(), 2u);
    window->document().undo_stack().setIndex(0);
    QCOMPARE(trigger("file.open", scenes / "a.brume"), there);
    // After a restart as well.
    QCOMPARE(last_folder(FileKind::import, "/"), to_qstring(meshes));
    fs::remove_all(meshes);
    QCOMPARE(last_folder(FileKind::import, "/"), "/");
  }
};

BRUME_APP_SUITE("files", FilesTest)
#include "files_test.moc"

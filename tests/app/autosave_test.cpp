// Unsaved work is kept and comes back.

#include <QProcess>
#include <QPushButton>
#include <csignal>
#include <fstream>
#include <functional>

#include "app/commands/gaussians/edit_medium.h"
#include "app/document/autosave.h"
#include "app/document/paths.h"
#include "app/files/scene_files.h"
#include "app/panels/lists/outliner.h"
#include "app/window/pages/recovery_bar.h"
#include "app/window/session_end.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/test_window.h"

using namespace brume;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> copies(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".brume") found.push_back(entry.path());
  }
  return found;
}

// Leaves the files of a killed session: its copy, and the lock of a process that is no more.
void leave_behind(const fs::path& folder, const Scene& scene, const fs::path& file) {
  fs::create_directories(folder);
  save_document(scene, folder / "killed.brume");
  std::ofstream(folder / "killed.ini") << "[General]\nfile=" << file.string() << '\n';
  std::ofstream(folder / "killed.lock") << "999999999\nbrume-editor\n"
                                        << QSysInfo::machineHostName().toStdString() << '\n';
}

fs::path recovery_folder() {
  return to_path(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)) / "recovery";
}

void save(Autosave& autosave) {
  autosave.save_soon();
  autosave.wait();
}

}  // namespace

class AutosaveTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void unsaved_work_is_backed_up_until_saved() {
    const TemporaryFolder folder;
    Document document;
    Autosave autosave(document, folder / "recovery", nullptr);
    save(autosave);
    QVERIFY(copies(folder / "recovery").empty());  // nothing to lose yet
    add_gaussian(document, {{1, 2, 3}, 1.0, 0.5});
    save(autosave);
    QCOMPARE(copies(folder / "recovery").size(), 1u);
    const fs::path copy = copies(folder / "recovery").front();
    QVERIFY(std::ranges::equal(load_scene(copy).medium.centers(), document.medium().centers()));
    add_gaussian(document, {{4, 5, 6}, 1.0, 0.5});
    save(autosave);
    QCOMPARE(load_scene(copy).medium.size(), 2u);
    document.save(folder / "saved.brume");
    QVERIFY(copies(folder / "recovery").empty());
    document.undo_stack().undo();
    save(autosave);
    QCOMPARE(copies(folder / "recovery").size(), 1u);
    document.undo_stack().redo();  // as saved
    QVERIFY(copies(folder / "recovery").empty());
  }

  void sessions_do_not_meet() {
    const TemporaryFolder folder;
    Document one;
    Document two;
    Autosave first(one, folder.path(), nullptr);
    Autosave second(two, folder.path(), nullptr);
    add_gaussian(one, {{}, 1.0, 0.5});
    add_gaussian(two, {{}, 2.0, 0.5});
    for (Autosave* autosave : {&first, &second}) save(*autosave);
    QCOMPARE(copies(folder.path()).size(), 2u);
    QVERIFY(first.recovery_files().empty());  // both live
    leave_behind(folder.path(), small_scene(), "/nowhere/fog.brume");
    const auto left = second.recovery_files();
    QCOMPARE(left.size(), 1u);
    QVERIFY(left[0].file == fs::path("/nowhere/fog.brume"));
    first.end();
    QCOMPARE(copies(folder.path()).size(), 2u);
    Autosave::forget(left[0]);
    QCOMPARE(copies(folder.path()).size(), 1u);
  }

  void a_full_disk_is_reported_once() {
    const TemporaryFolder temporary;
    const fs::path folder = temporary / "recovery";
    Document document;
    Autosave autosave(document, folder, nullptr);
    QSignalSpy failed(&autosave, &Autosave::failed);
    fs::remove_all(folder);
    for (int k = 0; k < 2; ++k) {
      add_gaussian(document, {{}, 1.0, 0.5});
      fs::remove_all(folder);
      std::ofstream(folder).close();  // a file where the folder was
      save(autosave);
    }
    QCOMPARE(failed.count(), 1);
    QVERIFY(!autosave.has_copy());
  }

  void what_ends_the_session_leaves_a_copy() {
    const std::function<void()> ends[]{
        [] { std::raise(SIGHUP); },
        [] { std::raise(SIGINT); },
        [] { std::raise(SIGTERM); },
        [] {
          QEvent quit(QEvent::Quit);
          QCoreApplication::sendEvent(qApp, &quit);
        },
    };
    for (const auto& end : ends) {
      fs::path copy;
      {
        TestWindow window;
        const SessionEnd session_end;
        QSignalSpy ended(&session_end, &SessionEnd::ended);
        connect(&session_end, &SessionEnd::announced, &*window, &MainWindow::keep_unsaved_work);
        window.key(Qt::Key_A, Qt::ShiftModifier);
        window->document().set_object(ObjectRef{ObjectRef::Kind::light, 0});
        window->findChild<Outliner*>()->rename_current();
        QTest::keyClicks(QApplication::focusWidget(), "Moon");
        end();
        QTRY_COMPARE(ended.count(), 1);
        QVERIFY(window->isVisible());
        QCOMPARE(copies(recovery_folder()).size(), 1u);
        copy = copies(recovery_folder()).front();
      }
      const Scene kept = load_scene(copy);
      QCOMPARE(kept.medium.size(), 6u);
      QCOMPARE(kept.lights[0].name, std::string("Moon"));
      Autosave::forget({copy, {}, {}});
    }
  }

  // The editor has the last copy of a file that was removed.
  void a_signal_ends_the_program_once_its_copy_is_written() {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "scene.brume";
    save_document(tiny_scene(), file);
    QProcess editor;
    editor.setProcessChannelMode(QProcess::ForwardedChannels);
    editor.start(BRUME_EDITOR, {to_qstring(file)});
    QTRY_VERIFY(SceneFiles::recent().contains(to_qstring(file)));  // loaded
    fs::remove(file);
    editor.terminate();
    QVERIFY(editor.waitForFinished(patience));
    QCOMPARE(editor.exitStatus(), QProcess::CrashExit);
    QCOMPARE(editor.exitCode(), SIGTERM);
    Document document;
    Autosave autosave(document, recovery_folder(), nullptr);
    const std::vector<RecoveryFile> offered = autosave.recovery_files();
    QCOMPARE(offered.size(), 1u);
    QCOMPARE(offered[0].file, file);
    QCOMPARE(load_scene(offered[0].scene).medium.size(), tiny_scene().medium.size());
    Autosave::forget(offered[0]);
  }

  void a_waiting_state_is_written_at_once() {
    const TemporaryFolder folder;
    Document document;
    Autosave autosave(document, folder.path(), nullptr);
    Medium medium;
    for (int k = 0; k < 100'000; ++k) medium.append({{0.001 * k, 0.0, 0.0}, 0.1, 0.001});
    Scene scene;
    scene.medium = std::move(medium);
    document.open(SceneDocument(std::move(scene)), {});
    add_gaussian(document, {{}, 1.0, 0.5});
    autosave.save_soon();  // once it pauses
    QVERIFY(copies(folder.path()).empty());
    autosave.save_now();
    QCOMPARE(copies(folder.path()).size(), 1u);
  }

  void it_is_offered_and_restored() {
    leave_behind(recovery_folder(), small_scene(), "/nowhere/fog.brume");
    {
      TestWindow window;
      auto* bar = window->findChild<RecoveryBar*>();
      QVERIFY(bar->isVisible());
      click(*bar, "later");
      QVERIFY(!bar->isVisible());
      window->close();
    }
    QCOMPARE(copies(recovery_folder()).size(), 1u);  // nothing was deleted
    TestWindow window;
    window->document().create();
    auto* bar = window->findChild<RecoveryBar*>();
    click(*bar, "restore");
    QTRY_COMPARE(window->document().medium().size(), 5u);
    QVERIFY(!bar->isVisible());
    QCOMPARE(window->windowTitle(), "fog.brume[*] – Brume");
    QVERIFY(window->isWindowModified());
    // The copy is now this session's.
    QCOMPARE(copies(recovery_folder()).size(), 1u);
    QVERIFY(copies(recovery_folder()).front().filename() != "killed.brume");
    QVERIFY(window->files().save_to(window.file("fog.brume")));
    QVERIFY(copies(recovery_folder()).empty());
  }

  void recovery_files_are_private() {
    const TemporaryFolder temporary;
    const fs::path folder = temporary / "data/recovery";
    fs::create_directories(folder);  // as an older version left them: 0755, 0644
    leave_behind(folder, small_scene(), "/nowhere/fog.brume");
    Document document;
    Autosave autosave(document, folder, nullptr);
    add_gaussian(document, {{}, 1.0, 0.5});
    for (int k = 0; k < 2; ++k) {
      save(autosave);
      add_gaussian(document, {{}, 1.0, 0.5});  // the second time the copy is replaced
    }
    QCOMPARE(autosave.recovery_files().size(), 1u);
    QCOMPARE(fs::status(folder).permissions(), fs::perms::owner_all);
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
      const fs::perms others = entry.status().permissions() & ~fs::perms::owner_all;
      QVERIFY2(others == fs::perms::none || entry.path().filename() == "killed.lock",
               entry.path().c_str());
      ++files;
    }
    QVERIFY(files >= 5);
  }

  void scene_pictures_are_private() {
    const TestWindow window;
    const QString cache = QStandardPaths::writableLocation(QStandardPaths::CacheLocation);
    const fs::path folder = to_path(cache) / "recent";
    QTRY_VERIFY(fs::exists(folder) && !fs::is_empty(folder));
    QCOMPARE(fs::status(folder).permissions(), fs::perms::owner_all);
    for (const auto& entry : fs::directory_iterator(folder)) {
      QCOMPARE(entry.status().permissions(), fs::perms::owner_read | fs::perms::owner_write);
    }
  }

  void old_recovery_files_are_removed() {
    const TemporaryFolder folder;
    Document document;
    Autosave autosave(document, folder.path(), nullptr);
    leave_behind(folder.path(), small_scene(), "/nowhere/fog.brume");
    const auto set_offered = [&](int days_ago) {
      QSettings about(to_qstring(folder / "killed.ini"), QSettings::IniFormat);
      about.setValue("offered", QDateTime::currentDateTimeUtc().addDays(-days_ago));
    };
    // Old, but never seen.
    fs::last_write_time(folder / "killed.brume",
                        fs::file_time_type::clock::now() - std::chrono::hours(24 * 400));
    QCOMPARE(autosave.recovery_files().size(), 1u);
    set_offered(Autosave::days_offered - 1);
    QCOMPARE(autosave.recovery_files().size(), 1u);
    Autosave::mark_offered(autosave.recovery_files().front());  // the first time counts
    set_offered(Autosave::days_offered + 1);
    Autosave::mark_offered({folder / "killed.brume", {}, {}});
    QVERIFY(autosave.recovery_files().empty());
    QVERIFY(copies(folder.path()).empty() && !fs::exists(folder / "killed.ini"));
  }

  void stale_session_files_are_removed() {
    const TemporaryFolder folder;
    Document document;
    Autosave autosave(document, folder.path(), nullptr);
    leave_behind(folder.path(), small_scene(), {});
    fs::remove(folder / "killed.brume");
    std::ofstream(folder / ".brume-1-0.tmp") << "half a copy";
    QVERIFY(autosave.recovery_files().empty());
    for (const char* name : {"killed.ini", "killed.lock", ".brume-1-0.tmp"}) {
      QVERIFY2(!fs::exists(folder / name), name);
    }
  }

  void it_can_be_discarded() {
    leave_behind(recovery_folder(), small_scene(), {});
    TestWindow window;
    auto* bar = window->findChild<RecoveryBar*>();
    const QSettings about(to_qstring(recovery_folder() / "killed.ini"), QSettings::IniFormat);
    QVERIFY(about.value("offered").toDateTime().isValid());  // noted
    click(*bar, "discard");
    QVERIFY(copies(recovery_folder()).empty());
    QVERIFY(!bar->isVisible());
  }
};

BRUME_APP_SUITE("autosave", AutosaveTest)
#include "autosave_test.moc"

#pragma once

#include <QDropEvent>
#include <QMimeData>
#include <filesystem>
#include <vector>

#include "app/document/paths.h"
#include "app/import/scene_import.h"
#include "app/jobs/background_job.h"
#include "app/window/file_jobs.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

namespace brume {

// A desk with what imports and exports files, as the window has it.
class FileDesk : public Desk {
 public:
  explicit FileDesk(const Scene& scene = small_scene()) : Desk(scene) {}

  BackgroundJob& job() { return job_; }
  SceneImport& import() { return import_; }

 private:
  BackgroundJob job_{BackgroundJob::Policy::one_at_a_time};
  SceneImport import_{document(), job_, this};
};

// Lets files, or what else has an address, fall onto the window.
inline void drop(TestWindow& window, const std::vector<std::filesystem::path>& files,
                 QList<QUrl> urls = {}) {
  QMimeData data;
  for (const std::filesystem::path& file : files) urls << QUrl::fromLocalFile(to_qstring(file));
  data.setUrls(urls);
  QVERIFY(drop_at(window, {10, 10}, data));
}
// Imports them as if they had fallen onto the window.
inline void drop(FileDesk& desk, const std::vector<std::filesystem::path>& files) {
  desk.import().import_files(files);
}

// Waits for what is done in the background; what went wrong, or nothing.
inline QString wait(BackgroundJob& job) {
  QString problem;
  const auto connection = QObject::connect(&job, &BackgroundJob::failed,
                                           [&problem](const QString& text) { problem = text; });
  const bool ended = QTest::qWaitFor([&job] { return !job.is_running(); }, patience);
  QObject::disconnect(connection);
  return ended ? problem : QString("it did not end");
}
inline QString wait(TestWindow& window) {
  return wait(window->file_jobs().job());
}
inline QString wait(FileDesk& desk) {
  return wait(desk.job());
}

// An open dialog of a kind; null if there is none.
template <class Dialog>
Dialog* shown(const QWidget& window) {
  auto* dialog = window.findChild<Dialog*>();
  return dialog && dialog->isVisible() ? dialog : nullptr;
}

}  // namespace brume

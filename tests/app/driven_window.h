#pragma once

#include <QAction>
#include <QDir>
#include <cstdio>

#include "app/document/paths.h"
#include "app/files/scene_files.h"
#include "app/widgets/application.h"
#include "tests/app/test_window.h"

namespace brume {

// The editor with the scene of a file, driven by mouse and keys to take pictures of it.
class DrivenWindow {
 public:
  DrivenWindow(const QString& scene, QSize size, QString folder) : folder_(std::move(folder)) {
    QDir().mkpath(folder_);
    window_.resize(size);
    window_.show();
    window_.activateWindow();
    allow_error(five_percent);
    open(scene);
  }

  [[nodiscard]] bool failed() const { return failed_; }

 protected:
  // Entries of the list Max error.
  static constexpr int two_percent = 1;
  static constexpr int five_percent = 2;
  void allow_error(int entry) { choose(window_, "max_error", entry); }

  void open(const QString& scene) {
    window_.files().open_file(std::filesystem::absolute(to_path(scene)));
    until([this] { return !window_.files().loading().is_running(); });
    settle();
  }

  Viewport& view() { return window_.viewport(); }

  bool until(const std::function<bool()>& done) {
    const bool is_done = QTest::qWaitFor(done, 600000);
    if (!is_done) failed_ = true;
    return is_done;
  }
  void settle() {
    until([this] { return view().isHidden() || view().frames().is_measured(); });
    QTest::qWait(300);  // until it is painted
  }

  void save(const QPixmap& picture, const QString& name) {
    if (!picture.save(folder_ + "/" + name + ".png")) failed_ = true;
    std::printf("%s\n", qPrintable(name));
    std::fflush(stdout);
  }

  void act(const char* action) { invoke(window_, action); }
  void hover(QPoint place) { QTest::mouseMove(&view(), place); }
  void press(QPoint place) { QTest::mousePress(&view(), Qt::LeftButton, {}, place); }
  void move(QPoint place) { move_mouse(view(), place); }
  void release(QPoint place) { QTest::mouseRelease(&view(), Qt::LeftButton, {}, place); }

  MainWindow window_;
  QString folder_;
  bool failed_ = false;
};

}  // namespace brume

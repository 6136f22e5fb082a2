#include "app/document/autosave.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QThreadPool>
#include <QUuid>
#include <algorithm>
#include <exception>

#include "app/document/document.h"
#include "app/document/paths.h"
#include "core/io/scene_file.h"

namespace brume {
namespace {

std::filesystem::path beside(std::filesystem::path scene, const char* extension) {
  return scene.replace_extension(extension);
}

std::filesystem::path prepared(const std::filesystem::path& folder) {
  QDir().mkpath(to_qstring(folder));
  return folder;
}

}  // namespace

Autosave::Autosave(Document& document, const std::filesystem::path& folder, QObject* parent)
    : QObject(parent),
      document_(document),
      folder_(prepared(folder)),
      copy_(folder_ /
            (QUuid::createUuid().toString(QUuid::WithoutBraces) + ".brume").toStdString()),
      lock_(to_qstring(beside(copy_, ".lock"))) {
  lock_.setStaleLockTime(0);  // for as long as the process lives
  lock_.tryLock(0);
  timer_.setInterval(interval);
  connect(&timer_, &QTimer::timeout, this, &Autosave::save_soon);
  timer_.start();
  connect(&document_, &Document::modified_changed, this, [this] {
    if (!document_.is_modified()) remove_copy();
  });
}

Autosave::~Autosave() {
  wait();
}

void Autosave::save_soon() {
  const std::uint64_t revision = document_.revision();
  if (writing_ || !document_.is_modified() || revision == written_revision_) return;
  writing_ = true;
  QSettings about(to_qstring(beside(copy_, ".ini")), QSettings::IniFormat);
  about.setValue("file", to_qstring(document_.file()));
  about.sync();
  QThreadPool::globalInstance()->start([this, revision, scene = document_.snapshot()] {
    QString problem;
    try {
      save_scene(*scene, copy_);
    } catch (const std::exception& error) {
      problem = QString::fromUtf8(error.what());
    }
    QMetaObject::invokeMethod(
        this, [this, revision, problem] { written(revision, problem); }, Qt::QueuedConnection);
  });
}

void Autosave::wait() {
  QThreadPool::globalInstance()->waitForDone();
  QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);  // written() hears of it
}

void Autosave::written(std::uint64_t revision, const QString& problem) {
  writing_ = false;
  if (!problem.isEmpty()) {
    // Once: it will hardly be better in half a minute.
    if (!complained_) Q_EMIT failed(tr("Unsaved work is not being kept: %1").arg(problem));
    complained_ = true;
    return;
  }
  written_revision_ = revision;
  if (!document_.is_modified()) remove_copy();
}

void Autosave::end() {
  timer_.stop();
  wait();
  remove_copy();
}

void Autosave::remove_copy() {
  written_revision_ = 0;
  std::error_code ignored;
  std::filesystem::remove(copy_, ignored);
  std::filesystem::remove(beside(copy_, ".ini"), ignored);
}

std::vector<LeftBehind> Autosave::left_behind() const {
  std::vector<LeftBehind> all;
  for (const QFileInfo& info : QDir(to_qstring(folder_)).entryInfoList({"*.brume"}, QDir::Files)) {
    const std::filesystem::path scene = to_path(info.absoluteFilePath());
    QLockFile lock(to_qstring(beside(scene, ".lock")));
    lock.setStaleLockTime(0);
    if (scene.filename() == copy_.filename() || !lock.tryLock(0)) continue;  // its session lives
    const QSettings about(to_qstring(beside(scene, ".ini")), QSettings::IniFormat);
    all.push_back({scene, to_path(about.value("file").toString()), info.lastModified()});
  }
  std::sort(all.begin(), all.end(),
            [](const LeftBehind& a, const LeftBehind& b) { return a.when > b.when; });
  return all;
}

void Autosave::forget(const LeftBehind& work) {
  std::error_code ignored;
  for (const char* extension : {".brume", ".ini", ".lock"}) {
    std::filesystem::remove(beside(work.scene, extension), ignored);
  }
}

}  // namespace brume

#include "app/document/autosave.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QThreadPool>
#include <QUuid>
#include <algorithm>
#include <exception>
#include <utility>

#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/document/private_files.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/scene/scene_file.h"

namespace brume {
namespace {

constexpr const char* interval_key = "autosave/seconds";
constexpr int default_interval = 20;  // [s]

// To write so many takes a core for seconds, which a gesture would feel: it waits for a pause.
constexpr std::size_t many_gaussians = 100'000;
constexpr int pause = 2000;    // milliseconds without a change
constexpr int max_waits = 30;  // then it writes all the same

std::filesystem::path beside(std::filesystem::path scene, const char* extension) {
  return scene.replace_extension(extension);
}

// The description of a copy, in a file beside it.
class About {
 public:
  explicit About(const std::filesystem::path& scene)
      : file_(beside(scene, ".ini")), values_(to_qstring(file_), QSettings::IniFormat) {}
  ~About() {
    values_.sync();
    make_private(file_);
  }
  About(const About&) = delete;
  About& operator=(const About&) = delete;

  QSettings& operator*() { return values_; }
  QSettings* operator->() { return &values_; }

 private:
  std::filesystem::path file_;
  QSettings values_;
};

}  // namespace

Autosave::Autosave(Document& document, const std::filesystem::path& folder, QObject* parent)
    : QObject(parent),
      document_(document),
      folder_(make_private_folder(folder)),
      copy_(folder_ /
            (QUuid::createUuid().toString(QUuid::WithoutBraces) + ".brume").toStdString()),
      lock_(to_qstring(beside(copy_, ".lock"))) {
  lock_.setStaleLockTime(0);  // for as long as the process lives
  lock_.tryLock(0);
  make_private(beside(copy_, ".lock"));
  timer_.setInterval(1000 * std::max(1, QSettings().value(interval_key, default_interval).toInt()));
  connect(&timer_, &QTimer::timeout, this, &Autosave::save_soon);
  timer_.start();
  pause_timer_.setSingleShot(true);
  connect(&pause_timer_, &QTimer::timeout, this, &Autosave::save_soon);
  on_change(document_, Change::modified, this, [this] {
    if (!document_.is_modified()) remove_copy();
  });
}

int Autosave::interval() const {
  return timer_.interval() / 1000;
}

void Autosave::set_interval(int seconds) {
  QSettings().setValue(interval_key, seconds);
  timer_.setInterval(1000 * seconds);
}

Autosave::~Autosave() {
  wait();
}

void Autosave::save_soon() {
  const std::uint64_t revision = document_.revision();
  if (writing_ || !document_.is_modified() || revision == written_revision_) return;
  if (document_.medium().size() >= many_gaussians && waits_ < max_waits &&
      std::exchange(waited_revision_, revision) != revision) {
    ++waits_;
    return pause_timer_.start(pause);
  }
  waits_ = 0;
  writing_ = true;
  {
    About about(copy_);
    about->setValue("file", to_qstring(document_.file()));
    const std::optional<FileVersion>& version = document_.file_version();
    about->setValue("version", version ? QString::fromStdString(version->text()) : QString());
  }
  QThreadPool::globalInstance()->start(
      [this, revision, scene = document_.snapshot(), extras = document_.extras()] {
        QString problem;
        try {
          write_private(copy_, document_to_json({*scene, extras}, copy_.parent_path()));
        } catch (const std::exception& error) {
          problem = QString::fromUtf8(error.what());
        }
        QMetaObject::invokeMethod(
            this, [this, revision, problem] { written(revision, problem); }, Qt::QueuedConnection);
      });
}

void Autosave::save_now() {
  wait();  // an older state may be being written
  waits_ = max_waits;
  save_soon();
  wait();
}

void Autosave::wait() {
  QThreadPool::globalInstance()->waitForDone();
  QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);  // written() hears of it
}

void Autosave::written(std::uint64_t revision, const QString& problem) {
  writing_ = false;
  if (!problem.isEmpty()) {
    // Once: it will hardly be better in half a minute.
    if (!complained_) Q_EMIT failed(tr("Autosave failed: %1").arg(problem));
    complained_ = true;
    return;
  }
  written_revision_ = revision;
  if (!document_.is_modified()) remove_copy();
}

void Autosave::end() {
  timer_.stop();
  pause_timer_.stop();
  wait();
  remove_copy();
}

void Autosave::remove_copy() {
  written_revision_ = 0;
  std::error_code ignored;
  std::filesystem::remove(copy_, ignored);
  std::filesystem::remove(beside(copy_, ".ini"), ignored);
}

std::vector<RecoveryFile> Autosave::recovery_files() {
  std::vector<RecoveryFile> all;
  std::vector<RecoveryFile> old;
  const QDateTime now = QDateTime::currentDateTimeUtc();
  for (const QFileInfo& info : QDir(to_qstring(folder_)).entryInfoList({"*.brume"}, QDir::Files)) {
    const std::filesystem::path scene = to_path(info.absoluteFilePath());
    QLockFile lock(to_qstring(beside(scene, ".lock")));
    lock.setStaleLockTime(0);
    if (scene.filename() == copy_.filename() || !lock.tryLock(0)) continue;  // its session lives
    make_private(scene);  // older versions were less careful
    About about(scene);
    const RecoveryFile work{scene, to_path(about->value("file").toString()), info.lastModified(),
                            FileVersion::parse(about->value("version").toString().toStdString())};
    const bool is_old = about->value("offered", now).toDateTime().daysTo(now) > days_offered;
    (is_old ? old : all).push_back(work);
  }
  for (const RecoveryFile& work : old) forget(work);
  sweep();
  std::sort(all.begin(), all.end(),
            [](const RecoveryFile& a, const RecoveryFile& b) { return a.when > b.when; });
  return all;
}

// Removes what belongs to no copy: left by sessions that were killed before they made one, or while
// they did.
void Autosave::sweep() {
  std::error_code ignored;
  for (const QFileInfo& info : QDir(to_qstring(folder_)).entryInfoList({"*.lock"}, QDir::Files)) {
    const std::filesystem::path file = to_path(info.absoluteFilePath());
    if (std::filesystem::exists(beside(file, ".brume"), ignored)) continue;
    QLockFile lock(to_qstring(file));
    lock.setStaleLockTime(0);
    if (file.stem() == copy_.stem() || !lock.tryLock(0)) continue;  // its session lives
    std::filesystem::remove(beside(file, ".ini"), ignored);
  }  // the lock itself goes with its QLockFile
  remove_abandoned_files(folder_);
}

void Autosave::mark_offered(const RecoveryFile& work) {
  About about(work.scene);
  if (about->contains("offered")) return;
  about->setValue("offered", QDateTime::currentDateTimeUtc());
}

void Autosave::forget(const RecoveryFile& work) {
  std::error_code ignored;
  for (const char* extension : {".brume", ".ini", ".lock"}) {
    std::filesystem::remove(beside(work.scene, extension), ignored);
  }
}

}  // namespace brume

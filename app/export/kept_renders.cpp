#include "app/export/kept_renders.h"

#include <QDir>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>
#include <exception>

#include "app/document/paths.h"
#include "app/document/private_files.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/scene/scene_file.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr const char* record_extension = ".json";
constexpr const char* scene_extension = ".brume";
constexpr const char* lock_extension = ".lock";

void remove_file(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
}

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(file, ignored);
}

}  // namespace

fs::path kept_renders_folder() {
  return to_path(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)) / "renders";
}

KeptRenders::KeptRenders(const fs::path& folder, QObject* parent)
    : QObject(parent), folder_(make_private_folder(folder)) {
  pool_.setMaxThreadCount(1);
}

KeptRenders::~KeptRenders() {
  pool_.waitForDone();
  for (const auto& [name, lock] : locks_) {
    if (!is_there(file(name, record_extension))) remove_file(file(name, scene_extension));
  }
}

fs::path KeptRenders::file(const QString& name, const char* extension) const {
  return folder_ / (name + extension).toStdString();
}

std::unique_ptr<QLockFile> KeptRenders::lock(const QString& name) const {
  const fs::path path = file(name, lock_extension);
  auto lock = std::make_unique<QLockFile>(to_qstring(path));
  lock->setStaleLockTime(0);  // for as long as the process lives
  if (!lock->tryLock(0)) return nullptr;
  make_private(path);
  return lock;
}

std::vector<KeptRenders::Left> KeptRenders::take() {
  std::vector<Left> all;
  QStringList names;
  for (const QFileInfo& info : QDir(to_qstring(folder_)).entryInfoList(QDir::Files)) {
    const bool is_render = QStringList{"json", "brume", "lock"}.contains(info.suffix());
    if (is_render && !names.contains(info.completeBaseName())) names << info.completeBaseName();
  }
  for (const QString& name : names) {
    auto held = locks_.contains(name) ? nullptr : lock(name);
    if (!held) continue;
    const fs::path record = file(name, record_extension);
    if (!is_there(record)) {  // done or cancelled, or its session was killed before it was written
      remove_file(file(name, scene_extension));
      continue;
    }
    Left left{name, {}, {}};
    try {
      left.render = read_record(record, file(name, scene_extension));
    } catch (const std::exception& error) {
      left.problem = QString::fromUtf8(error.what());
    }
    all.push_back(std::move(left));
    locks_.emplace(name, std::move(held));
  }
  remove_abandoned_files(folder_);
  std::ranges::stable_sort(all, {}, [](const Left& left) { return left.render.place; });
  return all;
}

void KeptRenders::write(std::function<void()> work) {
  pool_.start([this, work = std::move(work)] {
    try {
      work();
    } catch (const std::exception& error) {
      const QString why = QString::fromUtf8(error.what());
      const auto tell = [this, why] {
        if (std::exchange(has_failed_, true)) return;
        Q_EMIT failed(tr("Renders cannot be kept for the next session: %1").arg(why));
      };
      QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
    }
  });
}

QString KeptRenders::keep(const FrameExportRequest& request, double place) {
  const QString name = QUuid::createUuid().toString(QUuid::WithoutBraces);
  locks_.emplace(name, lock(name));
  write([scene = file(name, scene_extension), request] {
    write_private(scene, document_to_json(scene_to_keep(request), scene.parent_path()));
  });
  update(name, request, place);
  return name;
}

void KeptRenders::update(const QString& name, const FrameExportRequest& request, double place) {
  write(
      [record = file(name, record_extension), scene = file(name, scene_extension), request, place] {
        if (!is_there(scene)) return;
        write_private(record, record_text(request, place).toStdString());
      });
}

void KeptRenders::drop_record(const QString& name) {
  write([record = file(name, record_extension)] { remove_file(record); });
}

void KeptRenders::remove(const QString& name) {
  drop_record(name);
  write([this, name] {
    remove_file(file(name, scene_extension));
    QMetaObject::invokeMethod(
        this, [this, name] { locks_.erase(name); }, Qt::QueuedConnection);
  });
}

}  // namespace brume

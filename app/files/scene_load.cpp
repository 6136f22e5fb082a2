#include "app/files/scene_load.h"

#include <QStringList>
#include <exception>

#include "app/document/paths.h"

namespace brume {

SceneLoad::SceneLoad(QWidget* parent)
    : JobBar(parent), thread_([this](const std::stop_token& quit) { work(quit); }) {
  connect(this, &JobBar::cancel_clicked, this, &SceneLoad::cancel);
}

SceneLoad::~SceneLoad() {
  thread_.request_stop();
  thread_.join();
}

void SceneLoad::start(const std::filesystem::path& file, const FoundFiles& found) {
  running_ = true;
  show_job(tr("Opening %1").arg(to_qstring(file.filename())));
  const std::scoped_lock lock(mutex_);
  pending_ = Job{file, found, ++serial_};
  wake_.notify_one();
}

// Reading itself is not broken off; what comes of it is dropped.
void SceneLoad::cancel() {
  if (!running_) return;
  running_ = false;
  hide();
  {
    const std::scoped_lock lock(mutex_);
    ++serial_;
    pending_.reset();
  }
  Q_EMIT cancelled();
}

void SceneLoad::work(const std::stop_token& quit) {
  while (true) {
    Job job;
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, quit, [this] { return pending_.has_value(); })) return;
      job = std::move(*pending_);
      pending_.reset();
    }
    auto loaded = std::make_shared<LoadedScene>();
    QString problem;
    try {
      loaded->file = std::filesystem::absolute(job.file);
      std::vector<std::string> warnings;
      // First: a change while the scene is being read is one that it may have missed.
      loaded->version = FileVersion::read(loaded->file);
      loaded->missing.found = job.found;
      loaded->document = load_document(loaded->file, &warnings, loaded->missing);
      QStringList lines;
      for (const std::string& warning : warnings) lines << QString::fromStdString(warning);
      loaded->warnings = lines.join('\n');
    } catch (const std::exception& error) {
      problem = QString::fromUtf8(error.what());
    }
    QMetaObject::invokeMethod(
        this, [=, this] { end(job.serial, loaded, problem); }, Qt::QueuedConnection);
  }
}

void SceneLoad::end(std::uint64_t serial, const std::shared_ptr<LoadedScene>& scene,
                    const QString& problem) {
  if (serial != serial_) return;  // cancelled, or another was started
  running_ = false;
  hide();
  if (problem.isEmpty()) {
    Q_EMIT loaded(scene);
  } else {
    Q_EMIT failed(problem);
  }
}

}  // namespace brume

#pragma once

#include <QString>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "app/jobs/job_bar.h"
#include "core/io/file_version.h"
#include "core/io/scene/missing_files.h"

namespace brume {

struct LoadedScene {
  std::filesystem::path file;  // absolute
  SceneDocument document;
  std::optional<FileVersion> version;  // of the file that was read
  MissingFiles missing;
  QString warnings;  // one a line
};

// Loads scene files in a background thread.
class SceneLoad : public JobBar {
  Q_OBJECT
 public:
  explicit SceneLoad(QWidget* parent = nullptr);
  ~SceneLoad() override;

  // Cancels a running load. Files are read from their new location in `found`.
  void start(const std::filesystem::path& file, const FoundFiles& found = {});
  void cancel();
  [[nodiscard]] bool is_running() const { return running_; }

 Q_SIGNALS:
  void loaded(std::shared_ptr<brume::LoadedScene> scene);
  void cancelled();
  void failed(const QString& message);

 private:
  struct Job {
    std::filesystem::path file;
    FoundFiles found;
    std::uint64_t serial = 0;
  };
  void work(const std::stop_token& quit);
  void end(std::uint64_t serial, const std::shared_ptr<LoadedScene>& scene, const QString& problem);

  bool running_ = false;
  std::uint64_t serial_ = 0;  // of the last job
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<Job> pending_;
  std::jthread thread_;
};

}  // namespace brume

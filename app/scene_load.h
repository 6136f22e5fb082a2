#pragma once

#include <QString>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "app/job_bar.h"
#include "core/io/file_version.h"
#include "core/io/missing_files.h"
#include "core/scene/scene.h"

namespace brume {

struct LoadedScene {
  std::filesystem::path file;  // absolute
  Scene scene;
  std::optional<FileVersion> version;  // of the file that was read
  MissingFiles missing;
  QString warnings;  // one a line
};

// Reads scene files in a thread of its own.
class SceneLoad : public JobBar {
  Q_OBJECT
 public:
  explicit SceneLoad(QWidget* parent = nullptr);
  ~SceneLoad() override;

  // Instead of the file being read, if any: its scene will not come any more. Files that the scene
  // refers to are read where `found` says.
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

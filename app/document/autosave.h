#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/io/disk/file_version.h"

namespace brume {

class Document;

// Unsaved work of a crashed session.
struct RecoveryFile {
  std::filesystem::path scene;  // the recovery copy
  std::filesystem::path file;   // the original scene file; empty for a new scene
  QDateTime when;
  std::optional<FileVersion> version = {};  // of `file`, when editing began
};

// Backs up unsaved work every 20 seconds, or as often as the setting autosave/seconds says. Each
// session has its own file, with a lock while it runs. The copy is deleted when work is saved or
// discarded; those of crashed sessions by the user, or a month after first being offered. Files are
// private to the user.
class Autosave : public QObject {
  Q_OBJECT
 public:
  [[nodiscard]] int interval() const;  // [s]
  void set_interval(int seconds);      // for later sessions, too

  Autosave(Document& document, const std::filesystem::path& folder, QObject* parent);
  ~Autosave() override;  // keeps the copy; only end() deletes it

  // Starts writing the current state in the background, unless saved or written already.
  void save_soon();
  // Has written the current state when it returns, unless that is saved or cannot be written.
  void save_now();
  void wait();  // until writing has finished
  void end();   // the work is saved or discarded

  [[nodiscard]] bool has_copy() const { return written_revision_ != 0; }

  static constexpr int days_offered = 30;

  // Recovery files, newest first. Deletes those first offered more than `days_offered` ago, and
  // other remains of crashed sessions.
  std::vector<RecoveryFile> recovery_files();
  static void mark_offered(const RecoveryFile& work);  // shown to the user
  static void forget(const RecoveryFile& work);

 Q_SIGNALS:
  void failed(const QString& message);

 private:
  void written(std::uint64_t revision, const QString& problem);
  void sweep();
  void remove_copy();

  Document& document_;
  std::filesystem::path folder_;
  std::filesystem::path copy_;
  QLockFile lock_;
  QTimer timer_;
  bool writing_ = false;
  bool complained_ = false;
  std::uint64_t written_revision_ = 0;
  // Very many Gaussians are saved only in a pause:
  QTimer pause_timer_;
  std::uint64_t waited_revision_ = 0;
  int waits_ = 0;
};

}  // namespace brume

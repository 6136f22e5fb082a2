#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/io/file_version.h"

namespace brume {

class Document;

// Unsaved work that a session which did not end properly has left in the recovery folder.
struct LeftBehind {
  std::filesystem::path scene;  // what can be restored
  std::filesystem::path file;   // of which this is a later state; empty for a new scene
  QDateTime when;
  std::optional<FileVersion> version = {};  // of `file`, when this state of it was begun
};

// Keeps a copy of unsaved work in a folder, so that a crash costs half a minute at most. Each
// session has a file of its own, with a lock that says that it lives, so several sessions never
// meet. A session deletes its own copy when the work is saved or given up; what others left behind
// goes when the user says so, or a month after it was first offered. Nobody else can read any.
class Autosave : public QObject {
  Q_OBJECT
 public:
  static constexpr int interval = 20'000;  // milliseconds

  Autosave(Document& document, const std::filesystem::path& folder, QObject* parent);
  ~Autosave() override;  // keeps the copy: only end() gives it up

  // Begins to write the present state in the background, unless it is saved or written already.
  void save_soon();
  void wait();  // until what has begun is done
  void end();   // the work is saved, or the user does not want it

  [[nodiscard]] bool has_copy() const { return written_revision_ != 0; }

  static constexpr int days_offered = 30;

  // The newest first. Deletes those that were offered first more than `days_offered` ago, and what
  // else dead sessions left in the folder.
  std::vector<LeftBehind> left_behind();
  static void note_offered(const LeftBehind& work);  // the user sees it
  static void forget(const LeftBehind& work);

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
};

}  // namespace brume

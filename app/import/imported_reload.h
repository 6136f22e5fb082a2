#pragma once

#include <QObject>
#include <filesystem>
#include <map>

#include "app/jobs/background_job.h"

namespace brume {

class Document;

// Reads imported scenes anew whose files another program has changed, in the background, each as
// one undo step.
class ImportedReload : public QObject {
  Q_OBJECT
 public:
  explicit ImportedReload(Document& document, QObject* parent = nullptr);

  // Does so where it is necessary; quick where it is not.
  void check();

 Q_SIGNALS:
  void failed(const QString& message);
  void warned(const QString& message);

 private:
  Document& document_;
  // Changes that could not be read, which are not tried again.
  std::map<std::filesystem::path, std::filesystem::file_time_type> failed_;
  BackgroundJob job_{BackgroundJob::Policy::one_at_a_time};
};

}  // namespace brume

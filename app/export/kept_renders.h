#pragma once

#include <QLockFile>
#include <QObject>
#include <QThreadPool>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "app/export/render_record.h"

namespace brume {

// The user's folder of them, beside that of recovery.
std::filesystem::path kept_renders_folder();

// Renders in a private folder, so that a later session has those that this one does not finish.
// Each has a scene file, a record (render_record.h) and a lock while its session lives; without a
// record it is not taken up again. Files are written in the background, in order.
class KeptRenders : public QObject {
  Q_OBJECT
 public:
  explicit KeptRenders(const std::filesystem::path& folder, QObject* parent = nullptr);
  ~KeptRenders() override;  // waits until all is written

  struct Left {
    QString name;
    RenderRecord render;
    QString problem;  // why it cannot be read; empty: it can
  };
  // Takes over what sessions left that run no more, in the order of their places, and sweeps the
  // folder.
  std::vector<Left> take();

  QString keep(const FrameExportRequest& request, double place);  // its name
  // Writes the record anew.
  void update(const QString& name, const FrameExportRequest& request, double place);
  // Removes the record; the scene stays while this session may ask for it.
  void drop_record(const QString& name);
  void remove(const QString& name);

 Q_SIGNALS:
  void failed(const QString& message);  // once: it will hardly be better for the next

 private:
  [[nodiscard]] std::filesystem::path file(const QString& name, const char* extension) const;
  // Nullptr: another session has it.
  [[nodiscard]] std::unique_ptr<QLockFile> lock(const QString& name) const;
  void write(std::function<void()> work);

  std::filesystem::path folder_;
  bool has_failed_ = false;
  std::map<QString, std::unique_ptr<QLockFile>> locks_;
  QThreadPool pool_;
};

}  // namespace brume

#pragma once

#include <QImage>
#include <QObject>
#include <map>

#include "app/assets/asset_files.h"
#include "app/jobs/background_job.h"

namespace brume {

// Thumbnails of assets, rendered in the background and kept in the user's cache until their file
// changes.
class AssetPictures : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  // Makes those of all assets that have one, one after the other; what was still to be made is
  // dropped.
  void make(const std::vector<Asset>& assets);
  void cancel() { job_.cancel(); }

 Q_SIGNALS:
  void made(std::size_t asset, const QImage& picture);  // by its place among these

 private:
  // The versions of files that have no picture; only the job's thread uses it.
  std::map<std::filesystem::path, QString> without_;
  BackgroundJob job_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume

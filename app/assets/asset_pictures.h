#pragma once

#include <QImage>
#include <QObject>

#include "app/assets/asset_files.h"
#include "app/jobs/background_job.h"

namespace brume {

// Thumbnails of assets, rendered in the background and kept in the user's cache until their file
// changes.
class AssetPictures : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  // Of all assets that have one, one after the other; what was still to be made is dropped.
  void make(const std::vector<Asset>& assets);

 Q_SIGNALS:
  void made(std::size_t asset, const QImage& picture);  // by its place among these

 private:
  BackgroundJob job_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume

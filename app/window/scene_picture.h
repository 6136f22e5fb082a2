#pragma once

#include <QObject>
#include <filesystem>
#include <utility>

namespace brume {

class Document;
class Viewport;

// Keeps a small picture of each scene as it is in its file, for the start page and the menu of
// recent files.
class ScenePicture : public QObject {
  Q_OBJECT
 public:
  ScenePicture(const Document& document, const Viewport& view, QObject* parent);

 private:
  void save();

  const Document& document_;
  const Viewport& view_;
  std::pair<std::filesystem::path, std::uint64_t> saved_;  // file and revision
};

}  // namespace brume

#pragma once

#include <QTreeWidget>

namespace brume {

class Document;

// The scene as a tree; a click requests the panel of an item.
class Outliner : public QTreeWidget {
  Q_OBJECT
 public:
  enum class Kind { gaussians, medium, emitter, light, environment, surface };
  explicit Outliner(Document& document, QWidget* parent = nullptr);

 Q_SIGNALS:
  void asked_for(brume::Outliner::Kind kind, std::size_t index);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void rebuild();
  void count_gaussians();

  Document& document_;
  QTreeWidgetItem* gaussians_ = nullptr;
};

}  // namespace brume

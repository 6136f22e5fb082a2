#pragma once

#include <QUndoCommand>
#include <cstdint>

namespace brume {

class Document;

// Base of commands that change the scene and so mark the document as modified. A command that is
// obsolete from the start does nothing.
class SceneCommand : public QUndoCommand {
 public:
  SceneCommand(Document& document, const QString& text);

  void undo() final;
  void redo() final;
  bool mergeWith(const QUndoCommand* later) final;

 protected:
  virtual void apply() = 0;
  virtual void revert() = 0;
  // Merges a later command of the same id; false if not possible. May set this obsolete.
  virtual bool merge(const SceneCommand& later) = 0;

  Document& document_;

 private:
  std::uint64_t before_;
  std::uint64_t after_;
};

}  // namespace brume

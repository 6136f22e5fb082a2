#pragma once

#include <QUndoCommand>
#include <cstdint>

namespace brume {

class Document;

// A change of the scene, as opposed to one of the selection: what makes a document unsaved. A
// command that is obsolete from the start does nothing.
class SceneCommand : public QUndoCommand {
 public:
  SceneCommand(Document& document, const QString& text);

  void undo() final;
  void redo() final;
  bool mergeWith(const QUndoCommand* later) final;

 protected:
  virtual void apply() = 0;
  virtual void revert() = 0;
  // Whether a later command of the same id could be taken into this one. It may set this obsolete.
  virtual bool take(const SceneCommand& later) = 0;

  Document& document_;

 private:
  std::uint64_t before_;
  std::uint64_t after_;
};

}  // namespace brume

#pragma once

#include "app/commands/scene_command.h"
#include "app/document/scene_part.h"
#include "brume/edits.h"

namespace brume {

// Replaces the groups, and changes the Gaussians that are in them, as one step. No step if nothing
// changes.
class GroupCommand : public SceneCommand {
 public:
  GroupCommand(Document& document, Groups groups, MediumEdit edit, const QString& text);

 protected:
  void apply() override;
  void revert() override;
  bool merge(const SceneCommand& /*later*/) override { return false; }

 private:
  Groups before_;
  Groups after_;
  MediumEdit edit_;
  std::vector<GaussianId> selection_before_;
};

}  // namespace brume

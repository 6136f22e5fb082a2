#pragma once

#include <functional>

#include "app/commands/gaussians/medium_command.h"

namespace brume {

class Document;

// Merges the medium edits of one mouse gesture into one undo step.
class EditGesture {
 public:
  explicit EditGesture(Document& document) : document_(document) {}

  void begin();
  // Applies an edit if the Gaussian budget allows; `text` names the whole step.
  void apply(MediumEdit edit, const QString& text);
  // The same, with a text made of the merged edit.
  void apply(MediumEdit edit, const std::function<QString(const MediumEdit&)>& text);
  void cancel();  // reverts everything and removes the step
  void end() { running_ = false; }

  [[nodiscard]] bool is_running() const { return running_; }
  // Whether a current change of the document comes from this gesture.
  [[nodiscard]] bool is_applying() const { return applying_; }
  // The merged edit so far.
  [[nodiscard]] const MediumEdit& edit() const { return edit_; }

 private:
  void push(MediumEdit edit, const QString& text);

  Document& document_;
  MediumEdit edit_;
  MergeId merge_id_ = no_merge;
  bool running_ = false;
  bool applying_ = false;
};

}  // namespace brume

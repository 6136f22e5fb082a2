#pragma once

#include "app/commands/medium_command.h"

namespace brume {

class Document;

// The edits of the medium that one gesture of the mouse makes: together one undo step.
class EditGesture {
 public:
  explicit EditGesture(Document& document) : document_(document) {}

  void begin();
  // Does an edit, if there is room for what it adds; `text` names the whole step so far.
  void apply(MediumEdit edit, const QString& text);
  void cancel();  // takes all of it back, and the step with it
  void end() { running_ = false; }

  [[nodiscard]] bool is_running() const { return running_; }
  // Whether the document is being changed by this gesture just now, and by nobody else.
  [[nodiscard]] bool is_applying() const { return applying_; }
  // All that was done so far.
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

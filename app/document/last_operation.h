#pragma once

#include <QObject>
#include <QString>
#include <any>
#include <functional>
#include <optional>

class QUndoCommand;
class QUndoStack;

namespace brume {

// The operation that was done last, with the numbers it was done by, to be adjusted: its undo step
// is taken back and it is done again, so that it stays one step; one that is refused or fails then
// stays as it was. It is there until something else is done, undone or redone.
class LastOperation : public QObject {
  Q_OBJECT
 public:
  struct Operation {
    QString title;
    std::any numbers;
    // Does it, as at most one undo step; what runs in the background calls complete() at its end.
    std::function<void(const std::any& numbers)> run;
    bool runs_in_background = false;  // its end is dropped once changed() tells of another one
  };

  explicit LastOperation(QUndoStack& stack);

  void perform(const Operation& operation);
  // The same for one that `work` does for the first time.
  void record(const Operation& operation, const std::function<void()>& work);
  // Does it again, by other numbers.
  void adjust(const std::any& numbers);
  // Takes its step back and does `work` in its place. False: that made no step, and the step it
  // had is there again.
  bool complete(const std::function<void()>& work);
  void forget();

  [[nodiscard]] const std::optional<Operation>& operation() const { return operation_; }
  [[nodiscard]] bool is_adjusting() const { return is_adjusting_; }

 Q_SIGNALS:
  void changed();  // there is another one, or none

 private:
  void follow();
  [[nodiscard]] const QUndoCommand* last_step() const;

  QUndoStack& stack_;
  std::optional<Operation> operation_;
  const QUndoCommand* former_ = nullptr;  // the step before it; null: none
  const QUndoCommand* step_ = nullptr;    // null: it has none, or not yet
  bool is_working_ = false;
  bool is_adjusting_ = false;
};

}  // namespace brume

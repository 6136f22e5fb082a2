#include "app/document/last_operation.h"

#include <QUndoStack>
#include <utility>

namespace brume {

LastOperation::LastOperation(QUndoStack& stack) : stack_(stack) {
  connect(&stack, &QUndoStack::indexChanged, this, &LastOperation::follow);
}

void LastOperation::perform(const Operation& operation) {
  record(operation, [&operation] { operation.run(operation.numbers); });
  if (!step_) forget();  // it was refused
}

void LastOperation::record(const Operation& operation, const std::function<void()>& work) {
  operation_ = operation;
  former_ = last_step();
  step_ = nullptr;
  complete(work);
  Q_EMIT changed();
}

bool LastOperation::complete(const std::function<void()>& work) {
  is_working_ = true;
  if (step_) stack_.undo();
  work();
  const bool has_made_step = last_step() != former_;
  if (step_ && !has_made_step) stack_.redo();
  is_working_ = false;
  const int former = stack_.index() - 2;
  const bool is_one = former < 0 || stack_.command(former) == former_;
  step_ = operation_ && last_step() != former_ && is_one ? last_step() : nullptr;
  return has_made_step;
}

void LastOperation::adjust(const std::any& numbers) {
  if (!operation_) return;
  std::any former = std::exchange(operation_->numbers, numbers);
  const auto run = [this] { operation_->run(operation_->numbers); };
  is_adjusting_ = true;
  if (operation_->runs_in_background) {
    run();
  } else if (!complete(run) && operation_) {
    operation_->numbers = std::move(former);
  }
  is_adjusting_ = false;
}

void LastOperation::forget() {
  if (!operation_) return;
  operation_.reset();
  step_ = nullptr;
  Q_EMIT changed();
}

void LastOperation::follow() {
  if (is_working_ || !operation_) return;
  if (last_step() != (step_ ? step_ : former_)) forget();
}

const QUndoCommand* LastOperation::last_step() const {
  return stack_.index() > 0 ? stack_.command(stack_.index() - 1) : nullptr;
}

}  // namespace brume

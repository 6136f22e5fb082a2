#pragma once

#include <array>
#include <cstddef>

namespace brume {

// When a view renders in motion and when at rest: a machine of states and events, without a clock.
// Its owner counts the time without a change, and does what each step asks for.
class FramePacing {
 public:
  enum class State {
    rest,    // nothing is due
    moving,  // the picture has changed; none of the present state is shown
    shown,   // as before, but its picture in motion is
    ending,  // the gesture is over: the full frame follows the last picture of it at once
  };
  enum class Event {
    change,
    gesture_end,
    picture,  // one of the present state is shown
    quiet,    // for a while, nothing has changed
  };
  enum class Action {
    none,
    render_in_motion,  // and wait for quiet
    wait_no_longer,    // quiet comes with the next turn of the event loop
    render_at_rest,
  };

  [[nodiscard]] State state() const { return state_; }
  Action on(Event event) {
    const Step& step = steps[index(state_)][index(event)];
    state_ = step.next;
    return step.action;
  }

  struct Step {
    State next;
    Action action;
  };

 private:
  static constexpr std::size_t index(auto value) { return static_cast<std::size_t>(value); }
  using enum State;
  using enum Action;
  // The steps stand by state and event, in the order above.
  static constexpr std::array<std::array<Step, 4>, 4> steps{{
      {{{moving, render_in_motion}, {rest, none}, {rest, none}, {rest, none}}},
      {{{moving, render_in_motion}, {ending, none}, {shown, none}, {rest, render_at_rest}}},
      {{{moving, render_in_motion},
        {ending, wait_no_longer},
        {shown, none},
        {rest, render_at_rest}}},
      {{{moving, render_in_motion},
        {ending, none},
        {ending, wait_no_longer},
        {rest, render_at_rest}}},
  }};

  State state_ = State::rest;
};

}  // namespace brume

// When a view renders, event by event.

#include "app/frames/frame_pacing.h"

#include <QTest>
#include <vector>

#include "tests/app/test_window.h"

using namespace brume;

namespace {

using Event = FramePacing::Event;
using Action = FramePacing::Action;

struct Run {
  const char* name;
  std::vector<Event> events;
  std::vector<Action> actions;
};

const std::vector<Run>& runs() {
  static const std::vector<Run> all = {
      {"a change is followed by a frame at rest",
       {Event::change, Event::picture, Event::quiet, Event::quiet},
       {Action::render_in_motion, Action::none, Action::render_at_rest, Action::none}},
      {"a slow picture does not hold up the frame at rest",
       {Event::change, Event::quiet, Event::picture},
       {Action::render_in_motion, Action::render_at_rest, Action::none}},
      {"the last picture of a gesture that is over is followed at once",
       {Event::change, Event::change, Event::gesture_end, Event::picture, Event::quiet},
       {Action::render_in_motion, Action::render_in_motion, Action::none, Action::wait_no_longer,
        Action::render_at_rest}},
      {"a gesture that ends after its last picture is followed at once",
       {Event::change, Event::picture, Event::gesture_end, Event::quiet},
       {Action::render_in_motion, Action::none, Action::wait_no_longer, Action::render_at_rest}},
      {"a change after a gesture begins another",
       {Event::change, Event::gesture_end, Event::change, Event::picture, Event::quiet},
       {Action::render_in_motion, Action::none, Action::render_in_motion, Action::none,
        Action::render_at_rest}},
      {"without a change nothing is rendered",
       {Event::gesture_end, Event::picture, Event::quiet},
       {Action::none, Action::none, Action::none}},
  };
  return all;
}

}  // namespace

class FramePacingTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void each_event_has_its_action_data() {
    QTest::addColumn<int>("run");
    for (int k = 0; const Run& run : runs()) QTest::newRow(run.name) << k++;
  }
  void each_event_has_its_action() {
    QFETCH(int, run);
    const auto& [name, events, actions] = runs()[static_cast<std::size_t>(run)];
    FramePacing pacing;
    for (std::size_t k = 0; k < events.size(); ++k) {
      QVERIFY2(pacing.on(events[k]) == actions[k], qPrintable(QString::number(k)));
    }
  }
};

BRUME_APP_SUITE("frame_pacing", FramePacingTest)
#include "frame_pacing_test.moc"

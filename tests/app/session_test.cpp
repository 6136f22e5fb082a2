// A recorded session of mixed edits by mouse and keys: played in two windows it gives the same
// document, byte for byte, and so do undoing and redoing all of it.

#include <QClipboard>
#include <QGuiApplication>
#include <fstream>
#include <iterator>
#include <set>

#include "app/tools/brushes/airbrush_tool.h"
#include "app/tools/tool_box.h"
#include "app/viewport/viewport.h"
#include "app/widgets/number_field.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/test_window.h"
#include "tests/random.h"

using namespace brume;

namespace {

constexpr int actions = 500;
constexpr int min_edits = 100;

// The user's acts, as read from a tape.
struct Action {
  enum class Kind { key, gesture, number };
  Kind kind = Kind::key;
  int key = 0;                           // of keys
  Qt::KeyboardModifiers modifiers = {};  // of keys and gestures
  std::vector<QPoint> path = {};         // of gestures: where the mouse went, button down
  const char* field = nullptr;           // of numbers: into which field they were typed
  QString text = {};
};

// A user who tries everything, always in the same way.
class Tape {
 public:
  explicit Tape(QSize view) : view_(view) {
    while (static_cast<int>(actions_.size()) < actions) act();
  }

  [[nodiscard]] const std::vector<Action>& all() const { return actions_; }

 private:
  int below(int count) { return static_cast<int>(random_.uniform(0.0, count)); }
  QPoint place() {
    const int x = 40 + below(view_.width() - 80);
    return {x, 40 + below(view_.height() - 80)};
  }
  void key(int key, Qt::KeyboardModifiers modifiers = {}) {
    actions_.push_back({.kind = Action::Kind::key, .key = key, .modifiers = modifiers});
  }
  void gesture(int points, Qt::KeyboardModifiers modifiers = {}) {
    Action action{.kind = Action::Kind::gesture, .modifiers = modifiers};
    action.path.push_back(place());
    for (int k = 1; k < points; ++k) {
      const int dx = below(80) - 40;
      action.path.push_back(action.path.back() + QPoint(dx, below(60) - 30));
    }
    actions_.push_back(std::move(action));
  }

  void act() {
    using Qt::ControlModifier;
    using Qt::ShiftModifier;
    switch (below(16)) {
      case 0:
        key(Qt::Key_B);
        gesture(2 + below(3));
        break;
      case 1:
        key(Qt::Key_E);
        gesture(2 + below(4));
        break;
      case 2:
        key(Qt::Key_A);
        gesture(3 + below(6));
        break;
      case 3:
        key(Qt::Key_L);
        gesture(8);
        break;
      case 4:
        key(Qt::Key_C);
        gesture(3, below(2) == 0 ? ShiftModifier : Qt::NoModifier);
        break;
      case 5:
        key(Qt::Key_V);
        gesture(1);
        break;
      case 6:
        key(Qt::Key_V);
        gesture(4);
        break;
      case 7:
        key(Qt::Key_A, ControlModifier);
        key(below(2) == 0 ? Qt::Key_R : Qt::Key_G);
        gesture(4);
        break;
      case 8:
        key(Qt::Key_P);
        gesture(1 + below(3));
        break;
      case 9:
        key(Qt::Key_A, ShiftModifier);
        break;
      case 10:
        key(Qt::Key_D, ControlModifier);
        break;
      case 11:
        key(Qt::Key_Delete);
        break;
      case 12: {
        const char* const fields[]{"center_x", "radius", "density"};
        actions_.push_back({.kind = Action::Kind::number,
                            .field = fields[below(3)],
                            .text = QString::number(0.1 + 0.01 * below(90))});
        break;
      }
      case 13:
        key(Qt::Key_Z, ControlModifier);
        if (below(2) == 0) key(Qt::Key_Z, ControlModifier | ShiftModifier);
        break;
      case 14:
        key(Qt::Key_C, ControlModifier);
        key(Qt::Key_V, ControlModifier | ShiftModifier);
        break;
      default: {
        const int keys[]{Qt::Key_BracketLeft, Qt::Key_BracketRight, Qt::Key_K, Qt::Key_H};
        key(keys[below(4)]);
        key(below(2) == 0 ? Qt::Key_K : Qt::Key_H, ShiftModifier);
        key(Qt::Key_I, ControlModifier);
      }
    }
  }

  QSize view_;
  Random random_{5};  // with which gestures of R and G meet handles
  std::vector<Action> actions_;
};

// A window in which the tape is played; the airbrush's clock goes by the tape.
class Player {
 public:
  Player() {
    QGuiApplication::clipboard()->clear();
    for (const auto& entry : window->tools().entries()) {
      if (auto* airbrush = dynamic_cast<AirbrushTool*>(entry.tool.get())) {
        airbrush->set_clock([this] { return time_; });
      }
    }
    QObject::connect(&window->document().undo_stack(), &QUndoStack::indexChanged,
                     &window->document(), [this](int index) {
                       const std::uint64_t revision = window->document().revision();
                       if (index > index_ && revision != revision_) {
                         ++edits;
                         const QString step = window->document().undo_stack().text(index - 1);
                         verbs.insert(step.section(' ', 0, 0));
                       }
                       index_ = index;
                       revision_ = revision;
                     });
  }

  void play(const Tape& tape) {
    for (const Action& action : tape.all()) {
      switch (action.kind) {
        case Action::Kind::key:
          window.key(static_cast<Qt::Key>(action.key), action.modifiers);
          break;
        case Action::Kind::gesture:
          QTest::mousePress(&window->viewport(), Qt::LeftButton, action.modifiers,
                            action.path.front());
          for (const QPoint at : action.path) {
            time_ += 70;
            window.move(at, Qt::LeftButton, action.modifiers);
          }
          QTest::mouseRelease(&window->viewport(), Qt::LeftButton, action.modifiers,
                              action.path.back());
          break;
        case Action::Kind::number: {
          auto* field = window->findChild<NumberField*>(action.field);
          if (!field->isEnabled()) break;
          field->setFocus();
          QTest::keyClicks(field, action.text);
          QTest::keyClick(field, Qt::Key_Return);
        }
      }
    }
  }

  std::string bytes() {
    save_document(window.scene(), window.file("bytes.brume"));
    std::ifstream file(window.file("bytes.brume"), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  TestWindow window;
  int edits = 0;  // that changed the scene; what only selects does not count
  std::set<QString> verbs;

 private:
  qint64 time_ = 0;
  int index_ = 0;
  std::uint64_t revision_ = 0;
};

}  // namespace

class SessionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_session_plays_again_to_the_same_document() {
    std::string start;
    std::string end;
    {
      Player first;
      const Tape tape(first.window->viewport().size());
      start = first.bytes();
      first.play(tape);
      end = first.bytes();
      QVERIFY2(first.edits >= min_edits, qPrintable(QString::number(first.edits)));
      QVERIFY(end != start);
      for (const char* verb : {"Paint", "Erase", "Spray", "Move", "Rotate", "Delete", "Set", "Add",
                               "Duplicate", "Paste"}) {
        QVERIFY2(first.verbs.contains(verb), verb);
      }
      QUndoStack& history = first.window->document().undo_stack();
      const int steps = history.index();
      history.setIndex(0);
      QCOMPARE(first.bytes(), start);
      history.setIndex(steps);
      QCOMPARE(first.bytes(), end);
    }
    Player second;
    second.play(Tape(second.window->viewport().size()));
    QVERIFY(second.bytes() == end);
  }
};

BRUME_APP_SUITE("session", SessionTest)
#include "session_test.moc"

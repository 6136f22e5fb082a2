#pragma once

#include <QObject>

namespace brume {

// Hears of what ends the program from outside: SIGHUP, SIGINT and SIGTERM unless they are ignored,
// and the desktop's session. There may be one at a time.
class SessionEnd : public QObject {
  Q_OBJECT
 public:
  explicit SessionEnd(QObject* parent = nullptr);
  ~SessionEnd() override;  // signals do again what they did

 Q_SIGNALS:
  void announced();  // work is to be kept now; the session may yet go on
  // The program is to end, by the signal if it is not 0. The next signal does again what it did
  // before.
  void ended(int signal);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void read_signal();
};

}  // namespace brume

#pragma once

#include <QObject>
#include <QString>

class QAction;

namespace brume {

// The text of an entry as it is read: "Save" of "&Save".
QString without_mnemonic(const QString& text);
// The text of an action behind that of its menu: "Select › All".
QString command_title(const QAction& action);

// Gives each entry of a menu and each label, box, button and tab of a dialog a letter of its own,
// which takes it together with Alt, when it is shown. Letters that a text has already are kept
// where no other has them.
class Mnemonics : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace brume

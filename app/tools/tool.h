#pragma once

#include <QObject>
#include <QPointF>
#include <Qt>
#include <span>

class QHBoxLayout;

namespace brume {

class CameraRays;
class Document;
class Viewport;
struct Overlay;

// What the left mouse button does. A tool changes the document only by commands that merge while
// dragging, so that one gesture is one undo step.
class Tool : public QObject {
  Q_OBJECT
 public:
  // `view` is the first that the mouse is in.
  Tool(Document& document, Viewport& view) : document_(document), view_(&view) {}

  // The view that positions are in. It stays the same while a button is down.
  [[nodiscard]] Viewport& view() const { return *view_; }
  void set_view(Viewport& view) { view_ = &view; }

  // One line for the status bar.
  [[nodiscard]] virtual QString hint() const = 0;
  // Puts the widgets of the tool's options in a row; those follow options_changed().
  virtual void add_options(QHBoxLayout& /*row*/) {}

  virtual void hover(QPointF /*position*/) {}
  virtual void leave() {}  // the mouse has left the viewport
  virtual void press(QPointF position, Qt::KeyboardModifiers modifiers) = 0;
  // `path`: every position of the mouse since the last call, in order; not empty.
  virtual void move(std::span<const QPointF> path) = 0;
  virtual void release(QPointF position) = 0;
  virtual void cancel() = 0;  // as if the gesture had not begun
  // Ends the gesture and leaves everything as it is: for another scene, whose ids are not these.
  virtual void abandon() = 0;
  // After an edit, be it the tool's own or one under its hands, such as undo.
  virtual void medium_changed() {}

  // What the tool shows over the picture: in the world, and so in all views (a brush, handles), and
  // on the film of its own view (a lasso).
  virtual void draw(Overlay& /*overlay*/, const CameraRays& /*rays*/) const {}
  virtual void draw_on_film(Overlay& /*overlay*/) const {}
  // Whether centres of Gaussians are shown, to be picked.
  [[nodiscard]] virtual bool shows_handles() const { return true; }
  [[nodiscard]] virtual Qt::CursorShape cursor() const { return Qt::ArrowCursor; }
  // Whether Alt + left button is the tool's and not the view's.
  [[nodiscard]] virtual bool takes_alt() const { return false; }

  // By a factor; does nothing for tools without.
  virtual void change_size(double /*factor*/) {}
  virtual void change_strength(double /*factor*/) {}

 Q_SIGNALS:
  void looks_changed();  // of what it draws
  void options_changed();
  void refused(const QString& problem);  // why a typed option was not taken

 protected:
  Document& document_;

 private:
  Viewport* view_;
};

}  // namespace brume

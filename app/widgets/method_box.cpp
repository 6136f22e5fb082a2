#include "app/widgets/method_box.h"

namespace brume {

MethodBox::MethodBox(QWidget* parent) : QComboBox(parent) {
  addItem(tr("As in the view"));
  addItem(tr("Path traced"));
  addItem(tr("Path traced, denoised"));
  setToolTip(
      tr("As in the view: by View > Quality, soon done, or by %1 paths, denoised, if the view is "
         "path traced. Path traced: all light, scattered and "
         "reflected any number of times, with noise that four times the paths halve. Denoised: "
         "begins with the solved picture and keeps of the paths what stands out from their noise; "
         "regions, and layers of light, keep the noise")
          .arg(first_paths(Denoising::solved)));
}

std::optional<Denoising> MethodBox::paths() const {
  if (currentIndex() <= 0) return std::nullopt;
  return currentIndex() == 2 ? Denoising::solved : Denoising::none;
}

void MethodBox::set_paths(std::optional<Denoising> denoise) {
  setCurrentIndex(!denoise ? 0 : *denoise == Denoising::solved ? 2 : 1);
}

int MethodBox::first_paths(Denoising denoise) {
  return denoise == Denoising::solved ? 64 : 256;  // errors of a few per cent in most scenes
}

}  // namespace brume

// Fits Gaussians to a grid of densities, here a torus of smoke, and saves them: fit OUT.ply
#include <brume/files.h>
#include <brume/fit.h>

#include <cmath>
#include <iostream>
#include <vector>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  constexpr int n = 40;
  constexpr double voxel = 0.1;
  std::vector<float> densities;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) {
        const double x = (i - n / 2) * voxel, y = (j - n / 2) * voxel, z = (k - n / 2) * voxel;
        const double ring = std::hypot(std::hypot(x, z) - 1.2, y);
        densities.push_back(static_cast<float>(std::exp(-ring * ring / 0.09)));
      }
    }
  }
  const brume::DensityGrid grid = brume::grid_of(densities, {n, n, n}, voxel);
  const brume::Fit fit = *brume::fit_gaussians(grid, {.count = 60});
  brume::save_gaussians(fit.gaussians, argv[1]);
  std::cout << fit.gaussians.size() << " Gaussians, " << 100.0 * fit.density_error << "% off\n";
}

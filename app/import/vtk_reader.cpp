// brume-vtk-points FILE OUT.ply MAX_GAUSSIANS MAX_BYTES MAX_SECONDS [ids]: converts the points of a
// VTK file to Gaussians, with ids on request, within limits of memory and CPU time. VTK trusts its
// input and may crash or exhaust memory on damaged files. Exit code 0; 2 with the file's error on
// standard output; anything else is a failure of VTK, described on standard error.
// read_vtk_points() (app/import/vtk_points.h) starts it.

#include <malloc.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "brume/error.h"
#include "brume/gaussian.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_columns.h"
#include "core/io/gaussians/gaussian_ply.h"
#include "core/io/import/parent_program.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace {

// Collects VTK's errors; the first one matters.
class Errors : public vtkOutputWindow {
 public:
  static Errors* New();
  vtkTypeMacro(Errors, vtkOutputWindow)
  Errors(const Errors&) = delete;
  void operator=(const Errors&) = delete;

  void DisplayText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayErrorText(const char* text) override {
    if (first_.empty()) first_ = text;
  }

  [[nodiscard]] bool any() const { return !first_.empty(); }
  // Without the place in VTK's source that it begins with: "ERROR: In FILE, line N", then
  // "CLASS (ADDRESS): ".
  [[nodiscard]] std::string text() const {
    const std::size_t place_end = first_.find("): ");
    std::string text = place_end == std::string::npos ? first_ : first_.substr(place_end + 3);
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    return quoted_text(text, 200);
  }

 protected:
  Errors() = default;

 private:
  std::string first_;
};
vtkStandardNewMacro(Errors);

vtkSmartPointer<vtkPointSet> read_points(const std::filesystem::path& file) {
  vtkNew<Errors> errors;
  vtkOutputWindow::SetInstance(errors);
  const auto read = [&](auto reader) -> vtkSmartPointer<vtkPointSet> {
    reader->SetFileName(file.c_str());
    if (reader->CanReadFile(file.c_str()) == 0) {
      throw InputError(file, "", "is not a VTK file of this type");
    }
    reader->Update();
    if (errors->any()) throw InputError(file, "", "VTK cannot read it: " + errors->text());
    if (reader->GetErrorCode() != 0 || reader->GetOutput() == nullptr) {
      throw InputError(file, "", "VTK cannot read it");
    }
    return vtkPointSet::SafeDownCast(reader->GetOutput());
  };
  regular_file_size(file);  // says what is wrong with the file itself
  if (lower_case_extension(file) == ".vtu") {
    return read(vtkSmartPointer<vtkXMLUnstructuredGridReader>::New());
  }
  return read(vtkSmartPointer<vtkXMLPolyDataReader>::New());
}

// The array of that name; nullptr where there is none.
vtkDataArray* array_of(const std::filesystem::path& file, vtkPointSet& points, const char* name) {
  vtkDataArray* array = points.GetPointData()->GetArray(name);
  if (array == nullptr) return nullptr;
  if (array->GetNumberOfComponents() != 1 ||
      array->GetNumberOfTuples() != points.GetNumberOfPoints()) {
    throw InputError(file, name, "found an array of another shape; allowed: one scalar per point");
  }
  return array;
}

double default_radius(vtkPointSet& points) {
  double box[6];
  points.GetBounds(box);
  const double max_value = std::max({box[1] - box[0], box[3] - box[2], box[5] - box[4]});
  if (!(max_value > 0.0)) return 1.0;
  // A flat cloud has some thickness.
  double volume = 1.0;
  for (int k = 0; k < 3; ++k) volume *= std::max(box[2 * k + 1] - box[2 * k], 0.01 * max_value);
  return std::cbrt(volume / static_cast<double>(points.GetNumberOfPoints()));
}

// Throws InputError naming file and point.
std::vector<Gaussian> gaussians_of(const std::filesystem::path& file,
                                   std::vector<GaussianNumber>* ids, std::size_t max_count) {
  const vtkSmartPointer<vtkPointSet> points = read_points(file);
  const vtkIdType count = points->GetNumberOfPoints();
  if (count == 0) throw InputError(file, "", "has no points");
  if (static_cast<std::size_t>(count) > max_count) {
    throw InputError(file, "",
                     "found " + std::to_string(count) +
                         " points; allowed: " + gaussian_columns::allowed_count(max_count));
  }
  vtkDataArray* radius = array_of(file, *points, "radius");
  vtkDataArray* density = array_of(file, *points, "density");
  vtkDataArray* id = ids ? array_of(file, *points, gaussian_columns::id_name.data()) : nullptr;
  const double without = radius == nullptr ? default_radius(*points) : 0.0;
  std::vector<Gaussian> gaussians;
  gaussians.reserve(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i) {
    double at[3];
    points->GetPoint(i, at);
    const double value[5]{at[0], at[1], at[2], radius ? radius->GetTuple1(i) : without,
                          density ? density->GetTuple1(i) : 1.0};
    for (std::size_t k = 0; k < 5; ++k) {
      if (gaussian_columns::domains[k]->contains(value[k])) continue;
      throw InputError(file, "point " + std::to_string(i),
                       std::string(gaussian_columns::names[k]) + ": " +
                           gaussian_columns::domains[k]->refusal(value[k]));
    }
    gaussians.push_back({{value[0], value[1], value[2]}, value[3], value[4]});
    if (id == nullptr) continue;
    const double number = id->GetTuple1(i);
    if (!gaussian_columns::is_id(number)) {
      throw InputError(file, "point " + std::to_string(i),
                       "id: " + gaussian_columns::id_domain.refusal(number));
    }
    ids->push_back(static_cast<GaussianNumber>(number));
  }
  return gaussians;
}

}  // namespace
}  // namespace brume

int main(int argc, char* argv[]) {
  if (argc < 6) return EXIT_FAILURE;
  setenv("VTK_SMP_BACKEND_IN_USE", "Sequential", 1);  // threads take much address space each
  brume::limit_to_parent(std::strtoull(argv[4], nullptr, 10), std::strtoull(argv[5], nullptr, 10));
#ifdef M_PERTURB
  // Where an array ends too early VTK leaves memory as it was. Of 0x7f bytes are numbers that are
  // in no domain of a Gaussian.
  mallopt(M_PERTURB, 0x80);
#endif
  try {
    std::vector<brume::GaussianNumber> ids;
    const auto gaussians = brume::gaussians_of(argv[1], argc > 6 ? &ids : nullptr,
                                               std::strtoull(argv[3], nullptr, 10));
    brume::write_gaussians_ply(argv[2], gaussians, ids);
    return EXIT_SUCCESS;
  } catch (const brume::InputError& error) {
    std::puts(error.what());
    return 2;
  } catch (const std::exception&) {
    return EXIT_FAILURE;
  }
}

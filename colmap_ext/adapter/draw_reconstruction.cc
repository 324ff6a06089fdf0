// An example of a program that links COLMAP and draws a reconstruction as one of its stages:
//
//   draw_reconstruction <folder of the model> <folder of the images> <output folder>
//
// COLMAP reads the model, the controller draws it, and COLMAP writes it again, with points on the
// curves, to <output folder>/sparse-with-curves.
#include <filesystem>
#include <memory>

#include <glog/logging.h>

#include "colmap_ext/adapter/curve_drawer_controller.h"

int main(int argc, char** argv) {
  using limn::colmap_ext::CurveDrawerController;
  google::InitGoogleLogging(argv[0]);
  FLAGS_logtostderr = true;
  if (argc != 4) {
    LOG(ERROR) << "usage: draw_reconstruction <model> <images> <output>";
    return 1;
  }
  const auto reconstruction = std::make_shared<colmap::Reconstruction>();
  reconstruction->Read(argv[1]);

  limn::colmap_ext::CurveDrawerOptions options;
  options.image_path = argv[2];
  options.output_path = argv[3];
  options.point_spacing_px = 4;
  if (!options.Check()) return 1;
  CurveDrawerController controller(options, reconstruction);
  controller.Run();
  if (!controller.Drawing()) return 1;

  const std::filesystem::path folder = std::filesystem::path(argv[3]) / "sparse-with-curves";
  std::filesystem::create_directories(folder);
  reconstruction->Write(folder.string());
  return 0;
}

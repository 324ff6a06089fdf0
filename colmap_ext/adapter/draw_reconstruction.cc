// SPDX-License-Identifier: BSD-3-Clause
// An example of a program that links COLMAP and draws a reconstruction as one of its stages:
//
//   draw_reconstruction <folder of the model> <folder of the images> <output folder>
//
// COLMAP reads the model, the controller draws it, and COLMAP writes it again, with points on the
// curves, to <output folder>/sparse-with-curves.
#include <exception>
#include <filesystem>
#include <memory>
#include <string>

#include <glog/logging.h>

#include "colmap_ext/adapter/curve_drawer_controller.h"
#include "limn/files/writable_folder.h"

namespace {

bool Draw(const std::string& model, const std::string& images, const std::string& output) {
  // COLMAP ends the process where a file is missing or damaged; a program checks what it can.
  if (!std::filesystem::is_directory(model)) {
    LOG(ERROR) << model << ": no such folder";
    return false;
  }
  const auto reconstruction = std::make_shared<colmap::Reconstruction>();
  reconstruction->Read(model);

  limn::colmap_ext::CurveDrawerOptions options;
  options.image_path = images;
  options.output_path = output;
  options.point_spacing_px = 4;
  if (!options.Check()) return false;
  limn::colmap_ext::CurveDrawerController controller(options, reconstruction);
  controller.Run();
  if (!controller.Drawing()) return false;

  // COLMAP itself would follow links.
  const limn::OutputPath folder(output, "sparse-with-curves");
  limn::WritableFolder::Make(folder);
  limn::CheckHoldsNoLinks(folder);
  reconstruction->Write(folder.string());
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  google::InitGoogleLogging(argv[0]);
  FLAGS_logtostderr = true;
  if (argc != 4) {
    LOG(ERROR) << "usage: draw_reconstruction <model> <images> <output>";
    return 1;
  }
  try {
    return Draw(argv[1], argv[2], argv[3]) ? 0 : 1;
  } catch (const std::exception& error) {
    LOG(ERROR) << error.what();
    return 1;
  }
}

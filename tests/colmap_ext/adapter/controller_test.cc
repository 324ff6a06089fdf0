// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "colmap_ext/adapter/curve_drawer_controller.h"
#include "colmap_ext/temp_dir.h"
#ifdef LIMN_COLMAP_HAS_BASE_CONTROLLER
#include <colmap/util/controller_thread.h>
#endif

namespace limn::colmap_ext {
namespace {

using Controller = std::shared_ptr<CurveDrawerController>;

#ifdef LIMN_COLMAP_HAS_BASE_CONTROLLER
std::shared_ptr<colmap::Thread> ThreadOf(const Controller& controller) {
  return std::make_shared<colmap::ControllerThread<CurveDrawerController>>(controller);
}
#else
std::shared_ptr<colmap::Thread> ThreadOf(const Controller& controller) { return controller; }
#endif

Controller MakeController(const TempDir& dir) {
  const auto reconstruction = std::make_shared<colmap::Reconstruction>();
  reconstruction->Read(LIMN_SAMPLE_DIR "/day/sparse");
  CurveDrawerOptions options;
  options.image_path = LIMN_SAMPLE_DIR "/day/images";
  options.output_path = (dir / "output").string();
  return std::make_shared<CurveDrawerController>(options, reconstruction);
}

TEST(CurveDrawerController, Stops) {
  using Clock = std::chrono::steady_clock;
  const TempDir dir;
  const Controller controller = MakeController(dir);
  const auto thread = ThreadOf(controller);
  thread->Start();
  std::this_thread::sleep_for(std::chrono::seconds(1));
  const auto before = Clock::now();
  thread->Stop();
  thread->Wait();
  EXPECT_LT(std::chrono::duration<double>(Clock::now() - before).count(), 5);
  EXPECT_FALSE(controller->Drawing());
  EXPECT_EQ(controller->Error(), "");
  EXPECT_FALSE(std::filesystem::exists(dir / "output/drawing.json"));
}

TEST(CurveDrawerController, WaitsWhilePaused) {
  using Clock = std::chrono::steady_clock;
  const TempDir dir;
  const Controller controller = MakeController(dir);
  const auto thread = ThreadOf(controller);
  thread->Start();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  thread->Pause();
  const auto deadline = Clock::now() + std::chrono::seconds(10);
  while (!thread->IsPaused() && Clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_TRUE(thread->IsPaused());
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_TRUE(thread->IsPaused());
  EXPECT_FALSE(thread->IsFinished());
  thread->Stop();
  thread->Wait();
  EXPECT_FALSE(controller->Drawing());
}

TEST(CurveDrawerController, TellsWhatIsWrong) {
  const TempDir dir;
  CurveDrawerOptions options;
  options.image_path = "/no such folder";
  options.output_path = dir.path().string();
  CurveDrawerController controller(options, std::make_shared<colmap::Reconstruction>());
  controller.Run();
  EXPECT_FALSE(controller.Drawing());
  EXPECT_EQ(controller.Error(), "/no such folder: no such folder (image_path)");
}

TEST(CurveDrawerOptions, AreChecked) {
  CurveDrawerOptions options;
  EXPECT_TRUE(options.Check());
  options.point_spacing_px = -1;
  EXPECT_FALSE(options.Check());
  options.point_spacing_px = 2;
  options.drawer.run.pipeline.refine_cameras = CameraRefinement::kOn;
  EXPECT_FALSE(options.Check());
  // The points are then of the given poses.
  options.drawer.run.pipeline.output_cameras = OutputCameras::kGiven;
  EXPECT_TRUE(options.Check());
  options.drawer.run.pipeline.output_cameras = OutputCameras::kRefined;
  options.point_spacing_px = 0;
  EXPECT_TRUE(options.Check());
  options.drawer.run.pipeline.sketch.min_supporting_views = -1;
  EXPECT_FALSE(options.Check());
}

}  // namespace
}  // namespace limn::colmap_ext

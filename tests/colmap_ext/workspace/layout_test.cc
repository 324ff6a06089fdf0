// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/refined_folder.h"
#include "limn/formats/write_drawing.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

using ::testing::AllOf;
using ::testing::HasSubstr;

class Layout : public ::testing::Test {
 protected:
  void AddModel(const std::string& folder, size_t num_images = 3) {
    SparseModel model = MakeModel();
    model.images.resize(num_images);
    fs::create_directories(dir_ / folder);
    WriteModelBinary(model, dir_ / folder);
  }
  void AddFolder(const std::string& folder) { fs::create_directories(dir_ / folder); }

  LayoutOptions Options() const {
    LayoutOptions options;
    options.workspace_path = dir_.path().string();
    return options;
  }

  void ExpectLayout(const LayoutOptions& options, const std::string& model,
                    const std::string& images, const std::string& drawing) {
    const WorkspaceLayout layout = ResolveLayout(options);
    EXPECT_EQ(layout.model_dir, dir_ / model);
    EXPECT_EQ(layout.image_dir, dir_ / images);
    EXPECT_EQ(fs::weakly_canonical(layout.output.drawing_dir),
              fs::weakly_canonical(dir_ / drawing));
    EXPECT_EQ(layout.output.curves_dir, layout.output.drawing_dir / "curves");
    EXPECT_THAT(layout.description, HasSubstr((dir_ / model).string()));
  }

  std::string ErrorOf(const LayoutOptions& options) const {
    return ErrorText<IoError>([&] { ResolveLayout(options); });
  }

  TempDir dir_;
};

TEST_F(Layout, DenseWorkspaceItself) {
  AddModel("sparse");
  AddFolder("images");
  AddModel("dense/0/sparse");
  AddFolder("dense/0/images");
  ExpectLayout(Options(), "sparse", "images", ".");
  EXPECT_EQ(ResolveLayout(Options()).dense_dir, dir_.path());
}

TEST_F(Layout, DenseFolderComesBeforeTheSparseModels) {
  AddModel("sparse/0");
  AddFolder("images");
  AddModel("dense/0/sparse");
  AddFolder("dense/0/images");
  ExpectLayout(Options(), "dense/0/sparse", "dense/0/images", "dense/0");
  EXPECT_EQ(ResolveLayout(Options()).dense_dir, dir_ / "dense/0");
}

TEST_F(Layout, DenseFolderWithoutNumber) {
  AddModel("sparse/0");
  AddFolder("images");
  AddModel("dense/sparse");
  AddFolder("dense/images");
  ExpectLayout(Options(), "dense/sparse", "dense/images", "dense");
}

TEST_F(Layout, SparseModelWithItsImages) {
  AddModel("sparse/0");
  AddFolder("images");
  AddFolder("dense/0");
  ExpectLayout(Options(), "sparse/0", "images", ".");
  EXPECT_EQ(ResolveLayout(Options()).dense_dir, "");
}

TEST_F(Layout, MostRegisteredImagesWin) {
  AddModel("sparse/0", 1);
  AddModel("sparse/1", 3);
  AddModel("sparse/10", 3);
  AddModel("sparse/2", 2);
  AddFolder("images");
  ExpectLayout(Options(), "sparse/1", "images", ".");
  EXPECT_THAT(ResolveLayout(Options()).description,
              HasSubstr("3 registered images, most of 4 models"));
}

TEST_F(Layout, ModelIndexChooses) {
  AddModel("sparse/0", 3);
  AddModel("sparse/1", 1);
  AddModel("dense/0/sparse", 3);
  AddFolder("dense/0/images");
  AddFolder("images");
  LayoutOptions options = Options();
  options.model_index = 1;
  ExpectLayout(options, "sparse/1", "images", ".");
  options.model_index = 2;
  EXPECT_THAT(ErrorOf(options), HasSubstr("with model_index 2"));
}

TEST_F(Layout, GivenModelIsUsedWithTheImagesNearIt) {
  AddModel("sparse/0");
  AddModel("sparse/1", 1);
  AddFolder("images");
  AddModel("dense/0/sparse");
  AddFolder("dense/0/images");
  AddFolder("dense/0/stereo");
  LayoutOptions options = Options();
  options.input_path = (dir_ / "sparse/1").string();
  ExpectLayout(options, "sparse/1", "images", ".");
  options.input_path = (dir_ / "sparse").string();
  ExpectLayout(options, "sparse/0", "images", ".");
  options.input_path = (dir_ / "dense/0/sparse").string();
  ExpectLayout(options, "dense/0/sparse", "dense/0/images", "dense/0");
}

// A drawing that fits refined cameras, or does not.
TEST_F(Layout, RefinedCamerasAreThoseOfTheDrawing) {
  AddModel("sparse/0");
  AddFolder("images");
  LayoutOptions options = Options();
  options.output_path = (dir_ / "out").string();
  SparseModel model = MakeModel();
  model.images[0].cam_from_world.translation.x() += 1;
  const std::string name = WriteRefinedFolder(model, dir_ / "out/refined");
  const auto write = [&](const std::string& path, const std::string& cameras) {
    WriteDrawing((dir_ / path).string(), {}, {{}, "{}", std::nullopt, std::nullopt, cameras});
  };
  write("out/drawing.json", name);
  // From images.
  EXPECT_EQ(ResolveLayout(options).model_dir, dir_ / "sparse/0");
  options.starts_from = {"drawing-fused.json", "drawing.json"};
  const WorkspaceLayout layout = ResolveLayout(options);
  EXPECT_EQ(layout.model_dir, dir_ / "out/refined");
  EXPECT_EQ(layout.given_model_dir, dir_ / "sparse/0");
  EXPECT_EQ(layout.image_dir, dir_ / "images");
  EXPECT_THAT(layout.description, HasSubstr("out/refined"));
  EXPECT_THAT(layout.note, AllOf(HasSubstr("out/drawing.json"), HasSubstr("out/refined")));
  // A drawing elsewhere has its cameras beside it.
  LayoutOptions elsewhere = Options();
  elsewhere.starts_from = {(dir_ / "out/drawing.json").string()};
  EXPECT_EQ(ResolveLayout(elsewhere).model_dir, dir_ / "out/refined");
  // A model that is given stays, with a warning unless it has those cameras.
  LayoutOptions given = options;
  given.input_path = (dir_ / "sparse/0").string();
  EXPECT_EQ(ResolveLayout(given).model_dir, dir_ / "sparse/0");
  EXPECT_THAT(
      ResolveLayout(given).note,
      AllOf(HasSubstr("WARNING: "), HasSubstr("--input_path " + (dir_ / "out/refined").string())));
  given.input_path = (dir_ / "out/refined").string();
  EXPECT_EQ(ResolveLayout(given).note, "");
  // Another drawing, and cameras that were changed.
  write("out/drawing.json", "");
  EXPECT_EQ(ResolveLayout(options).model_dir, dir_ / "sparse/0");
  EXPECT_EQ(ResolveLayout(options).note, "");
  write("out/drawing.json", name);
  model.images[0].cam_from_world.translation.x() += 1;
  WriteRefinedFolder(model, dir_ / "out/refined");
  EXPECT_EQ(ResolveLayout(options).model_dir, dir_ / "sparse/0");
  EXPECT_THAT(ResolveLayout(options).note, AllOf(HasSubstr("WARNING: "), HasSubstr("draw again")));
}

TEST_F(Layout, SparseModelsInAColmapFolder) {
  AddModel("colmap/sparse/0");
  AddFolder("images");
  ExpectLayout(Options(), "colmap/sparse/0", "images", ".");
}

TEST_F(Layout, SomeModelIsHeldEvenIfItCannotBeUsed) {
  EXPECT_FALSE(HoldsSomeModel(dir_.path()));
  AddFolder("images");
  dir_.WriteFile("drawing.json", "");
  EXPECT_FALSE(HoldsSomeModel(dir_.path()));
  for (const char* folder :
       {".", "3", "sparse", "sparse/1", "dense/sparse", "dense/0/sparse", "colmap/sparse/0"}) {
    AddModel(folder);
    EXPECT_TRUE(HoldsSomeModel(dir_.path())) << folder;
    fs::remove(dir_ / folder / "images.bin");  // incomplete
    EXPECT_TRUE(HoldsSomeModel(dir_.path())) << folder;
    fs::remove(dir_ / folder / "cameras.bin");
    EXPECT_FALSE(HoldsSomeModel(dir_.path())) << folder;
  }
}

TEST_F(Layout, ModelInMemory) {
  AddFolder("images");
  LayoutOptions options;
  options.image_path = (dir_ / "images").string();
  EXPECT_EQ(ErrorText<OptionError>([&] { LayoutInMemory(options, 5); }),
            "output_path is missing: the model is in memory");
  options.output_path = (dir_ / "out").string();
  const WorkspaceLayout layout = LayoutInMemory(options, 5);
  EXPECT_EQ(layout.model_dir, "");
  EXPECT_EQ(layout.image_dir, dir_ / "images");
  EXPECT_EQ(layout.output.drawing_dir, dir_ / "out");
  EXPECT_EQ(layout.output.curves_dir, dir_ / "out/curves");
  EXPECT_THAT(layout.description, HasSubstr("Model in memory (5 registered images), images in "));
  options.image_path += "/none";
  EXPECT_THAT(ErrorText<IoError>([&] { LayoutInMemory(options, 5); }),
              HasSubstr("no such folder (image_path)"));
}

TEST_F(Layout, PmvsFolder) {
  dir_.WriteFile("pmvs/txt/00000000.txt", "CONTOUR\n1 0 0 0\n0 1 0 0\n0 0 1 0\n");
  AddFolder("pmvs/visualize");
  ExpectLayout(Options(), "pmvs", "pmvs/visualize", "pmvs");
  LayoutOptions options = Options();
  options.workspace_path += "/pmvs";
  ExpectLayout(options, "pmvs", "pmvs/visualize", "pmvs");
  options = Options();
  options.input_path = (dir_ / "pmvs").string();
  ExpectLayout(options, "pmvs", "pmvs/visualize", ".");
}

TEST_F(Layout, WorkspaceMayBeTheFolderOfModelsOrAModel) {
  AddModel("project/sparse/0", 2);
  AddModel("project/sparse/1", 3);
  AddFolder("project/images");
  LayoutOptions options = Options();
  options.workspace_path += "/project/sparse";
  ExpectLayout(options, "project/sparse/1", "project/images", "project/sparse");
  options.workspace_path += "/0";
  ExpectLayout(options, "project/sparse/0", "project/images", "project/sparse/0");
}

TEST_F(Layout, IncompleteModelsNameTheMissingFile) {
  AddModel("sparse/0");
  AddFolder("images");
  fs::remove(dir_ / "sparse/0/images.bin");
  EXPECT_THAT(ErrorOf(Options()),
              HasSubstr("sparse/0: not a COLMAP model: images.bin is missing beside cameras.bin"));
}

TEST_F(Layout, GivenFoldersReplaceTheFoundOnes) {
  AddModel("sparse/0");
  AddFolder("photos");
  LayoutOptions options = Options();
  EXPECT_THAT(ErrorOf(options), HasSubstr("no COLMAP model with its images"));
  options.image_path = (dir_ / "photos").string();
  ExpectLayout(options, "sparse/0", "photos", ".");
  options.output_path = (dir_ / "out").string();
  ExpectLayout(options, "sparse/0", "photos", "out");
  options.workspace_path = "";
  options.input_path = (dir_ / "sparse/0").string();
  ExpectLayout(options, "sparse/0", "photos", "out");
  options.output_path = "";
  EXPECT_THAT(ErrorText<OptionError>([&] { ResolveLayout(options); }),
              HasSubstr("workspace_path is missing"));
}

TEST_F(Layout, ErrorsListWhatWasFound) {
  EXPECT_THAT(ErrorOf(Options()), HasSubstr("found nothing"));
  AddFolder("sparse/0");
  dir_.WriteFile("database.db", "");
  EXPECT_THAT(ErrorOf(Options()),
              AllOf(HasSubstr("database.db, sparse/"), HasSubstr("in sparse: 0/")));
  LayoutOptions options = Options();
  options.workspace_path += "/nowhere";
  EXPECT_THAT(ErrorOf(options), HasSubstr("nowhere: no such folder (workspace_path)"));
  options = Options();
  options.input_path = (dir_ / "sparse").string();
  EXPECT_THAT(ErrorOf(options), HasSubstr("no COLMAP model (cameras and images): found 0/"));
  options.input_path = (dir_ / "elsewhere").string();
  EXPECT_THAT(ErrorOf(options), HasSubstr("elsewhere: no such folder"));
  options = Options();
  options.image_path = (dir_ / "photos").string();
  EXPECT_THAT(ErrorOf(options), HasSubstr("photos: no such folder (image_path)"));
}

TEST_F(Layout, FoldersOfOtherPrograms) {
  AddModel("gs/distorted/sparse/0");
  AddFolder("gs/input");
  AddModel("ngp/colmap_text");
  AddFolder("ngp/images");
  AddModel("ngp2/colmap_sparse/0", 1);
  AddModel("ngp2/colmap_sparse/1");
  AddFolder("ngp2/images");
  AddModel("deep/sparse/0/0", 1);
  AddModel("deep/sparse/0/1");
  AddFolder("deep/images");
  AddModel("shrunk/sparse/0");
  AddFolder("shrunk/images_4");
  AddFolder("shrunk/images_8");
  const auto expect = [&](const std::string& name, const std::string& model,
                          const std::string& images) {
    LayoutOptions options = Options();
    options.workspace_path += "/" + name;
    ExpectLayout(options, name + "/" + model, name + "/" + images, name);
  };
  expect("gs", "distorted/sparse/0", "input");
  expect("ngp", "colmap_text", "images");
  expect("ngp2", "colmap_sparse/1", "images");
  expect("deep", "sparse/0/1", "images");
  expect("shrunk", "sparse/0", "images_4");
  // What gaussian-splatting has undistorted comes first, and never with the images it was made of.
  AddModel("gs/sparse/0");
  expect("gs", "distorted/sparse/0", "input");
  AddFolder("gs/images");
  expect("gs", "sparse/0", "images");
}

TEST_F(Layout, ModelsAndImagesElsewhereAreNamed) {
  AddModel("my project/reconstruction/final");
  AddFolder("my project/photos/left");
  LayoutOptions options = Options();
  options.workspace_path += "/my project";
  EXPECT_THAT(ErrorOf(options), AllOf(HasSubstr("--input_path '"), HasSubstr("/final' --image_path "
                                                                             "<folder of its")));
  dir_.WriteFile("my project/photos/left/c.png", "");
  EXPECT_THAT(ErrorOf(options), HasSubstr("photos/left' uses it"));
}

TEST_F(Layout, CamerasOfOtherProgramsAreNamedWithTheCommand) {
  AddFolder("images");
  dir_.WriteFile("transforms.json", "{\"frames\": []}");
  const std::string command = "`limn model_importer --input_path " +
                              (dir_ / "transforms.json").string() + " --image_path " +
                              (dir_ / "images").string() + " --output_path " +
                              (dir_ / "sparse/0").string() + "`";
  EXPECT_THAT(ErrorOf(Options()), HasSubstr(command));
  dir_.WriteFile("a.mvs", "MVSI");
  EXPECT_THAT(ErrorOf(Options()),
              AllOf(HasSubstr(command), HasSubstr("there are also a.mvs (OpenMVS)")));
  // Given themselves.
  LayoutOptions options = Options();
  options.input_path = (dir_ / "transforms.json").string();
  EXPECT_THAT(ErrorOf(options), HasSubstr("not a COLMAP model; "));
  options = {};
  options.workspace_path = (dir_ / "transforms.json").string();
  EXPECT_THAT(ErrorOf(options), HasSubstr("not a folder (workspace_path); "));
  fs::remove(dir_ / "transforms.json");
  EXPECT_THAT(ErrorOf(Options()), HasSubstr("a.mvs is of OpenMVS: InterfaceCOLMAP"));
}

TEST_F(Layout, ADatabaseAloneIsNamedWithTheMapper) {
  AddFolder("images");
  dir_.WriteFile("database.db", "");
  EXPECT_THAT(ErrorOf(Options()),
              AllOf(HasSubstr("database.db holds no cameras: `colmap mapper --database_path "),
                    HasSubstr("--output_path " + (dir_ / "sparse").string() + "`")));
}

TEST_F(Layout, ErrorsAreOneLine) {
  for (int i = 0; i < 50; ++i) dir_.WriteFile("file" + std::to_string(i), "");
  const std::string error = ErrorOf(Options());
  EXPECT_EQ(error.find('\n'), std::string::npos);
  EXPECT_THAT(error, HasSubstr("and 30 more"));
}

}  // namespace
}  // namespace limn::colmap_ext

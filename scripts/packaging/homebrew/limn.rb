# Formula of Homebrew, for Linux, to be filled in by scripts/packaging/fill_recipes.py.
#
# Not yet run by its system; checked: ruby -c, names of formulae against homebrew-core of 2026.
# It cannot work yet: Limn asks CMake for Eigen 3.4, and Homebrew's ceres-solver is built with, and asks for exactly, its Eigen 5.
# Linux only (renameat2, malloc_trim), x86_64 only (esbuild's program in npm's cache). Without STEP (needs OpenCASCADE 7.6 to 7.9), MPI and Python.
class Limn < Formula
  desc "3D drawings from COLMAP projects"
  homepage "https://github.com/@LIMN_REPOSITORY@"
  url "https://github.com/@LIMN_REPOSITORY@/releases/download/v0.3.0/limn-0.3.0.tar.gz"
  sha256 "@LIMN_SHA256@"
  license all_of: ["BSD-3-Clause", "MIT"] # MIT: three.js, in the page of drawing_viewer

  depends_on "cmake" => :build
  depends_on "ninja" => :build
  depends_on "node" => :build
  depends_on arch: :x86_64
  depends_on "boost"
  depends_on "ceres-solver"
  depends_on "eigen"
  depends_on "flann"
  depends_on "glog"
  depends_on "icu4c@78"
  depends_on "jpeg-turbo"
  depends_on :linux
  depends_on "lz4"
  depends_on "nlohmann-json"
  depends_on "opencv"
  depends_on "sqlite"
  depends_on "tbb"
  depends_on "zlib"

  # npm's cache of the viewer page, so that the build needs no network.
  resource "npm-cache" do
    url "https://github.com/@LIMN_REPOSITORY@/releases/download/v0.3.0/limn-0.3.0-npm-cache.tar.gz"
    sha256 "@LIMN_NPM_CACHE_SHA256@"
  end

  # Headers, of which Homebrew has no formula.
  resource "tinygltf" do
    url "https://github.com/syoyo/tinygltf/archive/refs/tags/v2.8.21.tar.gz"
    sha256 "e567257d7addde58b0a483832cbaa5dd8f15e5bcaee6f023831e215d1a2c0502"
  end

  def install
    resource("npm-cache").stage buildpath/"npm-cache"
    resource("tinygltf").stage buildpath/"tinygltf"
    ENV["npm_config_cache"] = buildpath/"npm-cache"
    ENV["npm_config_offline"] = "true"
    ENV.append_to_cflags "-isystem #{buildpath}/tinygltf"
    args = %w[
      -DBUILD_SHARED_LIBS=ON
      -DLIMN_BUILD_TESTS=OFF
      -DLIMN_WITH_VIEWER=ON
      -DLIMN_WITH_PYTHON=OFF
      -DLIMN_WITH_COLMAP=OFF
      -DLIMN_WITH_STEP=OFF
      -DLIMN_WITH_MPI=OFF
    ]
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", *args, *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
  end

  test do
    assert_match version.to_s, shell_output("#{bin}/limn --version")
    (testpath/"empty").mkpath
    shell_output("#{bin}/limn automatic_drawer --workspace_path #{testpath}/empty", 1)
  end
end

// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/options/colmap_options.h"

namespace limn {
namespace {

struct Advice {
  std::string_view option;
  const char* text;
};

constexpr const char* kNoChance = "leave it out: nothing depends on chance";
constexpr const char* kNoGpu = "leave it out: no GPU is used";
constexpr const char* kStreams =
    "leave it out: messages go to standard output, errors to standard error";
constexpr const char* kNoStep = "leave it out: limn starts from a model that COLMAP has made";

constexpr Advice kAdvice[] = {
    {"random_seed", kNoChance},
    {"default_random_seed", kNoChance},
    {"use_gpu", kNoGpu},
    {"gpu_index", kNoGpu},
    {"log_target", kStreams},
    {"log_to_stderr", kStreams},
    {"log_path", kStreams},
    {"data_type", kNoStep},
    {"vocab_tree_path", kNoStep},
    {"camera_model", kNoStep},
    {"single_camera", kNoStep},
    {"sparse", kNoStep},
    {"dense", kNoStep},
    {"mesher", kNoStep},
    {"export_path", "it is --output_path here"},
    {"import_path", "it is --input_path here"},
    {"sparse_path", "it is --input_path here"},
};

}  // namespace

std::string AdviceOnColmapOption(std::string_view name) {
  for (const Advice& advice : kAdvice) {
    if (advice.option == name) return advice.text;
  }
  return "";
}

}  // namespace limn

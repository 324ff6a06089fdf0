// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "colmap_ext/options/option_parser.h"

namespace limn::bench {

// What main() of a program here returns: it reads the options, prints their help or runs, and says
// what went wrong in one line.
int BenchMain(int argc, const char* const* argv, OptionParser* parser,
              const std::function<void()>& run);

}  // namespace limn::bench

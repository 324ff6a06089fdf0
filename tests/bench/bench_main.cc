// SPDX-License-Identifier: BSD-3-Clause
#include "bench/bench_main.h"

#include <exception>
#include <iostream>

namespace limn::bench {

int BenchMain(int argc, const char* const* argv, OptionParser* parser,
              const std::function<void()>& run) {
  try {
    if (parser->Parse(argc, argv) == OptionParser::Outcome::kHelp) {
      parser->WriteHelp(std::cout);
    } else {
      run();
    }
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "ERROR: " << error.what() << '\n';
    return 1;
  }
}

}  // namespace limn::bench

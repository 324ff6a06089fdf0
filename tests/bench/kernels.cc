// SPDX-License-Identifier: BSD-3-Clause
// Times of the inner loops, by google-benchmark: kernels_<module>.cc register theirs. `kernels
// --benchmark_filter=Edgels` runs some, `--benchmark_repetitions=5` tells the scatter.

#include <benchmark/benchmark.h>

BENCHMARK_MAIN();

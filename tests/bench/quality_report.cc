// SPDX-License-Identifier: BSD-3-Clause
// Measures what automatic_drawer makes of all known data sets (data_sets.h): each method of
// methods.h with its default options and with its support threshold swept, against the truth and in
// held-out views. Writes report.json, report.md, and per data set the drawings and, where there is
// a cloud of PMVS, a picture of both. scripts/plot_quality.py draws the curves of precision and
// recall.
#include <string>

#include "bench/bench_main.h"
#include "bench/data_sets.h"
#include "bench/measure_set.h"
#include "bench/report_tables.h"
#include "colmap_ext/host/terminal_console.h"
#include "limn/files/atomic_file.h"
#include "limn/util/errors.h"

namespace limn::bench {
namespace {

struct Options {
  std::string data_path = LIMN_DATA_DIR;
  std::string sample_path = LIMN_SAMPLE_DIR;
  std::string sets;
  ReportOptions report;
  int num_threads = -1;
};

void AddOptions(Options* options, OptionParser* parser) {
  parser->AddOption("data_path", &options->data_path, "folder of the data sets");
  parser->AddOption("sample_path", &options->sample_path, "folder of the sample scene");
  parser->AddOption("output_path", &options->report.output_path, "where everything is written");
  parser->AddOption("sets", &options->sets, "data sets with commas between; empty = all present");
  parser->AddOption("quick", &options->report.quick, "default options only, no sweep");
  parser->AddOption("max_image_size", &options->report.max_image_size,
                    "shrink images to this longer side, px, -1 = off, 0 = as by default");
  parser->AddOption("num_threads", &options->num_threads, "-1 = all cores");
}

void WriteReport(const Options& options, const Json& report) {
  WriteFileAtomically(options.report.output_path + "/report.json",
                      [&](std::ostream& out) { out << report.dump(1) << '\n'; });
  WriteFileAtomically(options.report.output_path + "/report.md",
                      [&](std::ostream& out) { WriteTables(report, out); });
}

void Run(const Options& options) {
  if (options.report.output_path.empty()) throw OptionError("--output_path must be given");
  const auto sets =
      SelectDataSets(KnownDataSets(options.data_path, options.sample_path), options.sets);
  colmap_ext::TerminalConsole console(options.num_threads);
  Json report = {{"sets", Json::array()}};
  for (const DataSet& set : sets) {
    report["sets"].push_back(nullptr);
    MeasureSet(set, options.report, &console, [&](const Json& so_far) {
      report["sets"].back() = so_far;
      WriteReport(options, report);  // a sweep takes long: what is known can be read
    });
  }
}

}  // namespace
}  // namespace limn::bench

int main(int argc, char** argv) {
  limn::bench::Options options;
  limn::OptionParser parser("quality_report", "measure the methods on all known data sets");
  limn::bench::AddOptions(&options, &parser);
  return limn::bench::BenchMain(argc, argv, &parser, [&] { limn::bench::Run(options); });
}

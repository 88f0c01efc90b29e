#include "app/command_line.hpp"
#include "app/finish.hpp"
#include "app/located.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "io/input/case_file.hpp"
#include "io/tables/certificate_words.hpp"
#include "io/write/write_beam.hpp"
#include "io/write/write_superelement.hpp"
#include "run/study/equivalent_beam.hpp"
#include "run/study/reduce.hpp"
#include "solve/sparse_factor.hpp"

#include <fmt/core.h>

namespace plica {
namespace {

struct ReduceOptions {
  ChosenCase chosen;
  Output out;
  int threads = 0;
  SuperelementRequest request;
  Units units = Units::metres;
  bool beam = false; // equivalent pipe and connectors besides
};

int reduce(const ReduceOptions& options) {
  set_threads(options.threads);
  const CaseFile file = read_case(options.chosen);
  std::vector<std::string> names = superelement_files(false);
  if (options.beam)
    for (std::string& name : beam_files()) names.push_back(std::move(name));
  OutputFolder out(options.out.folder, {.command = "reduce",
                                        .inputs = files_of(file),
                                        .names = std::move(names),
                                        .json_only = options.out.json_only});
  Progress progress(options.out.quiet);
  progress.title(file.data.name);
  const ReducedCase reduced = with_doubts(file, [&] {
    return located(file, [&] {
      return reduce_case(file.data, options.request,
                         [&](const std::string& s) { progress.stage(s); });
    });
  });
  std::optional<EquivalentBeam> beam;
  if (options.beam)
    beam = located(file, [&] {
      return equivalent_beam(file.data, [&](const std::string& s) { progress.stage(s); });
    });
  write_superelement(reduced, options.units, out);
  if (beam) write_beam(*beam, out);
  hand_over(out);
  progress.finish();
  if (!options.out.quiet)
    print(fmt::format("{}\n{}Report: {}\n", certificate_text(reduced),
                      beam ? beam_text(*beam) + "\n" : "",
                      out.shown("certificate.html", "certificate.json").string()));
  return reduced.certificate.passed && reduced.proved ? 0 : 2;
}

} // namespace

void add_reduce_command(CommandLine& line) {
  const auto options = std::make_shared<ReduceOptions>();
  CLI::App& command =
      line.add("reduce", "a case as a Craig-Bampton superelement with its certificate",
               [options] { return reduce(*options); });
  add_case(command, options->chosen);
  add_output(command, options->out);
  add_threads(command, options->threads);
  command
      .add_option("--cutoff", options->request.cutoff,
                  "modes with held boundary up to this frequency, Hz; left out: twice the highest "
                  "frequency the case asks for")
      ->check(number_in(0, "above 0 and finite"))
      ->type_name("HZ");
  command
      .add_option("--boundary", options->request.boundary,
                  "names of caps and sensors, with commas; left out: all caps")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAME,NAME,...");
  command
      .add_option("--least-interface-mass", options->request.least_interface_mass,
                  "leave out modes that carry a smaller share of the interface mass, e.g. 0.001")
      ->check(number_in(1, "from 0 to 1"))
      ->type_name("SHARE");
  command.add_flag("--beam", options->beam,
                   "also an equivalent pipe and a chain of connectors, with what they cost");
  add_choice(command, "--units", options->units, {{"m", Units::metres}, {"mm", Units::millimetres}},
             "of the files: m (kg, s, N) or mm (t, s, N)")
      ->type_name("m|mm");
}

} // namespace plica

#include "app/chosen_case.hpp"
#include "app/command_line.hpp"
#include "app/finish.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "io/input/case_file.hpp"
#include "io/tables/certificate_words.hpp"
#include "io/write/write_beam.hpp"
#include "io/write/write_superelement.hpp"
#include "model/shape/build_surface.hpp"
#include "run/study/equivalent_beam.hpp"
#include "run/study/reduce.hpp"
#include "solve/sparse_factor.hpp"
#include "words/units.hpp"

#include <fmt/core.h>

namespace plica {
namespace {

struct ReduceOptions {
  ChosenCase chosen;
  Output out;
  int threads = 0;
  SuperelementRequest request;
  SuperelementFormat format;
  std::vector<std::string> move, rotate;
  bool beam = false; // equivalent pipe and connectors besides
};

// Three quantities, "0mm,120mm,0mm".
Triple triple_of(const std::vector<std::string>& texts, Dimension dimension,
                 const std::string& option) {
  Triple t{};
  if (texts.empty()) return t;
  if (texts.size() != 3)
    input_error(option, fmt::format("has {} numbers", texts.size()), "three, along x, y and z");
  for (std::size_t k = 0; k < 3; ++k) {
    const ParsedQuantity parsed = parse_quantity(texts[k], dimension);
    if (!parsed.wrong.empty()) input_error(option, parsed.wrong, parsed.allowed);
    t[k] = parsed.value;
  }
  return t;
}

int reduce(const ReduceOptions& options) {
  set_threads(options.threads);
  SuperelementFormat format = options.format;
  const Triple move = triple_of(options.move, Dimension::length, "--move");
  format.labels.origin = {move[0], move[1], move[2]};
  format.labels.axes = turn_of(triple_of(options.rotate, Dimension::angle, "--rotate"));
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
  write_superelement(reduced, format, out);
  if (beam) write_beam(*beam, out);
  hand_over(out);
  progress.finish();
  if (!options.out.quiet)
    print(fmt::format("{}\n{}Report: {}\n", certificate_text(reduced),
                      beam ? beam_text(*beam) + "\n" : "",
                      out.shown("certificate.html", "certificate.json").string()));
  return reduced.certificate.passed && reduced.proved ? 0 : 2;
}

// How the superelement is called and numbered in the files, and their units.
void add_format(CLI::App& command, SuperelementFormat& format) {
  ElementLabels& labels = format.labels;
  const auto number = [&](const std::string& name, int& into, const std::string& help) {
    command.add_option(name, into, help)
        ->check(CLI::Range(1, 99999999))
        ->capture_default_str()
        ->type_name("NUMBER");
  };
  number("--first-node", labels.first_node, "number of the first boundary node in the decks");
  number("--first-mode", labels.first_mode, "of the first modal coordinate");
  number("--first-point", labels.first_point, "of the first recovered point");
  number("--element", labels.element, "of the user element, and of the MPC set of the recovery");
  command
      .add_option("--system", labels.system,
                  "the decks keep the axes of the part, as a coordinate system of this number that "
                  "--rotate and --move place; left out: all is turned into the axes of the deck")
      ->check(CLI::Range(1, 99999999))
      ->type_name("NUMBER");
  command.add_option("--name", labels.name, "of sets and matrices: one to five letters and digits")
      ->capture_default_str();
  add_choice(command, "--units", format.units, {{"m", Units::metres}, {"mm", Units::millimetres}},
             "of the files: m (kg, s, N) or mm (t, s, N)")
      ->type_name("m|mm");
}

} // namespace

void add_reduce_command(CommandLine& line) {
  const auto options = std::make_shared<ReduceOptions>();
  CLI::App& command =
      line.add("reduce", "a case as a Craig-Bampton superelement with its certificate",
               [options] { return reduce(*options); });
  add_case(command, options->chosen);
  add_state(command, options->chosen);
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
  const auto list = [&](const std::string& name, std::vector<std::string>& into,
                        const std::string& type, const std::string& help) {
    command.add_option(name, into, help)->delimiter(',')->allow_extra_args(false)->type_name(type);
  };
  list("--recover", options->request.recover, "NAME,NAME,...",
       "sensors whose motion and stress the files give back; left out: all");
  list("--rotate", options->rotate, "ANGLE,ANGLE,ANGLE",
       "places the element: turned about x, then y, then z, e.g. 0deg,0deg,90deg");
  list("--move", options->move, "LENGTH,LENGTH,LENGTH", "and then moved, e.g. 0mm,120mm,0mm");
  add_format(command, options->format);
}

} // namespace plica

// The command line. Exit codes: 0 good, 1 user error (also an output that cannot be written), 2 a
// numerical verdict failed, 3 internal.
#include "app/commands.hpp"
#include "app/describe_app.hpp"
#include "app/interrupt.hpp"
#include "app/terminal.hpp"
#include "words/did_you_mean.hpp"
#include "io/write/geometry.hpp"
#include "words/input_error.hpp"
#include "solve/blas_kernels.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <new>

namespace {

// A number that is finite and, by `top`, above zero (0) or from zero to `top`.
CLI::Validator number_in(double top, const std::string& allowed) {
  return CLI::Validator(
      [top, allowed](std::string& text) -> std::string {
        double value = 0;
        const bool number = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
        const bool good = number && (top > 0 ? value >= 0 && value <= top : value > 0);
        return good ? "" : "'" + text + "' is no number " + allowed;
      },
      "");
}

// One word out of several; the help lists them.
template <class E>
CLI::Option* add_choice(CLI::App& app, const std::string& name, E& value,
                        const std::vector<std::pair<std::string, E>>& names,
                        const std::string& help) {
  std::vector<std::string> words(names.size());
  std::transform(names.begin(), names.end(), words.begin(), [](const auto& n) { return n.first; });
  return app
      .add_option_function<std::string>(
          name,
          [&value, names](const std::string& word) {
            for (const auto& [known, meaning] : names)
              if (known == word) value = meaning;
          },
          help)
      ->check(CLI::IsMember(words))
      ->type_name("");
}

void add_model(CLI::App& app, std::string& model) {
  app.add_option("--model", model, "one of the models of the case; left out: its parts")
      ->type_name("NAME");
}

// What is wrong with the first word when it is no command; empty when it is one, or an option.
std::string unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return "";
  return "plica: there is no command '" + plica::shown(argv[1]) + "'; " +
         plica::suggestion(argv[1], names);
}

int dispatch(int argc, char** argv) {
  CLI::App app{"Plica: dynamics of flexible exhaust pipes"};
  app.set_version_flag("--version", "plica " PLICA_VERSION "\nwith " PLICA_LIBRARIES);
  app.require_subcommand(1);

  plica::RunOptions run;
  CLI::App* run_app = app.add_subcommand("run", "statics, modes and report of a case");
  run_app->add_option("CASE", run.case_path, "case file")->required();
  add_model(*run_app, run.model);
  run_app->add_option("--out", run.out, "folder for the results")->capture_default_str();
  run_app->add_option("--threads", run.threads, "threads, 0 = all cores")
      ->check(CLI::Range(0, 256))
      ->capture_default_str();
  run_app->add_flag("--quiet", run.quiet, "print errors only");
  run_app
      ->add_option("--geometry", run.geometry,
                   "write the part and its modes besides, as msh, uff, glb, obj, ply, stl")
      ->delimiter(',')
      ->check(CLI::IsMember(plica::geometry_formats()));
  run_app
      ->add_option(
          "--write-deck", run.deck,
          "only write the whole model as a deck for another solver: model.inp or model.bdf")
      ->check(CLI::IsMember({"abaqus", "nastran"}));
  run_app->add_flag_callback(
      "--no-variants", [&] { run.variants = false; }, "leave the variants of the case out");
  run_app->add_flag_callback(
      "--no-error-bars", [&] { run.error_bars = false; },
      "leave out the runs on finer meshes and over the tolerances");

  plica::ReduceOptions reduce;
  CLI::App* reduce_app =
      app.add_subcommand("reduce", "a case as a Craig-Bampton superelement with its certificate");
  reduce_app->add_option("CASE", reduce.case_path, "case file")->required();
  add_model(*reduce_app, reduce.model);
  reduce_app->add_option("--out", reduce.out, "folder for the files")->capture_default_str();
  reduce_app->add_option("--threads", reduce.threads, "threads, 0 = all cores")
      ->check(CLI::Range(0, 256));
  reduce_app->add_flag("--quiet", reduce.quiet, "print errors only");
  reduce_app
      ->add_option("--cutoff", reduce.request.cutoff,
                   "modes with held boundary up to this frequency, Hz; left out: twice the highest "
                   "frequency the case asks for")
      ->check(number_in(0, "above 0 and finite"))
      ->type_name("HZ");
  reduce_app
      ->add_option("--boundary", reduce.request.boundary,
                   "names of caps and sensors, with commas; left out: all caps")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAME,NAME,...");
  reduce_app
      ->add_option("--least-interface-mass", reduce.request.least_interface_mass,
                   "leave out modes that carry a smaller share of the interface mass, e.g. 0.001")
      ->check(number_in(1, "from 0 to 1"))
      ->type_name("SHARE");
  reduce_app->add_flag("--beam", reduce.beam,
                       "also an equivalent pipe and a chain of connectors, with what they cost");
  std::string units = "m";
  reduce_app->add_option("--units", units, "of the files: m (kg, s, N) or mm (t, s, N)")
      ->check(CLI::IsMember({"m", "mm"}))
      ->type_name("m|mm");

  plica::IdentifyOptions identify;
  std::vector<double> band;
  CLI::App* identify_app = app.add_subcommand(
      "identify", "frequencies, damping and shapes from measured responses or time signals");
  identify_app
      ->add_option("FILES", identify.files,
                   "a measured.yaml, or files of frequency responses (UFF, CSV), one per reference")
      ->required();
  identify_app->add_option("--out", identify.out, "folder for the results")->capture_default_str();
  identify_app->add_flag("--quiet", identify.quiet, "print errors only");
  identify_app->add_option("--band", band, "lowest and highest frequency, Hz; left out: all lines")
      ->expected(2)
      ->delimiter(',')
      ->type_name("HZ HZ");
  identify_app
      ->add_option("--order", identify.settings.highest_order,
                   "highest order of the stabilisation diagram; left out: by the references")
      ->check(CLI::Range(2, 200));
  plica::FrfQuantity quantity{};
  CLI::Option* quantity_given =
      add_choice(*identify_app, "--quantity", quantity,
                 {{"receptance", plica::FrfQuantity::receptance},
                  {"mobility", plica::FrfQuantity::mobility},
                  {"accelerance", plica::FrfQuantity::accelerance},
                  {"transmissibility", plica::FrfQuantity::transmissibility}},
                 "of bare files; left out: as they say, or accelerance");
  identify_app
      ->add_option("--block", identify.welch.block,
                   "samples of a block (noise); left out: by the length")
      ->check(CLI::Range(8, 1 << 24));
  identify_app->add_option("--overlap", identify.welch.overlap, "of blocks, 0 to 0.95")
      ->check(CLI::Range(0., 0.95))
      ->capture_default_str();
  add_choice(*identify_app, "--window", identify.welch.window,
             {{"rectangular", plica::Window::rectangular},
              {"hann", plica::Window::hann},
              {"hamming", plica::Window::hamming},
              {"flat_top", plica::Window::flat_top}},
             "of blocks; left out: hann");
  add_choice(*identify_app, "--estimator", identify.estimator,
             {{"H1", plica::FrfEstimator::H1},
              {"H2", plica::FrfEstimator::H2},
              {"Hv", plica::FrfEstimator::Hv}},
             "of the frequency responses of noise; left out: H1");
  identify_app->add_option("--lines", identify.tracking.lines, "frequencies of a sweep")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  identify_app->add_option("--cycles", identify.tracking.cycles, "periods in a window of a sweep")
      ->check(CLI::Range(1., 10000.))
      ->capture_default_str();

  plica::FitOptions fit;
  CLI::App* fit_app =
      app.add_subcommand("fit", "adjust numbers of a case to measured data (its section fit)");
  fit_app->add_option("CASE", fit.case_path, "case file")->required();
  add_model(*fit_app, fit.model);
  fit_app->add_option("--measured", fit.measured, "measured data; left out: as the case says")
      ->type_name("FILE");
  plica::FitSearch search{};
  CLI::Option* search_given =
      add_choice(*fit_app, "--search", search,
                 {{"local", plica::FitSearch::local}, {"global", plica::FitSearch::global}},
                 "from the values of the case, or over the whole box; left out: as the case says");
  int evaluations = 0;
  CLI::Option* evaluations_given =
      fit_app->add_option("--evaluations", evaluations, "budget of a global search")
          ->check(CLI::Range(10, 10000000));
  fit_app->add_option("--seed", fit.seed, "of a global search")->capture_default_str();
  fit_app->add_option("--restart", fit.restart, "begin with the designs of an earlier fit.json")
      ->type_name("FILE");
  fit_app->add_option("--out", fit.out, "folder for the results")->capture_default_str();
  fit_app->add_option("--threads", fit.threads, "threads, 0 = all cores")
      ->check(CLI::Range(0, 256));
  fit_app->add_flag("--quiet", fit.quiet, "print errors only");

  plica::DiagnoseOptions diagnose;
  CLI::App* diagnose_app = app.add_subcommand(
      "diagnose", "where the gap to a test lies, which effect causes it, how far it shrinks");
  diagnose_app->add_option("CASE", diagnose.case_path, "case file")->required();
  add_model(*diagnose_app, diagnose.model);
  diagnose_app
      ->add_option("--measured", diagnose.measured,
                   "a measured.yaml, or its folder; left out: as the case says")
      ->type_name("DIR");
  diagnose_app->add_option("--without", diagnose.without, "leave a guard out, to see what it does")
      ->check(CLI::IsMember({"form", "nuisance", "reassembly", "adequacy", "levels", "heldout"}));
  diagnose_app->add_flag("--pretest", diagnose.pretest,
                         "before a test: what looks alike, how small an effect would be found");
  std::vector<char> planned_bases;
  diagnose_app->add_option("--bases", planned_bases, "of a planned test: axes of the table")
      ->check(CLI::IsMember({'x', 'y', 'z'}));
  diagnose_app->add_option("--levels", diagnose.plan.levels, "of a planned test: m/s2")
      ->check(CLI::PositiveNumber);
  diagnose_app->add_flag("!--no-plan", diagnose.plan_next, "do not look for the next measurement");
  diagnose_app->add_option("--out", diagnose.out, "folder for the results")->capture_default_str();
  diagnose_app->add_option("--threads", diagnose.threads, "threads, 0 = all cores")
      ->check(CLI::Range(0, 256));
  diagnose_app->add_flag("--quiet", diagnose.quiet, "print errors only");

  plica::CompareOptions compare;
  CLI::App* compare_app =
      app.add_subcommand("compare", "simulation and test side by side: modes, shapes, responses");
  compare_app->add_option("RESULT", compare.result, "folder of a run, or a measured.yaml")
      ->required();
  compare_app->add_option("MEASURED", compare.measured, "a measured.yaml, or a folder of a run")
      ->required();
  compare_app->add_option("--out", compare.out, "folder for the results")->capture_default_str();
  compare_app->add_flag("--quiet", compare.quiet, "print errors only");

  plica::CheckOptions check;
  CLI::App* check_app = app.add_subcommand("check", "validate a case and estimate its cost");
  check_app->add_option("CASE", check.case_path, "case file")->required();
  add_model(*check_app, check.model);
  check_app->add_option("--threads", check.threads, "threads, 0 = all cores")
      ->check(CLI::Range(0, 256));

  std::filesystem::path starter = "pipe.yaml";
  CLI::App* init_app =
      app.add_subcommand("init", "write a commented case file of a bellows to begin with");
  init_app->add_option("FILE", starter, "the file, not there yet")->capture_default_str();

  std::string schema = "case";
  CLI::App* schema_app = app.add_subcommand("schema", "print the JSON Schema of the input files");
  bool reference = false;
  schema_app->add_flag("--reference", reference, "every key in Markdown instead");
  schema_app->add_option("KIND", schema, "case, measured or benchmark")
      ->check(CLI::IsMember({"case", "measured", "benchmark"}))
      ->capture_default_str();

  std::string shell = "bash";
  CLI::App* completion_app =
      app.add_subcommand("completion", "print the completions of the command line for a shell");
  completion_app->add_option("SHELL", shell, "bash or zsh")
      ->check(CLI::IsMember({"bash", "zsh"}))
      ->capture_default_str();
  CLI::App* manual_app = app.add_subcommand("manual", "print the manual page, as man reads it");

  if (const std::string unknown = unknown_command(app, argc, argv); !unknown.empty()) {
    plica::say(unknown + "\n");
    return 1;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  }
  for (std::string* path :
       {&run.case_path, &reduce.case_path, &check.case_path, &fit.case_path, &diagnose.case_path})
    *path = plica::case_file_of(*path);
  if (*run_app) return plica::run_command(run);
  if (*fit_app) {
    if (*search_given) fit.search = search;
    if (*evaluations_given) fit.evaluations = evaluations;
    return plica::fit_command(fit);
  }
  for (char axis : planned_bases) diagnose.plan.bases.push_back(axis - 'x');
  if (*diagnose_app) return plica::diagnose_command(diagnose);
  if (*compare_app) return plica::compare_command(compare);
  if (*identify_app) {
    if (*quantity_given) identify.quantity = quantity;
    if (!band.empty()) {
      identify.settings.low = band[0];
      identify.settings.high = band[1];
    }
    return plica::identify_command(identify);
  }
  if (*reduce_app) {
    if (units == "mm") reduce.units = plica::Units::millimetres;
    return plica::reduce_command(reduce);
  }
  if (*check_app) return plica::check_command(check);
  if (*init_app) return plica::init_command(starter);
  if (*completion_app) plica::print(plica::completion(app, shell));
  if (*manual_app) plica::print(plica::manual_page(app, PLICA_VERSION));
  if (*completion_app || *manual_app) return 0;
  return plica::schema_command(schema, reference);
}

int run_command_line(int argc, char** argv) {
  try {
    return dispatch(argc, argv);
  } catch (const plica::Interrupted& stop) {
    plica::say("plica: stopped before \"" + stop.stage + "\"; no file was written\n");
    return plica::interrupted_exit();
  } catch (const plica::InputError& error) {
    plica::say(std::string(error.what()) + "\n");
    return 1;
  } catch (const std::bad_alloc&) {
    plica::say("plica: not enough memory for this model\n");
    return 3;
  } catch (const std::exception& error) {
    plica::say(std::string("plica: ") + error.what() + "\n");
    return 3;
  }
}

} // namespace

int main(int argc, char** argv) {
  plica::avoid_faulty_blas_kernels(argv);
  plica::open_standard_streams();
  plica::watch_interrupts();
  return plica::finished(run_command_line(argc, argv));
}

#include "diagnose/account/assumptions.hpp"

#include "diagnose/weigh/scatter.hpp"
#include "diagnose/weigh/thickness_fields.hpp"

#include <fmt/format.h>

namespace plica {

std::vector<std::string> assumptions_of(const GapProblem& problem, const Standards& standards,
                                        const Guards& without) {
  std::vector<std::string> list;
  const auto add = [&]<class... V>(fmt::format_string<V...> format, V&&... values) {
    list.push_back(fmt::format(format, std::forward<V>(values)...));
  };
  add("{} readings, {} of them held out; {} hypotheses of {} effects",
      problem.readings.readings.size(), problem.held_out->rows().size(), problem.hypotheses.size(),
      effects().size());
  const auto percent = [](double share) { return 100 * share; };
  add("admissible specimens ({}): modulus {:g} %, density {:g} %, wall {:g} % where the case has "
      "no tolerance, field of stiffness {:g} %, masses {:g} %, joints {:g} %; {} tolerances of "
      "the case",
      specimens, percent(scatters::modulus), percent(scatters::density),
      percent(scatters::thickness), percent(scatters::field), percent(scatters::masses),
      percent(scatters::joints), problem.data.tolerances.size());
  for (const Part& part : problem.data.parts) {
    const auto* bellows = std::get_if<Bellows>(&part.body);
    if (bellows && bellows->wall.thickness_field)
      add("thickness of {} along its wall {:g} %, in place of the field of stiffness", part.name,
          percent(*bellows->wall.thickness_field));
    if (const std::optional<double> field = field_over(part))
      add("thickness of {} over its wall {:g} %", part.name, percent(*field));
  }
  add("damping {:.2g} % of all modes alike and {:g} % of each; sensors {:g} %, {:g} degree and "
      "{:g} mm, table {:g} % along other axes",
      percent(scatters::all_damping_of(problem.data)), percent(scatters::mode_damping),
      percent(scatters::gain), scatters::turn, 1e3 * scatters::off_place,
      percent(scatters::other_axes));
  add("reassembly {:g} % of frequencies and {:g} % of damping, runs {:g} % and {:g} %",
      percent(problem.remounting.frequency), percent(problem.remounting.damping),
      percent(test_sigma::run_frequency), percent(test_sigma::run_damping));
  add("model {:g} % of frequencies, {:g} % of damping, {:g} % of stiffnesses, {:g} % of cross "
      "responses and {:g} % of what the meshes differ by",
      percent(test_sigma::numeric_frequency), percent(test_sigma::numeric_damping),
      percent(test_sigma::numeric_stiffness), percent(test_sigma::numeric_cross),
      percent(test_sigma::share_of_correction));
  add("adequate: chi-square at most {:.1f} over {} readings and {:.1f} over their means over the "
      "levels, no block beyond z = {:.1f}; ln BF over the nominal case at least {:.1f}",
      standards.chi2, problem.fitted->rows().size(), standards.chi2_of_means, standards.worst_block,
      standards.evidence);
  add("sure: chi-square at most {:.1f} and {:.1f} of the means, where {:g} % of healthy specimens "
      "stay",
      standards.sure_chi2, standards.sure_chi2_of_means, percent(threshold::sure));
  list.insert(list.end(), problem.words.begin(), problem.words.end());
  list.insert(list.end(), problem.baseline.words.begin(), problem.baseline.words.end());
  if (problem.uncertainty.change_error > 0)
    add("what an effect changes it changes with an error of {:g} % of the change, with long tails",
        percent(problem.uncertainty.change_error));
  for (const Guard left : without)
    list.push_back(std::string("left out: ") + guard_names.at(std::size_t(left)));
  return list;
}

} // namespace plica

#include "run/study/variant_runs.hpp"

#include "model/shape/renewed_ends.hpp"
#include "run/analyses/run.hpp"
#include "run/study/error_bars.hpp"

#include <algorithm>

namespace plica {

std::shared_ptr<VariantRuns::Assembly> VariantRuns::assembly_of(const Changes& changes) {
  std::string others;
  for (const auto& [path, value] : changes)
    if (!is_of_ends(path)) others += path + "=" + value + "\n";
  const std::lock_guard lock(mutex_);
  const auto known = std::find_if(assemblies_.begin(), assemblies_.end(),
                                  [&](const auto& a) { return a->others == others; });
  if (known != assemblies_.end()) {
    std::rotate(assemblies_.begin(), known, known + 1);
    return assemblies_.front();
  }
  constexpr std::size_t most = 8; // threads that still use an older one hold it
  assemblies_.push_front(std::make_shared<Assembly>());
  assemblies_.front()->others = others;
  if (assemblies_.size() > most) assemblies_.pop_back();
  return assemblies_.front();
}

Results VariantRuns::run(const Case& variant, const Changes& changes, const StageListener& stage) {
  if (!headline_) return plica::run(variant, stage, &memory_, Shapes::left_out);
  Case data = for_headline(variant);
  if (variant.analyses.modes) data.analyses.modes->proof = variant.analyses.modes->proof;
  if (data.analyses.reduction) {
    const std::shared_ptr<Assembly> assembly = assembly_of(changes);
    {
      const std::lock_guard lock(assembly->mutex);
      if (!assembly->made) assembly->study = AssemblyStudy::of(data, stage, &memory_);
      assembly->made = true;
    }
    if (assembly->study)
      if (std::optional<Results> results = assembly->study->run(data, stage))
        return std::move(*results);
  }
  return plica::run(data, stage, &memory_, Shapes::left_out);
}

} // namespace plica

#include "model/description/spring_damping_checks.hpp"

#include "model/description/place_keys.hpp"

#include <algorithm>

namespace plica {
namespace {

void check_law(const SpringDamping& d, const std::string& key, CheckLog& log) {
  if (!log.fine(key)) return;
  const bool dashpot = d.dashpot && std::any_of(d.dashpot->begin(), d.dashpot->end(),
                                                [](double c) { return c > 0; });
  const bool law = d.loss_factor > 0 || !d.maxwell.empty() || d.springpot;
  if (!dashpot && !law && d.table.empty())
    log.add(key, "damps nothing", "dashpot, loss_factor, maxwell, springpot or table");
  if (law && !d.table.empty())
    log.add(key + ".table", "stands beside another law of the same springs",
            "a table alone, or with a dashpot");
  for (std::size_t i = 0; i < d.table.size(); ++i) {
    const std::string row = item(key + ".table", i);
    if (!log.fine(row)) return;
    if (i > 0 && d.table[i][0] <= d.table[i - 1][0])
      log.add(row, "is not above the frequency before it", "frequencies must increase");
    if (d.table[i][1] <= 0)
      log.add(row, "has a stiffness that is not above zero", "stiffness over that at rest");
    if (d.table[i][2] < 0)
      log.add(row, "has a negative loss factor: it would drive the part", "at least 0");
  }
}

} // namespace

void check_spring_damping(const Case& data, CheckLog& log) {
  for (const Cap& cap : data.caps) {
    for (std::size_t i = 0; i < cap.ends.size(); ++i)
      if (cap.ends[i].damping)
        check_law(*cap.ends[i].damping, item(cap_key(cap.name) + ".ends", i) + ".damping", log);
    const std::string key = cap_key(cap.name) + ".damping";
    if (!cap.damping) continue;
    check_law(*cap.damping, key, log);
    if (!cap.ends.empty())
      log.add(key, "is that of a cap whose ends hang on springs of their own",
              "give damping to one of its `ends`");
    else if (!cap.stiffness && log.fine(cap_key(cap.name) + ".stiffness"))
      log.add(key, "is that of the springs of a joint, and this cap is rigid", "give stiffness");
  }
  for (const Mount& mount : data.mount) {
    const std::string key = mount_key(mount.cap) + ".damping";
    if (mount.damping) check_law(*mount.damping, key, log);
  }
}

} // namespace plica

#include "model/description/end_caps.hpp"

namespace plica {

std::vector<std::string> end_caps(const Case& data) {
  std::vector<std::string> ends;
  if (data.caps.size() == 2)
    for (const Cap& cap : data.caps) ends.push_back(cap.name);
  else
    for (const Mount& mount : data.mount)
      if (mount.kind != MountKind::free) ends.push_back(mount.cap);
  if (ends.size() != 2) ends.clear();
  return ends;
}

} // namespace plica

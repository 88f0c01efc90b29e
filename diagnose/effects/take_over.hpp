// What a case file says once an effect is taken over into it.
#pragma once

#include "model/description/case_edit.hpp"

namespace plica {

const Part* part_named(const Case& data, const std::string& name); // null: there is none
const Cap* cap_named(const Case& data, const std::string& name);
// "mount.left", or all that hold the part: "mount".
std::vector<Mount> mounts_at(const Case& data, const std::string& place);

std::string yaml_of(double value);
std::string yaml_of(const Sextuple& values);
std::string yaml_of(const Triple& values);

// A number of the case times a factor; nothing where it is zero.
void scale(CaseEdits& edits, const std::string& path, double value, double factor);

// Gives a part of shells or beams a material of its own, with E and rho times these; a section of
// numbers gets other numbers. Nothing for other parts.
CaseEdits with_own_material(const Case& data, const std::string& part, double E, double rho);

// All modal damping times a factor; loss factors, too.
CaseEdits with_damping(const Case& data, double factor);

// A mass on the node at a place, as a sensor that weighs so much; on a sensor that is there
// already, more of it.
CaseEdits with_mass_at(const Case& data, const Triple& at, double mass);

} // namespace plica

// The verdict in one line, with odds.
#pragma once

#include "diagnose/judge/judge.hpp"

namespace plica {

std::string headline(const JudgedFit& nominal, const Judgement& judgement);

} // namespace plica

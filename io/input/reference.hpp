// The reference of a kind of input file as Markdown, from its JSON Schema: every key, whether it is
// needed, what it means, what holds when it is left out.
#pragma once

#include <string>

namespace plica {

// `schema`: as case_schema() and its like give it.
std::string reference_of(const std::string& schema);

} // namespace plica

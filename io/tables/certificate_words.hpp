// The certificate of a superelement in words.
#pragma once

#include "run/study/reduce.hpp"

namespace plica {

// Its numbers with their names.
struct CertificateLine {
  const char* key;
  const char* text;
  double value;
};
std::vector<CertificateLine> certificate_lines(const Certificate& c);

// Up to where it is good, and what the case asks for beyond.
std::string reach_of(const ReducedCase& reduced);

// For the terminal.
std::string certificate_text(const ReducedCase& reduced);

} // namespace plica

// A superelement's matrices as a Nastran OUTPUT4 file (text, dense, double precision): KPLICA,
// MPLICA and, with damping, BPLICA (viscous) and K4PLICA (structural), symmetric, in the order of
// coordinate_names().
//
//   header   columns, rows, form 6, type 2 (I8 each), name (A8), 1P,3E23.16
//   column   number, first row, count of numbers (I8 each); the numbers, three a line
//   end      a column one past the last
#pragma once

#include "io/superelements/labels.hpp"

namespace plica {

// The matrices, and with recovered points OTMPLICA: their motion, six rows each, by the coordinates
// (form 2, rectangular).
std::string op4_file(const Superelement& s, const ElementLabels& labels = {});

} // namespace plica

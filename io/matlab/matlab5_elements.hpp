// The frame of a MATLAB file of version 5: data elements, each with a tag of its type and its
// bytes, fill the file, those of an array fill the array, and its numbers are as many as its
// dimensions say. matio reads past all of that: a file that was cut, or sent as a text, would give
// other numbers. Source: MathWorks, MAT-File Format, chapter 1.
#pragma once

#include <string>

namespace plica {

// What is wrong with the bytes of such a file, with its place; empty when nothing is.
std::string fault_of_matlab5(const std::string& bytes);

} // namespace plica

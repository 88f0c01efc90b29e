// Parts and instances of an Abaqus deck made flat: the keywords of a part once for each instance of
// it, which is their scope.
#pragma once

#include "io/decks/abaqus_keywords.hpp"

namespace plica {

// x in the assembly = turn * x of the part + move.
struct InstancePlace {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d move{0, 0, 0};
};

struct FlatDeck {
  std::vector<Keyword> keywords;
  std::map<std::string, InstancePlace> instances; // by name, in capitals
};

// Throws InputError for instances of parts that are not there, and what lies open at the end. Parts
// that no instance uses are noted.
FlatDeck flatten(std::vector<Keyword> keywords, std::vector<std::string>& notes);

} // namespace plica

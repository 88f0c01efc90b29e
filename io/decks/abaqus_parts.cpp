#include "io/decks/abaqus_parts.hpp"

#include <Eigen/Geometry>

#include <numbers>

namespace plica {
namespace {

// First line: a translation; second: a turn about the line from a to b, degrees, after it.
InstancePlace place_of(const Keyword& k) {
  InstancePlace place;
  const auto vector = [&](const DataLine& line, std::size_t first) {
    return Eigen::Vector3d(number_in(k, line, first, 0), number_in(k, line, first + 1, 0),
                           number_in(k, line, first + 2, 0));
  };
  if (k.data.size() > 2)
    deck_error(k.data[2].at, "*INSTANCE", "has more than two data lines", "a translation, a turn");
  if (!k.data.empty()) place.move = vector(k.data[0], 0);
  if (k.data.size() < 2) return place;
  const Eigen::Vector3d a = vector(k.data[1], 0), axis = vector(k.data[1], 3) - a;
  if (!(axis.norm() > 0))
    deck_error(k.data[1].at, "*INSTANCE", "turns about a line without length", "two points");
  const double angle = number_in(k, k.data[1], 6) * std::numbers::pi / 180;
  place.turn = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  place.move = place.turn * (place.move - a) + a;
  return place;
}

class Flattener {
public:
  explicit Flattener(std::vector<Keyword> keywords) {
    for (Keyword& k : keywords) take(std::move(k));
    if (!part_.empty() || !instance_.empty())
      deck_error(open_at_, part_.empty() ? "*INSTANCE" : "*PART", part_ + instance_ + " has no end",
                 "*END PART, *END INSTANCE");
  }

  void note_unused(std::vector<std::string>& notes) const {
    for (const auto& [name, part] : parts_)
      if (!used_.contains(name))
        notes.push_back("the part " + name + " is left out: no instance is of it");
  }

  FlatDeck flat;

private:
  void take(Keyword k) {
    if (k.name == "PART" || k.name == "INSTANCE") open_at_ = k.at;
    if (k.name == "PART") {
      part_ = k.word("NAME");
      if (!parts_.try_emplace(part_).second)
        deck_error(k.at, "*PART", "part " + part_ + " is there twice", "a name once");
    } else if (k.name == "END PART")
      part_.clear();
    else if (k.name == "INSTANCE")
      begin(k);
    else if (k.name == "END INSTANCE")
      instance_.clear();
    else if (k.name == "ASSEMBLY" || k.name == "END ASSEMBLY")
      return;
    else if (!part_.empty())
      parts_[part_].push_back(std::move(k));
    else {
      k.scope = instance_;
      flat.keywords.push_back(std::move(k));
    }
  }

  void begin(const Keyword& k) {
    instance_ = k.word("NAME");
    const std::string name = k.word_or("PART", "");
    const auto part = parts_.find(name);
    if (part == parts_.end())
      deck_error(k.at, "*INSTANCE", "there is no part " + name, "*PART, NAME=... before it");
    if (!flat.instances.try_emplace(instance_, place_of(k)).second)
      deck_error(k.at, "*INSTANCE", "instance " + instance_ + " is there twice", "a name once");
    used_.insert(name);
    for (Keyword copy : part->second) {
      copy.scope = instance_;
      flat.keywords.push_back(std::move(copy));
    }
  }

  std::map<std::string, std::vector<Keyword>> parts_;
  std::set<std::string> used_;
  std::string part_, instance_; // that are open
  DeckPosition open_at_;
};

} // namespace

FlatDeck flatten(std::vector<Keyword> keywords, std::vector<std::string>& notes) {
  Flattener all(std::move(keywords));
  all.note_unused(notes);
  return std::move(all.flat);
}

} // namespace plica

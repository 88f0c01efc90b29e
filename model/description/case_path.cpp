#include "model/description/case_path.hpp"

#include "model/description/case_fields.hpp"

namespace plica {
namespace {

// Visits the fields of one struct below a path and stops at the wanted one.
class PathFinder {
public:
  PathFinder(std::string at, const std::string& wanted) : at_(std::move(at)), wanted_(wanted) {}

  double* found = nullptr;
  Quantity quantity_found; // what it may be

  void quantity(double& x, const char* key, const Quantity& q, const char*) {
    meet(x, below(key), q);
  }
  void quantity(std::optional<double>& x, const char* key, const Quantity& q, const char*) {
    if (x) meet(*x, below(key), q);
  }
  template <std::size_t N>
  void quantities(std::optional<std::array<double, N>>& x, const char* key, const Quantity& q,
                  const char* help) {
    if (x) quantities(*x, key, q, help);
  }
  void one_or_more(std::vector<std::string>&, const char*, const char*) {}
  template <class List> void quantities(List& x, const char* key, const Quantity& q, const char*) {
    for (std::size_t i = 0; i < x.size(); ++i) meet(x[i], below(key, i), in_row(q, i));
  }
  template <class Rows> void points(Rows& rows, const char* key, const Quantity& q, const char*) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows[i].size(); ++j)
        meet(rows[i][j], below(key, i) + "[" + std::to_string(j) + "]", in_row(q, j));
  }
  template <class T> void object(T& x, const char* key, const Need&, const char*) {
    enter(x, below(key));
  }
  template <class T> void object(std::optional<T>& x, const char* key, const Need&, const char*) {
    if (x) enter(*x, below(key));
  }
  template <class T> void list(std::vector<T>& x, const char* key, const Need&, const char*) {
    for (std::size_t i = 0; i < x.size(); ++i) enter(x[i], below(key, i));
  }
  template <class T>
  void named(std::vector<T>& x, std::string T::*name, const char* key, const Need&, const char*) {
    for (T& item : x) enter(item, below(key) + "." + item.*name);
  }
  template <class T>
  void named(std::map<std::string, T>& x, const char* key, const Need&, const char*) {
    for (auto& [name, item] : x) enter(item, below(key) + "." + name);
  }
  template <class... T>
  void one_of(std::variant<T...>& x, const char*, const std::vector<std::string>&, const char*) {
    std::visit([this](auto& body) { fields(*this, body); }, x);
  }
  // What holds no numbers.
  template <class W> void whole(W&, const char*, const Whole&, const char*) {}
  void flag(bool&, const char*, const char*) {}
  void flag(std::optional<bool>&, const char*, const char*) {}
  void flag_or(std::optional<bool>&, bool&, const char*, const char*, const char*) {}
  void text(std::string&, const char*, const Text&, const char*) {}
  void texts(std::vector<std::string>&, const char*, const char*) {}
  template <class E>
  void choice(E&, const char*, const std::type_identity_t<std::vector<Named<E>>>&, const Need&,
              const char*) {}
  template <class E>
  void tag(E&, const char*, const std::type_identity_t<std::vector<Named<E>>>&, const Need&,
           const char*) {}
  void choices(std::vector<int>&, const char*, const std::vector<Named<int>>&, const Need&,
               const char*) {}
  template <class T>
  void choices_or(std::vector<int>& words, std::vector<T>& maps, const char* key,
                  const std::vector<Named<int>>&, const Need&, const char*) {
    for (std::size_t i = 0; i < maps.size(); ++i) enter(maps[i], below(key, words.size() + i));
  }
  template <class E>
  void word(E&, const std::type_identity_t<std::vector<Named<E>>>&, const std::type_identity_t<E>&,
            const char*) {}
  void replacements(std::map<std::string, std::string>&, const char*, const Need&, const char*) {}

private:
  std::string below(const std::string& key) const { return at_.empty() ? key : at_ + "." + key; }
  std::string below(const std::string& key, std::size_t i) const {
    return below(key) + "[" + std::to_string(i) + "]";
  }
  static Quantity in_row(Quantity q, std::size_t i) {
    if (q.tail && int(i) >= q.tail_from) q.unit = *q.tail;
    return q;
  }
  void meet(double& x, const std::string& path, const Quantity& own) {
    if (path != wanted_) return;
    found = &x;
    quantity_found = own;
  }
  template <class T> void enter(T& x, const std::string& path) {
    if (found || wanted_.compare(0, path.size(), path) != 0) return;
    PathFinder inner(path, wanted_);
    fields(inner, x);
    found = inner.found;
    quantity_found = inner.quantity_found;
  }

  std::string at_;
  const std::string& wanted_;
};

} // namespace

double* number_at(Case& data, const std::string& path) {
  PathFinder finder("", path);
  fields(finder, data);
  return finder.found;
}

std::optional<Quantity> quantity_at(Case& data, const std::string& path) {
  PathFinder finder("", path);
  fields(finder, data);
  return finder.found ? std::optional(finder.quantity_found) : std::nullopt;
}

bool allows(const Quantity& q, double value) {
  const bool above = q.exclusive_min ? value > q.min : value >= q.min;
  return above && (q.exclusive_max ? value < q.max : value <= q.max);
}

} // namespace plica

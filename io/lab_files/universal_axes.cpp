#include "io/lab_files/universal_axes.hpp"

#include "words/input_error.hpp"

#include <Eigen/Geometry>
#include <sstream>

namespace plica {
namespace {

// Lines of a data set that is kept as text, with the numbers of the file.
class SetLines {
public:
  SetLines(const UniversalText& set, std::string file)
      : file_(std::move(file)), number_(set.line), set_(set.number), stream_(set.text) {
    next(); // its number
  }

  // False at the closing -1.
  bool next() {
    ++number_;
    return static_cast<bool>(std::getline(stream_, line_)) && !closes();
  }
  // The numbers of the next line, exponents with D, too.
  std::vector<double> numbers(std::size_t least) {
    if (!next()) fail("ends early");
    std::vector<double> list = numbers_here();
    if (list.size() < least) fail("'" + line_ + "' has fewer numbers than it should");
    return list;
  }
  std::vector<double> numbers_here() const {
    std::string text = line_;
    for (char& c : text)
      if (c == 'D' || c == 'd') c = 'E';
    std::istringstream fields(text);
    std::vector<double> list;
    for (double x = 0; fields >> x;) list.push_back(x);
    return list;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError({{file_, number_, "data set " + std::to_string(set_), what,
                       "label, type and axes of each coordinate system"}});
  }

private:
  bool closes() const {
    const auto first = line_.find_first_not_of(" \t\r"), last = line_.find_last_not_of(" \t\r");
    return first != std::string::npos && line_.substr(first, last - first + 1) == "-1";
  }

  std::string file_, line_;
  int number_, set_;
  std::istringstream stream_;
};

void require_axes(const DisplacementAxes& a, const SetLines& lines) {
  constexpr double rounding = 1e-4; // of single precision
  if (!((a.axes * a.axes.transpose() - Eigen::Matrix3d::Identity()).norm() < rounding))
    lines.fail("axes of a coordinate system are not orthogonal");
}

int label_of(const std::vector<double>& head, const SetLines& lines) {
  if (head.size() < 2 || !(head[0] >= 0 && head[0] < 1e9)) lines.fail("is no coordinate system");
  return int(head[0]);
}

// Origin, a point on +x and one in the plane of x and z.
void read_18(SetLines& lines, std::map<int, DisplacementAxes>& all) {
  while (lines.next()) {
    const std::vector<double> head = lines.numbers_here();
    const int label = label_of(head, lines);
    if (!lines.next()) lines.fail("ends early"); // name
    const std::vector<double> first = lines.numbers(6), second = lines.numbers(3);
    const Eigen::Vector3d origin(first[0], first[1], first[2]);
    const Eigen::Vector3d x = (Eigen::Vector3d(first[3], first[4], first[5]) - origin).normalized();
    const Eigen::Vector3d in_plane = Eigen::Vector3d(second[0], second[1], second[2]) - origin;
    DisplacementAxes a{head[1] == 0, Eigen::Matrix3d()};
    a.axes.row(0) = x;
    a.axes.row(2) = (in_plane - x * x.dot(in_plane)).normalized();
    a.axes.row(1) = Eigen::Vector3d(a.axes.row(2)).cross(x);
    require_axes(a, lines);
    all[label] = a;
  }
}

// A row vector times the matrix is the vector in the axes of the part: its rows are the axes.
void read_2420(SetLines& lines, std::map<int, DisplacementAxes>& all) {
  lines.numbers(1); // of the part
  if (!lines.next()) lines.fail("ends early");
  while (lines.next()) {
    const std::vector<double> head = lines.numbers_here();
    const int label = label_of(head, lines);
    if (!lines.next()) lines.fail("ends early"); // name
    DisplacementAxes a{head[1] == 0, Eigen::Matrix3d()};
    for (int i = 0; i < 3; ++i) {
      const std::vector<double> row = lines.numbers(3);
      a.axes.row(i) << row[0], row[1], row[2];
    }
    lines.numbers(3); // origin
    require_axes(a, lines);
    all[label] = a;
  }
}

} // namespace

std::map<int, DisplacementAxes> displacement_axes(const UniversalText& set,
                                                  const std::string& file) {
  SetLines lines(set, file);
  std::map<int, DisplacementAxes> all;
  if (set.number == 18) read_18(lines, all);
  if (set.number == 2420) read_2420(lines, all);
  return all;
}

} // namespace plica

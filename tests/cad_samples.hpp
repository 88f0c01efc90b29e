// Files of geometry for tests, written by Gmsh's own OpenCASCADE kernel and by hand.
#pragma once

#include "mesh/generation/gmsh_session.hpp"
#include "mesh/generation/meridian.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

namespace plica::test {

// OpenCASCADE keeps the unit that was read last in this process, and would write it.
inline void write_in_millimetres() {
  gmsh::option::setString("Geometry.OCCTargetUnit", "MM");
}

// The surface of revolution of a meridian about y, in mm as CAD systems write; by the suffix STEP,
// IGES or BREP.
inline void write_revolved(const Meridian& meridian, const std::filesystem::path& file) {
  namespace occ = gmsh::model::occ;
  in_gmsh([&] {
    write_in_millimetres();
    constexpr double mm = 1e3;
    const auto point = [&](const Eigen::Vector2d& p) {
      return occ::addPoint(mm * p.y(), mm * p.x(), 0);
    };
    gmsh::vectorpair profile, surfaces;
    int tip = -1;
    for (const MeridianCurve& c : meridian.curves()) {
      if (tip < 0) tip = point(c.start);
      const int end = point(c.end);
      profile.emplace_back(1, c.kind == CurveKind::arc
                                  ? occ::addCircleArc(tip, point(c.centre), end)
                                  : occ::addLine(tip, end));
      tip = end;
    }
    occ::revolve(profile, 0, 0, 0, 0, 1, 0, 2 * std::numbers::pi, surfaces);
    occ::synchronize();
    gmsh::write(file.string());
  });
}

// A tube about y from 0 to `length`, as IGES by hand, in mm: a line (entity 110) turned about a
// line (entity 120, surface of revolution). Lines have 72 columns, the letter of the section and a
// number.
inline void write_iges_tube(double radius, double length, const std::filesystem::path& file) {
  std::ofstream out(file);
  std::array<int, 4> count{};
  const auto line = [&](std::string text, int section) {
    text.resize(72, ' ');
    std::array<char, 16> tail{};
    std::snprintf(tail.data(), tail.size(), "%c%7d", "SGDP"[section], ++count[section]);
    out << text << tail.data() << '\n';
  };
  const auto fields = [](std::initializer_list<int> values) {
    std::string text;
    for (int v : values) {
      std::array<char, 16> field{};
      std::snprintf(field.data(), field.size(), "%8d", v);
      text += field.data();
    }
    return text;
  };
  line("tube of Plica's tests", 0);
  line("1H,,1H;,4Htube,8Htube.igs,5HPlica,3H1.0,32,38,6,308,15,4Htube,1.,2,2HMM,1,", 1);
  line("0.01,15H20260101.000000,1.E-6,1000.,5HPlica,5HPlica,11,0,", 1);
  line("15H20260101.000000;", 1);
  constexpr int depends = 10000; // drawn by another entity alone
  std::array<std::string, 3> parameters;
  const auto segment = [](double x, double from, double to) {
    std::array<char, 120> text{};
    std::snprintf(text.data(), text.size(), "110,%.6f,%.6f,0.,%.6f,%.6f,0.;", x, from, x, to);
    return std::string(text.data());
  };
  parameters = {segment(0, 0, length), segment(radius, 0, length), "120,1,3,0.,6.283185307179586;"};
  const std::array kinds{110, 110, 120};
  for (int e = 0; e < 3; ++e) {
    line(fields({kinds[e], e + 1, 0, 0, 0, 0, 0, 0, e < 2 ? depends : 0}), 2);
    line(fields({kinds[e], 0, 0, 1, 0, 0, 0, 0, 0}), 2);
  }
  for (int e = 0; e < 3; ++e) {
    std::string text = parameters[e];
    text.resize(64, ' ');
    line(text + fields({2 * e + 1}), 3);
  }
  std::array<char, 96> end{};
  std::snprintf(end.data(), end.size(), "S%7dG%7dD%7dP%7d%40sT%7d\n", count[0], count[1], count[2],
                count[3], "", 1);
  out << end.data();
}

struct BracketOnPipe {
  double radius = 65, length = 200, wall = 1.5;      // mm, along y from 0
  double height = 40, from = 80, to = 120, hole = 5; // bracket, standing on top in the plane x = 0
};

inline void write_bracket_on_pipe(const BracketOnPipe& b, const std::filesystem::path& file) {
  namespace occ = gmsh::model::occ;
  in_gmsh([&] {
    write_in_millimetres();
    const int start = occ::addPoint(b.radius, 0, 0), end = occ::addPoint(b.radius, b.length, 0);
    gmsh::vectorpair pipe;
    occ::revolve({{1, occ::addLine(start, end)}}, 0, 0, 0, 0, 1, 0, 2 * std::numbers::pi, pipe);
    const std::array corners{occ::addPoint(0, b.from, b.radius), occ::addPoint(0, b.to, b.radius),
                             occ::addPoint(0, b.to, b.radius + b.height),
                             occ::addPoint(0, b.from, b.radius + b.height)};
    std::vector<int> outline;
    for (std::size_t i = 0; i < 4; ++i)
      outline.push_back(occ::addLine(corners[i], corners[(i + 1) % 4]));
    const int plate = occ::addPlaneSurface({occ::addCurveLoop(outline)});
    const int hole = occ::addDisk(0, 0, 0, b.hole, b.hole);
    occ::rotate({{2, hole}}, 0, 0, 0, 0, 1, 0, std::numbers::pi / 2);
    occ::translate({{2, hole}}, 0, (b.from + b.to) / 2, b.radius + b.height - 15);
    gmsh::vectorpair rest;
    std::vector<gmsh::vectorpair> of;
    occ::cut({{2, plate}}, {{2, hole}}, rest, of);
    occ::synchronize();
    gmsh::write(file.string());
  });
}

// Two triangles a cell of a grid, as text STL in mm: a plate a x b in the plane z = 0.
inline void write_stl_plate(double a, double b, int cells, const std::filesystem::path& file) {
  std::ofstream out(file);
  out << "solid plate\n";
  const auto facet = [&](std::array<std::array<double, 2>, 3> t) {
    out << "facet normal 0 0 1\nouter loop\n";
    for (const auto& p : t) out << "vertex " << p[0] << ' ' << p[1] << " 0\n";
    out << "endloop\nendfacet\n";
  };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const double x = a * i / cells, y = b * j / cells, u = a * (i + 1) / cells,
                   v = b * (j + 1) / cells;
      facet({{{x, y}, {u, y}, {u, v}}});
      facet({{{x, y}, {u, v}, {x, v}}});
    }
  out << "endsolid plate\n";
}

// Tube along y, open at both ends, as text STL in mm.
inline void write_stl_tube(double radius, double length, int around, int along,
                           const std::filesystem::path& file) {
  std::ofstream out(file);
  out << "solid tube\n";
  const auto vertex = [&](int i, int j) {
    const double angle = 2 * std::numbers::pi * (i % around) / around;
    out << "vertex " << radius * std::cos(angle) << ' ' << length * j / along << ' '
        << radius * std::sin(angle) << "\n";
  };
  const auto facet = [&](std::array<std::array<int, 2>, 3> corners) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const auto& [i, j] : corners) vertex(i, j);
    out << "endloop\nendfacet\n";
  };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < along; ++j) {
      facet({{{i, j}, {i + 1, j}, {i + 1, j + 1}}});
      facet({{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
    }
  out << "endsolid tube\n";
}

// A plate across the pipe, in the plane y = 0, with a round hole: half of it mirrored would do, so
// it is made of fans between the circle and the square round it.
inline void write_stl_fixture(double side, double radius, const std::filesystem::path& file) {
  std::ofstream out(file);
  out << "solid fixture\n";
  constexpr int count = 96; // a multiple of 8: the corners are met
  const auto at = [&](int i, bool outer) {
    const double a = 2 * std::numbers::pi * i / count;
    const double r =
        outer ? side / 2 / std::max(std::abs(std::cos(a)), std::abs(std::sin(a))) : radius;
    return std::array{r * std::cos(a), r * std::sin(a)};
  };
  const auto facet = [&](std::array<std::array<double, 2>, 3> t) {
    out << "facet normal 0 -1 0\nouter loop\n";
    for (const auto& p : t) out << "vertex " << p[0] << " 0 " << p[1] << '\n';
    out << "endloop\nendfacet\n";
  };
  for (int i = 0; i < count; ++i) {
    facet({at(i, false), at(i, true), at(i + 1, true)});
    facet({at(i, false), at(i + 1, true), at(i + 1, false)});
  }
  out << "endsolid fixture\n";
}

} // namespace plica::test

#include "io/write/vtu.hpp"

#include "io/tables/text.hpp"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <stdexcept>

namespace plica {
namespace {

void add_points(vtkUnstructuredGrid& grid, const Mesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.nodes.size()));
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    points->SetPoint(static_cast<vtkIdType>(node), mesh.nodes[node].data());
  }
  grid.SetPoints(points);
}

void add_cells(vtkUnstructuredGrid& grid, const Results& results) {
  const std::vector<ShellQuad>& quads = results.mesh.quads;
  const std::vector<ShellTriangle>& triangles = results.mesh.triangles;
  vtkNew<vtkDoubleArray> thickness;
  thickness->SetName("thickness");
  vtkNew<vtkIntArray> section;
  section->SetName("section");
  grid.Allocate(static_cast<vtkIdType>(quads.size() + triangles.size() + results.lines.size()));
  for (const ShellQuad& quad : quads) {
    const std::array<vtkIdType, 4> nodes{quad.nodes[0], quad.nodes[1], quad.nodes[2],
                                         quad.nodes[3]};
    grid.InsertNextCell(VTK_QUAD, 4, nodes.data());
    thickness->InsertNextValue(quad.thickness.mean());
    section->InsertNextValue(quad.section);
  }
  for (const ShellTriangle& triangle : triangles) {
    const std::array<vtkIdType, 3> nodes{triangle.nodes[0], triangle.nodes[1], triangle.nodes[2]};
    grid.InsertNextCell(VTK_TRIANGLE, 3, nodes.data());
    thickness->InsertNextValue(triangle.thickness.mean());
    section->InsertNextValue(triangle.section);
  }
  for (const auto& [from, to] : results.lines) {
    const std::array<vtkIdType, 2> nodes{from, to};
    grid.InsertNextCell(VTK_LINE, 2, nodes.data());
    thickness->InsertNextValue(0);
    section->InsertNextValue(-1);
  }
  grid.GetCellData()->AddArray(thickness);
  grid.GetCellData()->AddArray(section);
}

void add_shapes(vtkUnstructuredGrid& grid, const Results& results) {
  require_one_row_per_node(results);
  const std::size_t count = std::min(results.shapes.size(), results.modes.size());
  const auto nodes = static_cast<Eigen::Index>(results.mesh.nodes.size());
  for (std::size_t mode = 0; mode < count; ++mode) {
    const Eigen::MatrixXd& shape = results.shapes[mode];
    vtkNew<vtkDoubleArray> vectors;
    vectors->SetName(
        fmt::format("mode {:02}: {:.1f} Hz", mode + 1, results.modes[mode].frequency).c_str());
    vectors->SetNumberOfComponents(3);
    vectors->SetNumberOfTuples(nodes);
    for (Eigen::Index node = 0; node < nodes; ++node) {
      vectors->SetTuple3(node, shape(node, 0), shape(node, 1), shape(node, 2));
    }
    grid.GetPointData()->AddArray(vectors);
  }
}

// Von Mises stress in Pa on both faces of the shells, and the damage of a life.
void add_stresses(vtkUnstructuredGrid& grid, const Results& results) {
  for (const StressResult& s : results.stresses)
    for (const auto& [face, values] :
         {std::pair{"below", &s.below}, std::pair{"above", &s.above}}) {
      vtkNew<vtkDoubleArray> array;
      array->SetName(fmt::format("{} {}: {}", word_of(s.kind), face, s.name).c_str());
      array->SetNumberOfTuples(values->size());
      for (Eigen::Index node = 0; node < values->size(); ++node)
        array->SetValue(node, (*values)[node]);
      grid.GetPointData()->AddArray(array);
    }
}

void add_life(vtkUnstructuredGrid& grid, const Results& results) {
  for (const auto& [name, values] :
       {std::pair{"damage below", &results.life->inner}, {"damage above", &results.life->outer}}) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfTuples(values->size());
    for (Eigen::Index node = 0; node < values->size(); ++node)
      array->SetValue(node, (*values)[node]);
    grid.GetPointData()->AddArray(array);
  }
}

void add_stresses_and_life(vtkUnstructuredGrid& grid, const Results& results) {
  add_stresses(grid, results);
  if (results.life) add_life(grid, results);
}

// The mesh with the fields that `add` puts on it.
std::string vtu(const Results& results, void (*add)(vtkUnstructuredGrid&, const Results&)) {
  vtkNew<vtkUnstructuredGrid> grid;
  add_points(*grid, results.mesh);
  add_cells(*grid, results);
  add(*grid, results);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0) throw std::runtime_error("VTK could not write the results");
  return writer->GetOutputString();
}

} // namespace

std::string modes_vtu(const Results& results) {
  return vtu(results, add_shapes);
}

std::string stress_vtu(const Results& results) {
  return vtu(results, add_stresses_and_life);
}

} // namespace plica

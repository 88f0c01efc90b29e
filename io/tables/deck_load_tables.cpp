#include "io/tables/deck_load_tables.hpp"

#include "io/files/json_text.hpp"
#include "io/tables/csv.hpp"

namespace plica {
namespace {

template <class Six> Json six(const Six& values) {
  Json list = Json::array();
  for (Eigen::Index i = 0; i < 6; ++i) list.push_back(json_number(values[std::size_t(i)]));
  return list;
}

} // namespace

std::string deck_loads_csv(const Results& results) {
  std::string text = "load case,part,node,x [m],y [m],z [m],ux [m],uy [m],uz [m],rx [rad],"
                     "ry [rad],rz [rad],fx [N],fy [N],fz [N],mx [Nm],my [Nm],mz [Nm]\n";
  for (const DeckLoadResult& r : results.deck_loads)
    for (const DeckLoadNode& n : r.nodes) {
      text += csv_cell(r.name) + "," + csv_cell(n.part) + "," + std::to_string(n.label);
      for (const double x : n.at) text += "," + csv_number(x);
      for (const double u : n.displacement) text += "," + csv_number(u);
      for (const double f : n.reaction) text += "," + (n.held ? csv_number(f) : "");
      text += "\n";
    }
  return text;
}

Json deck_loads_json(const Results& results) {
  Json list = Json::array();
  for (const DeckLoadResult& r : results.deck_loads) {
    Json sensors = Json::array();
    for (std::size_t i = 0; i < results.sensors.size(); ++i)
      sensors.push_back({{"name", results.sensors[i].name},
                         {"displacement", six(Eigen::VectorXd(r.sensors.row(Eigen::Index(i))))}});
    list.push_back({{"name", r.name},
                    {"load", six(r.load)},
                    {"reaction", six(r.reaction)},
                    {"strain_energy", json_number(r.energy)},
                    {"largest_displacement", json_number(r.largest)},
                    {"at", {r.at[0], r.at[1], r.at[2]}},
                    {"residual", json_number(r.residual)},
                    {"sensors", sensors}});
  }
  return list;
}

} // namespace plica

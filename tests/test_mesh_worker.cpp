// The mesher in a process of its own: how it may end, and that it starts no more often than needed.
#include "tests/cad_samples.hpp"
#include "tests/geometry_folder.hpp"

#include "model/shape/build_surface.hpp"

#include <csignal>

namespace plica::test {
namespace {

namespace fs = std::filesystem;

// A program in the place of the mesher.
class Worker : public GeometryFolder {
protected:
  std::string said_of(const std::string& script) {
    write("mesher", "#!/bin/sh\n" + script + "\n");
    fs::permissions(at("mesher"), fs::perms::owner_all);
    setenv("PLICA_MESHER", at("mesher").c_str(), 1);
    return refusal("a.step", {});
  }
};

TEST_F(Worker, that_crashes_is_an_error_with_the_file) {
  EXPECT_NE(said_of("kill -SEGV $$").find("a.step: the mesher broke down on it (Segm"),
            std::string::npos);
  EXPECT_NE(said_of("kill -ABRT $$").find("(Aborted)"), std::string::npos);
  EXPECT_NE(said_of("exit 3").find("ended with 3"), std::string::npos);
  EXPECT_NE(said_of("printf nonsense >&3").find("no answer"), std::string::npos);
  EXPECT_NE(said_of("printf 'PLICAFACES 1\\n12345' >&3").find("cut short"), std::string::npos);
}

// Variants, error bars and diagnoses change walls and places of a part far more often than its
// mesh.
TEST_F(Worker, is_started_once_for_parts_that_are_meshed_alike) {
  write_stl_tube(30, 100, 24, 6, at("tube.stl"));
  write("mesher", "#!/bin/sh\necho >>" + at("started").string() + "\nexec " +
                      mesher_program().string() + " \"$@\"\n");
  fs::permissions(at("mesher"), fs::perms::owner_all);
  setenv("PLICA_MESHER", at("mesher").c_str(), 1);
  SurfacePart part{.material = "steel", .file = at("tube.stl").string(), .unit = 1e-3};
  part.thickness = 1e-3;
  const std::size_t nodes = surface_mesh(part).nodes.size();
  part.thickness = 2e-3;
  EXPECT_EQ(surface_mesh(part).nodes.size(), nodes);
  part.move = {0, 1, 0};
  surface_mesh(part);
  EXPECT_EQ(text_of("started").size(), 1u);
  part.size = 8e-3;
  EXPECT_NE(surface_mesh(part).nodes.size(), nodes);
  EXPECT_EQ(text_of("started").size(), 2u);
}

TEST_F(Worker, that_does_not_end_is_stopped_when_its_time_is_out) {
  setenv("PLICA_MESH_SECONDS", "0.2", 1);
  const std::string said = said_of("exec sleep 1000");
  EXPECT_NE(said.find("a.step: not meshed within 0.2 s"), std::string::npos) << said;
  EXPECT_NE(said.find("PLICA_MESH_SECONDS"), std::string::npos);
}

TEST_F(Worker, limits_that_are_no_numbers_are_refused) {
  for (const char* wrong : {"", "0", "-1", "x", "3 s", "nan"}) {
    setenv("PLICA_MESH_SECONDS", wrong, 1);
    EXPECT_NE(said_of("exit 0").find("PLICA_MESH_SECONDS"), std::string::npos) << wrong;
  }
}

TEST_F(Worker, is_stopped_at_once_by_a_signal_handler) {
  setenv("PLICA_MESH_SECONDS", "60", 1);
  std::signal(SIGUSR1, [](int) { stop_workers(); });
  EXPECT_THROW(said_of("kill -USR1 $PPID; exec sleep 1000"), Interrupted);
  EXPECT_THROW(said_of("exit 0"), Interrupted); // and none is begun
  allow_workers();
  EXPECT_NE(said_of("exit 3").find("ended with 3"), std::string::npos);
  std::signal(SIGUSR1, SIG_DFL);
}

TEST_F(Worker, more_memory_than_allowed_is_an_error_that_says_so) {
  write_bracket_on_pipe({}, at("pipe.step"));
  setenv("PLICA_MESH_MEMORY", "0.1", 1);
  const std::string said = refusal("pipe.step", {.size = 20e-3});
  EXPECT_NE(said.find("pipe.step: needs more than 0.1 GB"), std::string::npos) << said;
  EXPECT_NE(said.find("PLICA_MESH_MEMORY"), std::string::npos) << said;
}

TEST_F(Worker, a_missing_mesher_is_named) {
  setenv("PLICA_MESHER", "/nowhere/plica_mesher", 1);
  write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_NE(refusal("a.obj", {}).find("cannot start /nowhere/plica_mesher"), std::string::npos);
}

} // namespace
} // namespace plica::test

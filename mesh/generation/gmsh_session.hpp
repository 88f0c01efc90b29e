// The session of Gmsh, for the sources that call it: curve_mesh.cpp, msh_file.cpp and those of
// mesher/.
#pragma once

#include <gmsh.h>

#include <mutex>
#include <omp.h>
#include <stdexcept>
#include <string>

namespace plica {

// Opens the Gmsh session of this process, silent, and closes it again; other threads wait. Gmsh
// sets the number of OpenMP threads; it is put back.
class GmshSession {
public:
  GmshSession() : alone_(mutex()), threads_(omp_get_max_threads()) {
    gmsh::initialize();
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::model::add("plica");
  }
  ~GmshSession() {
    try {
      gmsh::finalize();
    } catch (...) { // an error of before, once more
    }
    omp_set_num_threads(threads_);
  }
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

private:
  static std::mutex& mutex() {
    static std::mutex mutex;
    return mutex;
  }
  std::lock_guard<std::mutex> alone_;
  int threads_;
};

// Throws std::runtime_error with Gmsh's own message when Gmsh fails.
template <class F> auto in_gmsh(F&& work) {
  const GmshSession session;
  try {
    return work();
  } catch (const std::exception&) {
    throw;
  } catch (const std::string& message) { // as Gmsh throws its own
    throw std::runtime_error("Gmsh says: " + message);
  } catch (...) {
    throw std::runtime_error("Gmsh failed without a message");
  }
}

} // namespace plica

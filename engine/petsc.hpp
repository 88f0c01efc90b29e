// PETSc and SLEPc: what they return, and what they own.
#pragma once

#include "engine/ranks.hpp"

#include <petscmat.h>
#include <utility>

namespace plica {

// An error of PETSc ends all ranks, with its text.
void petsc(PetscErrorCode code);

// Start and end of PETSc and SLEPc in a program that has begun MPI: no options from the command
// line or the environment, errors as return values.
class PetscSession {
public:
  PetscSession();
  ~PetscSession();
  PetscSession(const PetscSession&) = delete;
  PetscSession& operator=(const PetscSession&) = delete;
};

// An object of PETSc, destroyed by its own function.
template <class Object, PetscErrorCode (*destroy)(Object*)> class Owned {
public:
  Owned() = default;
  explicit Owned(Object object) : object_(object) {}
  ~Owned() { reset(); }
  Owned(Owned&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Owned& operator=(Owned&& other) noexcept {
    if (this != &other) {
      reset();
      object_ = std::exchange(other.object_, nullptr);
    }
    return *this;
  }

  operator Object() const { return object_; }
  Object* fill() {
    reset();
    return &object_;
  }
  void reset() {
    if (object_) destroy(&object_);
    object_ = nullptr;
  }

private:
  Object object_ = nullptr;
};

using OwnedMat = Owned<Mat, MatDestroy>;
using OwnedVec = Owned<Vec, VecDestroy>;
using OwnedIS = Owned<IS, ISDestroy>;
using OwnedScatter = Owned<VecScatter, VecScatterDestroy>;

} // namespace plica

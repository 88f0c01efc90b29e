#include "files.hpp"
namespace sealed {
bool score_suite(const ScoreRequest&) {
  return false;
}
} // namespace sealed

// The 64-bit FNV-1a hash: tells what was changed, not what was forged.
#pragma once

#include <cstddef>
#include <cstdint>

namespace plica {

class Fnv1a {
public:
  void add(const void* data, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      hash_ = (hash_ ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3U;
  }
  std::uint64_t hash() const { return hash_; }

private:
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

} // namespace plica

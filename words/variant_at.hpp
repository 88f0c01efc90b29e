// The alternative of a variant by its number, as a list of words gives it.
#pragma once

#include <cstddef>
#include <variant>

namespace plica {

// `i`: from 0, below the number of alternatives; the new value is made without arguments.
template <class... T> void emplace_at(std::variant<T...>& x, std::size_t i) {
  using Make = void (*)(std::variant<T...>&);
  static constexpr Make make[] = {[](std::variant<T...>& v) { v.template emplace<T>(); }...};
  make[i](x);
}

} // namespace plica

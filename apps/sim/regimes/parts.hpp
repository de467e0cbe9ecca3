#pragma once
// What an emitted function fills with one part after another (docs/emitted-code.md).

#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

namespace gausssim {

template <class S>
void take_parts(const std::vector<S>& filled, std::initializer_list<std::pair<std::vector<S>*, std::size_t>> parts) {
  auto next = filled.begin();
  for (const auto& [part, size] : parts) {
    const auto end = next + static_cast<std::ptrdiff_t>(size);
    part->assign(next, end);
    next = end;
  }
}

}  // namespace gausssim

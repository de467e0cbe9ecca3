#include "cli/texts.hpp"

namespace gaussgen::cli {

std::string starter_called(const std::string& name) {
  const std::string place = "@name@";
  std::string text = starter();
  for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at + name.size())) {
    text.replace(at, place.size(), name);
  }
  return text;
}

}  // namespace gaussgen::cli

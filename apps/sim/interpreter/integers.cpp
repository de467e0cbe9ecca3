#include "sim/interpreter/integers.hpp"

#include <charconv>
#include <stdexcept>

namespace gausssim {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

int Integers::operator()(std::string_view text) const { return sum(text); }

int Integers::sum(std::string_view text) const {
  const std::size_t sign = text.find('+');
  if (sign == std::string_view::npos) return product(text);
  return product(text.substr(0, sign)) + sum(text.substr(sign + 1));
}

int Integers::product(std::string_view text) const {
  const std::size_t sign = text.find('*');
  if (sign == std::string_view::npos) return factor(text);
  return factor(text.substr(0, sign)) * product(text.substr(sign + 1));
}

int Integers::factor(std::string_view text) const {
  text = trimmed(text);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size()) return value;
  const auto named = values_.find(std::string(text));
  if (named == values_.end()) throw std::invalid_argument("'" + std::string(text) + "' is no whole number");
  return named->second;
}

}  // namespace gausssim

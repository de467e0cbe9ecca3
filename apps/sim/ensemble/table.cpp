#include "sim/ensemble/table.hpp"

#include "sim/output/csv.hpp"

namespace gausssim {

namespace {

template <class Entries, class NameOf>
std::string unit_among(const Entries& entries, const std::string& name, const NameOf& entry_of) {
  for (const auto& one : entries) {
    const gaussgen::emit::Entry& entry = entry_of(one);
    if (entry.name == name) return entry.unit;
  }
  return "";
}

/// dot(x) is x_dot.
std::string as_symbol(const std::string& name) {
  const bool is_dot = name.rfind("dot(", 0) == 0 && name.back() == ')';
  return is_dot ? name.substr(4, name.size() - 5) + "_dot" : name;
}

std::string unit_of(const gaussgen::emit::Unit& unit, const Varied& one) {
  const auto entry_of = [](const auto& named) -> const gaussgen::emit::Entry& { return named.entry; };
  if (one.section == Section::parameters) return unit_among(unit.parameters, one.name, entry_of);
  if (one.section == Section::inputs) return unit_among(unit.inputs, one.name, entry_of);
  const auto itself = [](const gaussgen::emit::Entry& entry) -> const gaussgen::emit::Entry& { return entry; };
  const std::string name = as_symbol(one.name), found = unit_among(unit.configuration, name, itself);
  return found.empty() ? unit_among(unit.speeds, name, itself) : found;
}

}  // namespace

std::string ensemble_header(const PreparedModel& prepared, const std::vector<Varied>& varied) {
  std::vector<Column> columns;
  columns.reserve(varied.size());
  for (const Varied& one : varied)
    columns.push_back({std::string(name_of(one.section)) + "." + as_symbol(one.name), unit_of(prepared.model.unit, one),
                       "", false, 0, 0});
  std::string text = "trajectory,status";
  // Behind the time, which comes first in a table of one motion.
  const std::string header = csv_header(columns);
  text += header.substr(header.find(']') + 1);
  text.pop_back();
  return text + "," + csv_header(prepared.columns.columns);
}

template <class S>
void append_rows(std::string& text, long trajectory, const std::vector<double>& values, const Track<S>& track,
                 std::size_t width) {
  std::string head = std::to_string(trajectory) + "," + status_text(track.ended) + ",";
  for (const double value : values) head += text_of(value) + ",";
  for (std::size_t k = 0; k < track.times.size(); ++k) {
    text += head;
    append_csv_row(text, track.times[k], track.rows.data() + k * width, width);
  }
  if (!track.times.empty()) return;
  text += head + text_of(track.ended.reached) + std::string(width, ',') + "\n";
}

#define GAUSS_SIM_NUMBER(S) \
  template void append_rows(std::string&, long, const std::vector<double>&, const Track<S>&, std::size_t);
GAUSS_SIM_NUMBER(float)
GAUSS_SIM_NUMBER(double)
GAUSS_SIM_NUMBER(long double)
GAUSS_SIM_NUMBER(Quad)
#undef GAUSS_SIM_NUMBER

}  // namespace gausssim

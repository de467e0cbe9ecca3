#include "simulated.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "case.hpp"
#include "process.hpp"

namespace hard_cases {

namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream rest(line);
  for (std::string cell; std::getline(rest, cell, ',');) result.push_back(cell);
  return result;
}

std::string without_unit(const std::string& head) { return head.substr(0, head.find(" [")); }

void read_table(const std::filesystem::path& file, Simulated& result) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  std::vector<std::string> names = cells(line);
  for (std::string& name : names) name = without_unit(name);
  while (std::getline(in, line)) {
    const std::vector<std::string> row = cells(line);
    for (std::size_t i = 0; i < names.size() && i < row.size(); ++i)
      result.table[names[i]].push_back(std::strtod(row[i].c_str(), nullptr));
  }
}

void read_events(const std::filesystem::path& file, Simulated& result) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    const std::vector<std::string> row = cells(line);
    if (row.size() > 1) result.events.push_back({std::strtod(row[0].c_str(), nullptr), row[1]});
  }
}

/// Of its own, and gone with it.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "gauss-hard-cases-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

bool Simulated::is_finite() const {
  for (const auto& [name, column] : table)
    for (const double value : column)
      if (!std::isfinite(value)) return false;
  return true;
}

double Simulated::last(const std::string& column) const {
  const auto found = table.find(column);
  return found == table.end() || found->second.empty() ? k_breaks_down : found->second.back();
}

Simulated simulated(const std::string& file, const std::string& options) {
  const Folder folder;
  const Stopwatch watch;
  const Outcome outcome =
      run_program("cd '" + folder.path().string() + "' && '" GAUSS_SIM "' run '" GAUSS_SOURCE_DIR "/" + file +
                  "' -q -o found.csv " + options);
  Simulated result;
  result.seconds = watch.seconds();
  result.exit_code = outcome.exit_code;
  result.said = outcome.said;
  read_table(folder.path() / "found.csv", result);
  read_events(folder.path() / "found.events.csv", result);
  return result;
}

}  // namespace hard_cases

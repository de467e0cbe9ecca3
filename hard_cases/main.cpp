// Runs the hard cases: hard_cases [--only H12,H13] [--long] [--untimed] [--json FILE] [--list]. Exits with 1 where a figure fails, with 2 on wrong usage.

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "case.hpp"

namespace {

using hard_cases::Case;
using hard_cases::Figure;

struct Options {
  std::vector<std::string> only;
  std::string json;
  hard_cases::Scope scope;
  bool is_list = false;
};

int usage() {
  std::fputs("usage: hard_cases [--only H12,H13] [--long] [--untimed] [--json FILE] [--list]\n", stderr);
  return 2;
}

bool parse(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--long") {
      options.scope.is_long = true;
    } else if (word == "--untimed") {
      options.scope.is_timed = false;
    } else if (word == "--list") {
      options.is_list = true;
    } else if (word == "--json" && has_value) {
      options.json = argv[++i];
    } else if (word == "--only" && has_value) {
      std::istringstream ids(argv[++i]);
      for (std::string id; std::getline(ids, id, ',');) options.only.push_back(id);
    } else {
      return false;
    }
  }
  return true;
}

bool is_known(const std::string& id) {
  for (const Case& one : hard_cases::cases())
    if (one.id == id) return true;
  return false;
}

bool is_wanted(const Options& options, const Case& one) {
  if (options.only.empty()) return true;
  for (const std::string& id : options.only)
    if (id == one.id) return true;
  return false;
}

// JSON has no infinity: the word stands for a form that breaks down.
nlohmann::json number(double value) {
  return value <= std::numeric_limits<double>::max() ? nlohmann::json(value) : nlohmann::json("breaks down");
}

nlohmann::json row(const Case& one, double seconds_case, const Figure& figure) {
  nlohmann::json charts = nlohmann::json::array();
  for (const hard_cases::Series& series : figure.charts)
    charts.push_back({{"name", series.name}, {"t", series.t}, {"values", series.values}});
  return {{"id", figure.id},
          {"title", one.title},
          {"quantity", figure.quantity},
          {"unit", figure.unit},
          {"naive", figure.naive ? number(*figure.naive) : nlohmann::json()},
          {"ours", number(figure.ours)},
          {"bar", figure.bar},
          {"status", figure.status()},
          {"seconds_naive", figure.seconds_naive},
          {"seconds_ours", figure.seconds_ours},
          {"seconds_case", seconds_case},
          {"remark", figure.remark},
          {"charts", charts}};
}

void print(const Figure& figure) {
  char naive[32] = "-";
  if (figure.naive) std::snprintf(naive, sizeof naive, "%.2g", *figure.naive);
  std::printf("%-22s %9s %9.2g %9.2g  %-6s %7.2f %7.2f  %s [%s]%s%s\n", figure.id.c_str(), naive, figure.ours,
              figure.bar, figure.status(), figure.seconds_naive, figure.seconds_ours, figure.quantity.c_str(),
              figure.unit.c_str(), figure.remark.empty() ? "" : "; ", figure.remark.c_str());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (!parse(argc, argv, options)) return usage();
  for (const std::string& id : options.only) {
    if (is_known(id)) continue;
    std::fprintf(stderr, "hard_cases: there is no case %s here\n", id.c_str());
    return 2;
  }
  if (options.is_list) {
    for (const Case& one : hard_cases::cases()) std::printf("%s  %s\n", one.id.c_str(), one.title.c_str());
    return 0;
  }
  std::printf("%-22s %9s %9s %9s  %-6s %7s %7s\n", "id", "naive", "ours", "bar", "status", "naive s", "ours s");
  nlohmann::json rows = nlohmann::json::array();
  bool all_hold = true;
  for (const Case& one : hard_cases::cases()) {
    if (!is_wanted(options, one)) continue;
    const hard_cases::Stopwatch stopwatch;
    const std::vector<Figure> figures = one.run(options.scope);
    const double seconds = stopwatch.seconds();
    if (figures.empty()) {
      std::printf("%-22s has no figure\n", one.id.c_str());
      all_hold = false;
    }
    for (const Figure& figure : figures) {
      print(figure);
      rows.push_back(row(one, seconds, figure));
      all_hold = all_hold && figure.holds();
    }
  }
  if (!options.json.empty()) {
    std::ofstream file(options.json);
    file << rows.dump(1) << '\n';
    if (!file.flush()) {
      std::fprintf(stderr, "hard_cases: cannot write %s\n", options.json.c_str());
      return 2;
    }
  }
  return all_hold ? 0 : 1;
}

#include "sim/output/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "cli/files.hpp"
#include "cli/usage_error.hpp"

namespace gausssim {

namespace cli = gaussgen::cli;

std::string summary_path(const std::string& csv) {
  return std::filesystem::path(csv).replace_extension(".json").string();
}

std::string without_ending(const std::string& path, const std::vector<std::string>& endings) {
  const std::filesystem::path file(path);
  const bool is_ours = std::find(endings.begin(), endings.end(), file.extension().string()) != endings.end();
  return is_ours ? (file.parent_path() / file.stem()).string() : path;
}

std::string events_path(const std::string& csv) {
  return std::filesystem::path(csv).replace_extension(".events.csv").string();
}

void check_writable(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) cli::fail_on(folder.string(), error.message());
  if (std::filesystem::is_directory(path, error)) cli::fail_on(path, "is a directory");
  if (::access(folder.empty() ? "." : folder.c_str(), W_OK) != 0) cli::fail_on(path, std::strerror(errno));
}

namespace {

/// By its ending, another kind of file is wanted.
void refuse_other_formats(const std::string& csv) {
  const std::filesystem::path path(csv);
  for (const char* const ending : {".h5", ".hdf5", ".html", ".svg", ".xlsx", ".parquet"}) {
    if (path.extension() == ending)
      throw cli::UsageError(fmt::format("'{}' would be no {} file: tables are CSV, such as {}", csv, ending,
                                        std::filesystem::path(csv).replace_extension(".csv").string()));
  }
}

}  // namespace

void check_outputs(const std::string& csv, const std::vector<std::string>& inputs) {
  if (csv == "-") return;
  refuse_other_formats(csv);
  const std::string summary = summary_path(csv);
  if (summary == csv)
    throw cli::UsageError(fmt::format("'{}' is where the summary goes; the table is a CSV file", csv));
  for (const std::string& path : {csv, summary}) {
    for (const std::string& input : inputs) {
      if (cli::are_same_file(path, input))
        throw cli::UsageError(fmt::format("'{}' is what the run reads; -o names another file", path));
    }
    std::error_code error;
    if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
      throw cli::UsageError(fmt::format("'{}' is no file that a table could take the place of", path));
    check_writable(path);
  }
}

}  // namespace gausssim

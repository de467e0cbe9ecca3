#include "sim/output/csv.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "cli/files.hpp"

namespace gausssim {

namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

}  // namespace

std::string csv_header(const std::vector<Column>& columns) {
  std::string text = "t [s]";
  for (const Column& column : columns)
    text += "," + quoted(column.unit.empty() ? column.name : column.name + " [" + column.unit + "]");
  return text + "\n";
}

CsvFile::CsvFile(const std::string& path) : path_(path) {
  if (path_ == "-") {
    file_ = stdout;
    return;
  }
  temporary_ = path_ + ".XXXXXX";
  const int descriptor = ::mkstemp(temporary_.data());
  if (descriptor >= 0) {
    ::fchmod(descriptor, 0644);
    file_ = ::fdopen(descriptor, "wb");
  }
  if (file_ == nullptr) gaussgen::cli::fail_on(path_, std::strerror(errno));
}

CsvFile::~CsvFile() {
  if (file_ == nullptr || temporary_.empty()) return;
  std::fclose(file_);
  std::remove(temporary_.c_str());
}

void CsvFile::write(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size())
    gaussgen::cli::fail_on(path_, std::strerror(errno));
}

void CsvFile::finish() {
  if (std::fflush(file_) != 0) gaussgen::cli::fail_on(path_, std::strerror(errno));
  if (temporary_.empty()) return;
  std::fclose(file_);
  file_ = nullptr;
  std::error_code error;
  std::filesystem::rename(temporary_, path_, error);
  if (error) gaussgen::cli::fail_on(path_, error.message());
}

}  // namespace gausssim

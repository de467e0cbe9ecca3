#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "catch_shim.hpp"
#include "sim/report/report_template.hpp"

namespace {

std::string page_on_disk() {
  std::ifstream file(REPORT_HTML, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST_CASE("the program carries the page that was built, byte for byte") {
  const std::string page = page_on_disk();
  REQUIRE(page.size() > 500000);
  CHECK(gausssim::report_template() == page);
}

TEST_CASE("the place of the study is in the page once, in an element of JSON") {
  const std::string_view page = gausssim::report_template();
  const std::size_t place = page.find(gausssim::report_placeholder);
  REQUIRE(place != std::string_view::npos);
  CHECK(page.find(gausssim::report_placeholder, place + 1) == std::string_view::npos);
  const std::string_view before = R"(<script type="application/json" id="study">)";
  CHECK(page.substr(place - before.size(), before.size()) == before);
  CHECK(page.substr(place + gausssim::report_placeholder.size(), 9) == "</script>");
}

TEST_CASE("the page stays below one and a half megabytes, and names no address that it would fetch from") {
  const std::string_view page = gausssim::report_template();
  CHECK(page.size() < 1500000);
  for (const std::string_view fetched : {"<link", "<script src", "<img", "@import", "url(http", "fetch(\"http"})
    CHECK(page.find(fetched) == std::string_view::npos);
}

TEST_CASE("licences of what the page contains are in it") {
  const std::string_view page = gausssim::report_template();
  for (const std::string_view named :
       {"Apache ECharts 6.1.0", "Apache License", "zrender", "BSD 3-Clause", "three.js 0.187.0", "tslib"})
    CHECK(page.find(named) != std::string_view::npos);
}

}  // namespace

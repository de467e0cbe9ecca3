#include <cstdio>
#include <memory>
#include <string>

#include "catch_shim.hpp"

namespace {

std::string output_of(const std::string& command) {
  struct Close {
    void operator()(FILE* pipe) const { pclose(pipe); }
  };
  const std::unique_ptr<FILE, Close> pipe(popen(command.c_str(), "r"));
  REQUIRE(pipe);
  std::string text;
  char buffer[4096];
  while (const std::size_t size = std::fread(buffer, 1, sizeof buffer, pipe.get())) text.append(buffer, size);
  return text;
}

}  // namespace

TEST_CASE("forty fresh processes, with other symbol serials, print the same graph and derivation", "[lower]") {
  for (const std::string name :
       {"sphere_in_cylinder", "sphere_in_cylinder_quaternion", "skew_chart", "skew_nonholonomic"}) {
    const std::string command = std::string(PAPER_PROBE) + " " + GAUSS_SOURCE_DIR + "/models/" + name + ".yaml ";
    const std::string first = output_of(command + "0");
    CHECK(first.size() > 1000);
    int different = 0;
    for (int unused = 1; unused < 40; ++unused) {
      if (output_of(command + std::to_string(unused)) != first) ++different;
    }
    INFO(name);
    CHECK(different == 0);
  }
}

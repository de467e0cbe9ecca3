#include "sim/page/page.hpp"

#include "sim/page/machine.hpp"
#include "sim/report/report_template.hpp"
#include "version.hpp"

namespace gausssim {

namespace {

/// No name can end the element of the page that holds it.
std::string without_tags(const std::string& json) {
  std::string result;
  for (const char c : json) result += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return result;
}

}  // namespace

nlohmann::ordered_json head_of_study() {
  const Computer machine = this_machine();
  nlohmann::ordered_json json;
  json["format"] = 1;
  json["tool"] = std::string("gauss-sim ") + gaussgen::k_version;
  json["machine"] = {{"processor", machine.processor},
                     {"cores", machine.cores},
                     {"system", machine.system},
                     {"compiler", machine.compiler},
                     {"flags", machine.flags}};
  return json;
}

std::string page_of(const nlohmann::ordered_json& study) {
  std::string text(report_template());
  text.replace(text.find(report_placeholder), report_placeholder.size(), without_tags(study.dump()));
  return text;
}

}  // namespace gausssim

#include "sim/interpreter/type_text.hpp"

#include <string_view>

namespace gausssim {

TypeText type_in(std::string text) {
  TypeText type;
  const std::string_view k_const = "const ";
  if (text.rfind(k_const, 0) == 0) {
    type.is_const = true;
    text.erase(0, k_const.size());
  }
  if (!text.empty() && text.back() == '&') {
    type.is_reference = true;
    text.pop_back();
  }
  type.name = text == "typename Math<S>::Bool" ? "Bool" : text.substr(0, text.find('<'));
  return type;
}

ArrayName array_in(const std::string& text) {
  ArrayName array;
  const std::size_t bracket = text.find('[');
  array.name = text.substr(0, bracket);
  if (array.name.rfind("(&", 0) == 0) array.name = array.name.substr(2, array.name.size() - 3);
  for (std::size_t begin = bracket; begin < text.size();) {
    const std::size_t end = text.find(']', begin);
    array.extents.push_back(text.substr(begin + 1, end - begin - 1));
    begin = end + 1;
  }
  return array;
}

}  // namespace gausssim

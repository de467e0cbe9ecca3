// Prints the keys, the fixed words and the functions of the format as a dictionary of libFuzzer.

#include <iostream>
#include <set>
#include <string>

#include "model/format.hpp"
#include "model/functions.hpp"

namespace {

using namespace gaussgen::model;

class Words {
 public:
  void add(const std::string& word) {
    if (!word.empty()) words_.insert(word);
  }

  void add(const format::Map& map) {
    if (!seen_.insert(&map).second) return;
    for (const format::Key& key : map.keys) {
      add(key.name + ": ");
      add(key.value);
    }
  }

  void add(const format::Value& value) {
    for (const std::string& word : value.words) add(word);
    for (const format::Value& other : value.others) add(other);
    if (value.item) add(*value.item);
    if (value.map) add(*value.map);
  }

  void print() const {
    for (const std::string& word : words_) std::cout << '"' << word << "\"\n";
  }

 private:
  std::set<std::string> words_;
  std::set<const format::Map*> seen_;
};

}  // namespace

int main() {
  Words words;
  words.add(format::model_file());
  for (const std::string& name : function_names()) words.add(name + "(");
  for (const char* const sign : {"^(1/2)", "e308", "\\xEF\\xBB\\xBF", "\\xE2\\x88\\x92", "kg*m^2", "rad/s", "dot(",
                                 "\\x00", "<<: ", "&a ", "*a"})
    words.add(sign);
  words.print();
}

#pragma once
// Which words an option takes. A refusal is a sentence about the word, for the user; an empty one means that it is right.

#include <optional>
#include <string>
#include <vector>

namespace gaussgen::cli {

/// One of `choices`; otherwise says which there are, or which one was meant.
std::string refusal_of_choice(const std::string& word, const std::vector<std::string>& choices);

/// A C++ namespace such as acme::models. It goes into code as it is, so nothing else may come in with it.
/// A whole number, written in digits; nothing where it is none from `least` to `most`.
std::optional<long long> whole_number(const std::string& text, long long least, long long most);

std::string refusal_of_namespace(const std::string& text);

/// Empty if `text` may be the folder of `-o`. A name of a header is most likely meant as one, and would become a folder.
std::string refusal_of_folder(const std::string& text);

}  // namespace gaussgen::cli

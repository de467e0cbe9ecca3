// A derivation as Markdown, as LaTeX, and as plain text.

#include "lower/derivation.hpp"
#include "lower/latex_name.hpp"

namespace gaussgen::lower {

namespace {

/// Characters of LaTeX source after which a long sum goes on in the next line: roughly one printed line.
constexpr std::size_t k_line = 150;

/// left = first terms \\ &\quad further terms …
std::string aligned(const Formula& formula) {
  std::string body = formula.left.empty() ? "&" : formula.left + " &= ";
  std::size_t length = body.size();
  bool is_broken = false;
  for (const std::string& term : formula.right) {
    if (length > 20 && length + term.size() > k_line) {
      body += " \\\\\n&\\quad ";
      length = 0;
      is_broken = true;
    }
    body += term;
    length += term.size();
  }
  if (formula.left.empty()) body += " = 0";
  if (!is_broken) {
    const std::size_t mark = body.find('&');
    return body.erase(mark, 1);
  }
  return "\\begin{aligned}\n" + body + "\n\\end{aligned}";
}

std::string heading(const Section& section) {
  return section.title + (section.equation.empty() ? "" : " " + section.equation);
}

}  // namespace

std::string as_markdown(const Derivation& derivation) {
  std::string text = "# " + markdown_text(derivation.title) + "\n";
  if (!derivation.about.empty()) text += "\n" + markdown_text(derivation.about) + "\n";
  for (const Section& section : derivation.sections) {
    text += "\n## " + heading(section) + "\n\n" + section.words + "\n";
    for (const std::string& formula : section.general) text += "\n$$\n" + formula + "\n$$\n";
    if (!section.items.empty()) text += "\n";
    for (const Item& item : section.items) text += "- $" + item.symbol + "$: " + markdown_text(item.about) + "\n";
    for (const Formula& formula : section.formulas) text += "\n$$\n" + aligned(formula) + "\n$$\n";
  }
  return text;
}

namespace {

// A term that is wider than the page alone, such as b^{μi} over a large metric, is scaled down to it.
const char* const k_latex_preamble =
    "\\documentclass[a4paper]{article}\n\\usepackage[T1]{fontenc}\n\\usepackage[utf8]{inputenc}\n"
    "\\usepackage[margin=2cm]{geometry}\n\\usepackage{amsmath}\n\\usepackage{graphicx}\n\\allowdisplaybreaks\n"
    "\\newsavebox{\\formulabox}\n"
    "\\newcommand{\\fitted}[1]{\\sbox{\\formulabox}{$\\displaystyle #1$}%\n"
    "  \\ifdim\\wd\\formulabox>\\linewidth\\resizebox{\\linewidth}{!}{\\usebox{\\formulabox}}%\n"
    "  \\else\\usebox{\\formulabox}\\fi}\n";

}  // namespace

std::string as_latex(const Derivation& derivation) {
  std::string text = std::string(k_latex_preamble) + "\n\\title{" + latex_text(derivation.title) +
                     "}\n\\author{}\n\\date{}\n\n\\begin{document}\n\\maketitle\n";
  if (!derivation.about.empty()) text += "\n" + latex_text(derivation.about) + "\n";
  for (const Section& section : derivation.sections) {
    text += "\n\\section*{" + heading(section) + "}\n\n" + section.words + "\n";
    for (const std::string& formula : section.general) text += "\\[\n" + formula + "\n\\]\n";
    if (!section.items.empty()) {
      text += "\\begin{itemize}\n";
      for (const Item& item : section.items) text += "  \\item $" + item.symbol + "$: " + latex_text(item.about) + "\n";
      text += "\\end{itemize}\n";
    }
    for (const Formula& formula : section.formulas) text += "\\[\n\\fitted{" + aligned(formula) + "}\n\\]\n";
  }
  return text + "\n\\end{document}\n";
}

std::string as_plain_text(const Derivation& derivation) {
  std::string text = derivation.title + "\n";
  for (const Section& section : derivation.sections) {
    text += "\n" + heading(section) + "\n";
    for (const Item& item : section.items) text += "  " + item.plain + ": " + item.about + "\n";
    for (const Formula& formula : section.formulas) text += "  " + formula.plain + "\n";
  }
  return text;
}

}  // namespace gaussgen::lower

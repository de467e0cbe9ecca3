#pragma once

#include <string>

namespace gaussgen::lower {

/// A name as a formula shows it: chi is \chi, m1 is m_{1}, R_max is R_{\mathrm{max}}, amplitude is \mathit{amplitude}.
std::string latex_name(const std::string& name);

/// A user's words, with everything that LaTeX would act on taken literally.
std::string latex_text(const std::string& words);

/// Likewise for Markdown.
std::string markdown_text(const std::string& words);

}  // namespace gaussgen::lower

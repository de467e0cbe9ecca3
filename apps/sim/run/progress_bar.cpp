#include "sim/run/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace gausssim {

namespace {

constexpr int k_width = 30;
constexpr std::chrono::milliseconds k_pause(100);
constexpr std::chrono::milliseconds k_first_pause(300);  // what is done by then needs no bar

}  // namespace

ProgressBar::ProgressBar(bool is_wanted) : is_shown_(is_wanted && ::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() { clear(); }

void ProgressBar::clear() {
  if (is_drawn_) fmt::print(stderr, "\r\x1b[K");
  is_drawn_ = false;
}

void ProgressBar::show(double share, const std::string& text) {
  if (!is_shown_) return;
  const auto now = Clock::now();
  if (now - begin_ < k_first_pause || now - last_ < k_pause) return;
  last_ = now;
  const int filled = static_cast<int>(std::clamp(share, 0.0, 1.0) * k_width);
  const double seconds = std::chrono::duration<double>(now - begin_).count();
  const double left = share > 0 ? seconds * (1 - share) / share : 0;
  draw(fmt::format("[{:#<{}}{:.<{}}] {:3.0f} %  {}  {:.0f} s left", "", filled, "", k_width - filled, 100 * share, text,
                   left));
}

void ProgressBar::say(const std::string& text) {
  if (is_shown_) draw(text);
}

void ProgressBar::draw(const std::string& line) {
  is_drawn_ = true;
  fmt::print(stderr, "\r\x1b[K{}", line);
  std::fflush(stderr);
}

}  // namespace gausssim

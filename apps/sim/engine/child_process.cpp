#include "sim/engine/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

namespace gausssim {

namespace {

constexpr std::chrono::milliseconds k_pause(20);
/// Time to remove what it has in the temporary folder.
constexpr std::chrono::seconds k_grace(2);

class Child {
 public:
  explicit Child(const std::vector<std::string>& words) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
    output_ = ends[0];
    is_started_ = start(words, ends[1]);
    ::close(ends[1]);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (output_ >= 0) ::close(output_);
  }

  bool is_started() const { return is_started_; }

  /// All that is said by the group within this time; false when nobody is left to say anything.
  bool listen(std::chrono::milliseconds time, std::string& said) const {
    pollfd wanted{output_, POLLIN, 0};
    if (::poll(&wanted, 1, static_cast<int>(time.count())) <= 0) return true;
    std::array<char, 4096> block{};
    const ssize_t count = ::read(output_, block.data(), block.size());
    if (count < 0) return errno == EINTR;
    said.append(block.data(), static_cast<std::size_t>(count));
    return count > 0;
  }

  /// Whether it is over.
  bool look() {
    if (!is_over_) is_over_ = ::waitpid(id_, &status_, WNOHANG) == id_;
    return is_over_;
  }

  void end(int signal) const { ::kill(-id_, signal); }

  int status() const { return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1; }

 private:
  bool start(const std::vector<std::string>& words, int output) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const int error = ::posix_spawn(&id_, words.front().c_str(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error == 0;
  }

  pid_t id_ = 0;
  int output_ = -1, status_ = 0;
  bool is_started_ = false, is_over_ = false;
};

/// The group of a child that is not waited for yet: its number belongs to nobody else.
void end_group(Child& child) {
  child.end(SIGTERM);
  std::string unheard;
  bool goes_on = true;
  const auto last = std::chrono::steady_clock::now() + k_grace;
  while (goes_on && std::chrono::steady_clock::now() < last) goes_on = child.listen(k_pause, unheard);
  child.end(SIGKILL);
  while (!child.look()) std::this_thread::sleep_for(k_pause);
}

}  // namespace

Finished run_program(const std::vector<std::string>& words, const std::function<bool()>& ends) {
  Finished result;
  Child child(words);
  if (!child.is_started()) return result.said = "it cannot be started", result;
  bool is_heard = true;
  while (is_heard || !child.look()) {
    if (is_heard) {
      is_heard = child.listen(k_pause, result.said);
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (!ends()) continue;
    end_group(child);
    result.was_ended = true;
    return result;
  }
  result.status = child.status();
  return result;
}

}  // namespace gausssim

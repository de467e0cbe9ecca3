// launch PROGRAM ARGUMENTS…: runs it and says what it took, as a line of JSON in the file that $LAUNCH_REPORT names. A small program
// of its own, since the memory of whoever starts a process counts as that of the process.

#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

extern char** environ;

int main(int argc, char** argv) {
  const char* const report = std::getenv("LAUNCH_REPORT");
  if (argc < 2 || report == nullptr) return 2;
  const auto begin = std::chrono::steady_clock::now();
  pid_t child = 0;
  if (posix_spawn(&child, argv[1], nullptr, nullptr, argv + 1, environ) != 0) return 127;
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child) return 127;
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  std::FILE* const file = std::fopen(report, "w");
  if (file == nullptr) return 127;
  std::fprintf(file, "{\"wall\": %.6f, \"cpu\": %.6f, \"memory\": %ld}\n", wall,
               seconds(usage.ru_utime) + seconds(usage.ru_stime), usage.ru_maxrss);
  std::fclose(file);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

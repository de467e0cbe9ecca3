#include "sim/engine/plugin.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "sim/engine/plugin_text.hpp"
#include "sim/engine/work_folder.hpp"
#include "support/content_hash.hpp"

namespace gausssim {

namespace {

namespace fs = std::filesystem;

/// Nothing of what is no file.
std::string content_of(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return "";
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

/// Of what was compiled, at the end of the text that it was compiled from: what a full disk or a power cut has left of it is not loaded.
std::string seal(const fs::path& library) {
  return fmt::format("// {}\n", gaussgen::support::content_hash(content_of(library)));
}

bool holds(const fs::path& folder, const std::string& text) {
  std::error_code error;
  const fs::path source = folder / "model.cpp";
  if (fs::file_size(source, error) <= text.size() || error) return false;
  const std::string kept = content_of(source);
  return kept.compare(0, text.size(), text) == 0 && kept.substr(text.size()) == seal(folder / "model.so");
}

/// Into a folder under its final name, both files together: another process sees the whole or nothing.
void keep(const WorkFolder& work, const fs::path& folder) {
  std::error_code error;
  std::ofstream(work / "model.cpp", std::ios::binary | std::ios::app) << seal(work / "model.so");
  fs::create_directories(folder, error);
  for (const char* const name : {"model.so", "model.cpp"})
    if (fs::is_directory(folder / name, error)) fs::remove_all(folder / name, error);
  fs::rename(work / "model.so", folder / "model.so", error);
  if (!error) fs::rename(work / "model.cpp", folder / "model.cpp", error);
}

std::string first_lines(const std::string& text, int count) {
  std::size_t end = 0;
  for (; count > 0 && end < text.size(); --count) end = std::min(text.find('\n', end), text.size() - 1) + 1;
  return text.substr(0, end);
}

Built compiled(const std::string& text, const Toolchain& toolchain, const fs::path& cache, const fs::path& folder,
               const std::function<bool()>& ends) {
  Built built;
  const WorkFolder work(cache);
  if (!work.is_there()) return built.why = "no folder can be made to compile in", built;
  const fs::path file = work / "model.cpp";
  errno = 0;
  std::ofstream source(file, std::ios::binary);
  source << text;
  source.close();
  if (!source) return built.why = fmt::format("{} cannot be written: {}", file.string(), std::strerror(errno)), built;
  const auto begin = std::chrono::steady_clock::now();
  const auto [failure, was_ended] = compile(toolchain, file, work / "model.so", ends);
  built.compile_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  built.was_ended = was_ended;
  if (was_ended) return built.why = "it was ended", built;
  if (failure) {
    built.why = fmt::format("{} fails: {}", toolchain.compiler, first_lines(*failure, 5));
    return built;
  }
  // Loaded from where it was made: nobody else writes there.
  built.plugin = Plugin::load(work / "model.so", built.why);
  if (built.plugin && !folder.empty()) keep(work, folder);
  return built;
}

}  // namespace

std::shared_ptr<const Plugin> Plugin::load(const std::string& path, std::string& why) {
  void* const handle = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    const char* const error = ::dlerror();
    why = error == nullptr ? "it cannot be loaded" : error;
    return nullptr;
  }
  return std::shared_ptr<const Plugin>(new Plugin(handle));
}

Plugin::~Plugin() { ::dlclose(handle_); }

Entry Plugin::find(const std::string& function, const std::string& scalar) const {
  void* const symbol = ::dlsym(handle_, entry_symbol(function, scalar).c_str());
  return {reinterpret_cast<Entry::Call>(symbol), nullptr};
}

std::string cache_folder() {
  const char* const cache = std::getenv("XDG_CACHE_HOME");
  if (cache != nullptr && *cache == '/') return std::string(cache) + "/gauss";
  const char* const home = std::getenv("HOME");
  return home != nullptr && *home == '/' ? std::string(home) + "/.cache/gauss" : std::string();
}

Built PluginShelf::get(const std::string& text, const Toolchain& toolchain, const std::function<bool()>& ends) {
  const std::scoped_lock lock(mutex_);
  std::shared_ptr<const Plugin>& known = plugins_[text];
  if (known) {
    Built built;
    built.plugin = known;
    built.was_cached = true;
    return built;
  }
  Built built = build_plugin(text, toolchain, ends);
  known = built.plugin;
  return built;
}

Built build_plugin(const std::string& text, const Toolchain& toolchain, const std::function<bool()>& ends) {
  const fs::path cache = cache_folder();
  const std::string whole = text + "\n/*\n" + toolchain.identity() + "*/\n";
  const fs::path folder = cache.empty() ? fs::path() : cache / gaussgen::support::content_hash(whole);
  if (!folder.empty() && holds(folder, whole)) {
    Built built;
    built.was_cached = true;
    built.plugin = Plugin::load(folder / "model.so", built.why);
    if (built.plugin) return built;
  }
  return compiled(whole, toolchain, cache, folder, ends);
}

}  // namespace gausssim

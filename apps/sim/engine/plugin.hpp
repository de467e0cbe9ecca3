#pragma once
// A compiled model.

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "sim/engine/entry.hpp"
#include "sim/engine/toolchain.hpp"

namespace gausssim {

/// A shared library that is loaded as long as this lives.
class Plugin {
 public:
  /// Null, with the reason in `why`, where it cannot be loaded.
  static std::shared_ptr<const Plugin> load(const std::string& path, std::string& why);

  Plugin(const Plugin&) = delete;
  Plugin& operator=(const Plugin&) = delete;
  ~Plugin();

  /// Of function and number type; an empty one where the model has none.
  Entry find(const std::string& function, const std::string& scalar) const;

 private:
  explicit Plugin(void* handle) : handle_(handle) {}

  void* handle_;
};

/// What it took to have a plugin.
struct Built {
  std::shared_ptr<const Plugin> plugin;  ///< null: `why`
  std::string why;
  bool was_cached = false;
  bool was_ended = false;  ///< by `ends`, while it was compiled
  double compile_seconds = 0;
};

/// The plugin of a text, from the cache or compiled now. The cache is $XDG_CACHE_HOME/gauss, else ~/.cache/gauss; what is in it is used only if its text is
/// the same to the byte.
Built build_plugin(const std::string& text, const Toolchain& toolchain, const std::function<bool()>& ends);

/// Libraries that bodies of one scene share, by their text: each is looked for once, whether there is a cache or not.
class PluginShelf {
 public:
  /// As build_plugin.
  Built get(const std::string& text, const Toolchain& toolchain, const std::function<bool()>& ends);

 private:
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const Plugin>> plugins_;
};

/// The folder; empty where there is no home.
std::string cache_folder();

}  // namespace gausssim

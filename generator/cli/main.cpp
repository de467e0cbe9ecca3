#include <clocale>
#include <csignal>
#include <exception>
#include <locale>
#include <new>

#include "cli/assignments.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/guard.hpp"
#include "cli/overrides.hpp"
#include "support/assert.hpp"

namespace gaussgen::cli {

namespace {

int run(const Options& options) {
  if (options.man) return manual();
  switch (options.command) {
    case Command::generate: return generate(options);
    case Command::evaluate: return evaluate(options);
    case Command::linearize: return linearize(options);
    case Command::derivation: return derive(options);
    case Command::explain: return explain(options);
    case Command::init: return init(options);
    case Command::schema: return schema();
    case Command::completion: return completion(options);
  }
  return k_internal_error;
}

int guarded(const Options& options) {
  const auto fail = [&](const std::string& what, int code) { return cli::fail(what, code, options.messages); };
  try {
    return run(options);
  } catch (const FileError& error) {
    return fail(error.what(), k_file_error);
  } catch (const UsageError& error) {
    return cli::fail(error, options.messages);
  } catch (const model::UnknownCount& unknown) {
    return fail(unknown_count(unknown), k_usage_error);
  } catch (const model::WrongRegime& wrong) {
    return fail(std::string("--regime: ") + wrong.what(), k_usage_error);
  } catch (const model::WrongEffects& wrong) {
    return fail(wrong_effects(wrong, options.pipeline.choices.effects), k_usage_error);
  } catch (const ir::TooManyNodes& error) {
    return fail(std::string("the model is too large: ") + error.what(), k_too_large);
  } catch (const std::bad_alloc&) {
    return fail("the model is too large for the memory of this machine", k_too_large);
  } catch (const std::exception& error) {
    return fail(std::string("internal error, please report it with the model: ") + error.what(), k_internal_error);
  }
}

}  // namespace

}  // namespace gaussgen::cli

int main(int argc, char** argv) {
  // A comma locale changes what GiNaC prints and what yaml-cpp reads; the classic one is the same everywhere.
  std::setlocale(LC_ALL, "C");
  std::locale::global(std::locale::classic());
  gaussgen::cli::limit_memory();
  std::signal(SIGXFSZ, SIG_IGN);  // beyond a limit on files, writing fails with a message
  int exit_code = 0;
  const auto options = gaussgen::cli::parse_options(argc, argv, exit_code);
  return options ? gaussgen::cli::guarded(*options) : exit_code;
}

#pragma once
// Runs the functions of an emitted header without a compiler: the tree that the header is printed from, as instructions over one array of scalars. Results are the
// bits of the printed program, compiled with -ffp-contract=off: the same operations in the same order, by the same gauss::Math<S>.

#include <memory>
#include <string_view>
#include <vector>

#include "emit/cpp_tree.hpp"
#include "gauss/math.hpp"
#include "sim/interpreter/not_runnable.hpp"
#include "sim/interpreter/program.hpp"

namespace gausssim {

/// S: float, double, long double, and __float128 with GCC. It may be shared by threads, each with a frame of its own.
template <class S>
class Interpreter {
 public:
  /// What a call works in: for one thread, and for any function. It belongs to the interpreter that made it and to its copies.
  class Frame {
   public:
    Frame() = default;

   private:
    friend class Interpreter;
    std::vector<S> slots_;
    std::vector<S*> arguments_;
  };

  /// Compiles all functions of a header. Throws NotRunnable where there are no instructions for something in it.
  explicit Interpreter(const gaussgen::emit::cpp::File& tree);
  /// Of a program that was compiled for another scalar type, too.
  explicit Interpreter(std::shared_ptr<const Program> program);

  /// Names of functions, with their parameters, and of structs, with their members.
  const Program& program() const noexcept { return *program_; }

  /// -1: there is none.
  int find(std::string_view function) const { return program_->find(function); }
  /// Scalars in a struct, which are in the order of the C++ struct; 0 where there is none of this name.
  std::size_t size_of(std::string_view type) const;

  Frame frame() const;

  /// `arguments` in the order of the parameters, each to the first scalar of the struct; of what a function returns by value, last. A result may be an
  /// argument where emitted code allows it. Nothing is allocated.
  gauss::Status call(int function, S* const* arguments, Frame& frame) const noexcept;

 private:
  std::shared_ptr<const Program> program_;
};

}  // namespace gausssim

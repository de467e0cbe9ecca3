#pragma once
// A model in other coordinates: x_i = Σ A_ij p_j + b_i + c_i sin(p_k) + d_i t for its free coordinates, which keep their names.

#include <random>

#include "../models.hpp"

namespace agreement::newton {

class Change {
 public:
  enum class Kind { affine, curved };

  /// Coefficients are thousandths, so that they are the same in the model and in double as far as double goes. Coordinates whose rates
  /// stand in the state and those that speeds move are changed among themselves.
  Change(const gaussgen::model::Model& model, Kind kind, unsigned seed);

  /// Written with expressions of the new coordinates where the old ones stood.
  gaussgen::model::Model of(gaussgen::model::Model model) const;

  /// The old state that a new one stands for. Speeds and quaternions are the same in both.
  State old_state(const State& state) const;

 private:
  struct Row {
    std::size_t coordinate = 0;  ///< into Model::coordinates
    bool has_speed = false;
    std::vector<int> factors;  ///< by rows
    int shift = 0;
    int bend = 0;             ///< of the sine
    std::size_t bent_by = 0;  ///< the row in the sine
    int drift = 0;            ///< of time
  };

  gaussgen::model::Ast expression(const Row& row) const;
  gaussgen::model::Ast derivative(const Row& row, std::size_t by) const;
  gaussgen::model::Ast symbol(std::size_t row) const;
  void rewrite(gaussgen::model::Ast& ast) const;
  void rewrite(std::array<gaussgen::model::Ast, 3>& vector) const;
  void rewrite(gaussgen::model::Constraint& constraint) const;
  void rewrite(gaussgen::model::Force& force) const;
  gaussgen::model::GeneralizedForce spread(const gaussgen::model::GeneralizedForce& law) const;

  std::vector<Row> rows_;
  std::vector<std::string> names_;  ///< by rows
};

}  // namespace agreement::newton

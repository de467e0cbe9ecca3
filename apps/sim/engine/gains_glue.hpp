// Baumgarte's gains behind plain functions: a part of plugins, compiled with the model, whose sizes are known there.
// SPDX-License-Identifier: MIT
#include "gauss/integrate/bound_model.hpp"
#include "gauss/integrate/stabilised.hpp"

namespace gauss_sim_glue {

/// `Type` is made by GAUSS_MODEL.
template <class Type, class S, class Residuals, class Metric>
class PulledBack {
  using Prepared = typename Type::template Prepared<S>;
  using Inputs = typename Type::template Inputs<S>;
  using Base = decltype(gauss::integrate::bind_model<Type, S>(*static_cast<const Prepared*>(nullptr),
                                                              *static_cast<const Inputs*>(nullptr)));
  using Model = gauss::integrate::Stabilised<Base, Residuals, Metric>;

 public:
  /// Both gains are the same: violations decay without a swing.
  PulledBack(const void* prepared, const void* inputs, const S& gain, int usual_rank)
      : model_(gauss::integrate::bind_model<Type, S>(*static_cast<const Prepared*>(prepared),
                                                     *static_cast<const Inputs*>(inputs)),
               gauss::integrate::Gains<S>(gain, gain), usual_rank) {}

  static int begin(int usual_rank, void* const* a) {
    *static_cast<void**>(a[0]) = new PulledBack(a[1], a[2], *static_cast<const S*>(a[3]), usual_rank);
    return 0;
  }
  static int rates(const void* self, void* const* a) {
    const PulledBack& pulled = *static_cast<const PulledBack*>(self);
    return static_cast<int>(pulled.model_.derivative(*static_cast<const S*>(a[0]),
                                                     *static_cast<const typename Model::State*>(a[1]),
                                                     *static_cast<typename Model::Derivative*>(a[2])));
  }
  static int end(void* const* a) {
    delete static_cast<PulledBack*>(a[0]);
    return 0;
  }

 private:
  Model model_;
};

}  // namespace gauss_sim_glue

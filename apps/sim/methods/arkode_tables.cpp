#include "sim/methods/arkode_tables.hpp"

#include <algorithm>

#include "sim/methods/settings.hpp"

namespace gausssim {

const std::vector<NamedTable>& arkode_tables() {
  const auto implicit = [](ARKODE_DIRKTableID id) { return ArkodeTable{id, ARKODE_ERK_NONE}; };
  const auto explicit_one = [](ARKODE_ERKTableID id) { return ArkodeTable{ARKODE_DIRK_NONE, id}; };
  // By ARKStep, also those that are explicit: ERKStep of 6.4.1 comes down to order 3 or 2 with VERNER_8_5_6, ARK548L2SA_ERK_8_4_5 and SAYFY_ABURUB_6_3_4, whose coefficients are
  // right, and it seems to take a last stage at the end of a step for the first one of the next. tests/sim/methods measures both.
  static const std::vector<NamedTable> k_tables{
      {"arkode_bogacki_shampine", 3, explicit_one(ARKODE_BOGACKI_SHAMPINE_4_2_3)},
      {"arkode_zonneveld", 4, explicit_one(ARKODE_ZONNEVELD_5_3_4)},
      {"arkode_cash_karp", 5, explicit_one(ARKODE_CASH_KARP_6_4_5)},
      {"arkode_fehlberg", 5, explicit_one(ARKODE_FEHLBERG_6_4_5)},
      {"arkode_dormand_prince", 5, explicit_one(ARKODE_DORMAND_PRINCE_7_4_5)},
      {"arkode_verner", 6, explicit_one(ARKODE_VERNER_8_5_6)},
      {"arkode_fehlberg78", 8, explicit_one(ARKODE_FEHLBERG_13_7_8)},
      {"arkode_trbdf2", 2, implicit(ARKODE_TRBDF2_3_3_2)},
      {"arkode_esdirk4", 4, implicit(ARKODE_ESDIRK436L2SA_6_3_4)},
      {"arkode_kvaerno5", 5, implicit(ARKODE_KVAERNO_7_4_5)}};
  return k_tables;
}

Made<double> make_arkode(const Problem<double>& problem, const std::string& method) {
  const auto& all = arkode_tables();
  const auto found = std::find_if(all.begin(), all.end(), [&](const NamedTable& one) { return one.method == method; });
  if (found == all.end()) return nullptr;
  return std::make_unique<Arkode>(problem.model, problem.start, problem.t, settings_of(problem), found->table);
}

}  // namespace gausssim

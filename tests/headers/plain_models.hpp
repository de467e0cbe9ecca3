#pragma once
// Every model, as emitted by default.

#include "plain_headers.inc"
#include "tested_model.hpp"

#define GAUSS_TESTED_MODEL(name_space) GAUSS_MAKE_TESTED(name_space)
#include "plain_models.inc"
#undef GAUSS_TESTED_MODEL

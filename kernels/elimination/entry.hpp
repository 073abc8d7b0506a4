// The general solver as the rest sees it; compiled on its own (general.cpp), once per instruction set.
#pragma once

#include <cstdint>

namespace pieper::PIEPER_ISA {

// A SolveFn (isa.hpp); params are what `general_model` wrote.
void solve_general(const double* params, const int* iparams, const double* T, long count, double* q, std::uint8_t* valid,
                   std::uint8_t* flag);

// Number of doubles of a model, and of its record of trials.
inline constexpr int kGeneralTrials = 24 * 4;
long general_model_size();

// Makes the model of a six-joint chain. links: 7 x 16 row-major, m; scale: m per unit used inside. `trials` gets, for every
// hand-out of roles (shift, direction, swap), rank (1 the best way, 0 of no use), solutions missed, eigenvalues left open, noise.
// Returns how many variants are of use; 0 means that the arm is beyond this solver.
int general_model(const double* links, const std::uint8_t* prismatic, double scale, double* params, double* trials);

}  // namespace pieper::PIEPER_ISA

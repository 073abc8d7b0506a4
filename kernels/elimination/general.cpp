// Compiles the general solver for one instruction set; see CMakeLists.txt.
#include "elimination/entry.hpp"

#include "elimination/general.hpp"

namespace pieper::PIEPER_ISA {

long general_model_size() { return static_cast<long>((sizeof(general::Model) + sizeof(double) - 1) / sizeof(double)); }

int general_model(const double* links, const std::uint8_t* prismatic, double scale, double* params, double* trials) {
  general::Model& model = *reinterpret_cast<general::Model*>(params);
  general::Trial record[general::kTried];
  general::make_model(links, prismatic, scale, model, record);
  for (int i = 0; i < general::kTried; ++i) {
    trials[4 * i] = record[i].rank;
    trials[4 * i + 1] = record[i].missed;
    trials[4 * i + 2] = record[i].open;
    trials[4 * i + 3] = record[i].noise;
  }
  return model.variants;
}

}  // namespace pieper::PIEPER_ISA

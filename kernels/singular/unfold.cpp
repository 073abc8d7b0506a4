// The work of `unfold`. Compiled once, for the plainest processor.
#include "singular/unfold.hpp"

#include "singular/unfolding.hpp"

namespace pieper {

using namespace PIEPER_ISA;

int unfold(const PlainChain& chain, int joints, const double* mixed, const double* T, double* q) {
  std::vector<Rigid> links(chain.n + 1);
  for (int k = 0; k <= chain.n; ++k) links[k] = read_rigid(chain.links + 16 * k, chain.length);
  const UnfoldedChain unfolded = {chain.n, joints, links.data(), chain.prismatic, mixed};
  const Unfolded root = Unfolding(unfolded, read_rigid(T, chain.length)).root(q, kMergedSame);
  std::copy(root.q, root.q + joints, q);
  return root.branches;
}

}  // namespace pieper

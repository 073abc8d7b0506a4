// Which instruction set this processor and its operating system offer, and the build of the kernels for it.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "dispatch/isa.hpp"

#if defined(__x86_64__) || defined(__i386__)
#include <cpuid.h>
#define PIEPER_X86 1
#endif

namespace pieper {
namespace {

struct Features {
  bool avx2 = false, avx512 = false;
};

#ifdef PIEPER_X86
// What registers the operating system saves on a task switch: bit 1 SSE, 2 AVX, 5..7 AVX-512.
std::uint64_t saved_registers() {
  std::uint32_t low, high;
  __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  return (static_cast<std::uint64_t>(high) << 32) | low;
}

Features features() {
  Features found;
  unsigned a, b, c, d;
  if (!__get_cpuid(1, &a, &b, &c, &d)) return found;
  const bool osxsave = c & (1u << 27), fma = c & (1u << 12), avx = c & (1u << 28);
  if (!osxsave || !avx) return found;
  const std::uint64_t saved = saved_registers();
  if ((saved & 0x6) != 0x6) return found;
  if (!__get_cpuid_count(7, 0, &a, &b, &c, &d)) return found;
  found.avx2 = fma && (b & (1u << 5));
  const unsigned needed = (1u << 16) | (1u << 17) | (1u << 30) | (1u << 31);  // F, DQ, BW, VL
  found.avx512 = found.avx2 && (b & needed) == needed && (saved & 0xe6) == 0xe6;
  return found;
}
#else
Features features() { return {}; }
#endif

// The builds that this module holds and this processor runs, widest first.
struct Build {
  const char* name;
  const IsaTable& (*table)();
};
const std::vector<Build>& builds() {
  static const std::vector<Build> all = [] {
    std::vector<Build> found;
    [[maybe_unused]] const Features has = features();
#ifdef PIEPER_WITH_AVX512
    if (has.avx512) found.push_back({"avx512", &isa_avx512});
#endif
#ifdef PIEPER_WITH_AVX2
    if (has.avx2) found.push_back({"avx2", &isa_avx2});
#endif
#ifdef PIEPER_WITH_BASELINE
    found.push_back({"baseline", &isa_baseline});
#endif
    return found;
  }();
  return all;
}

const IsaTable& choose() {
  const char* wanted = std::getenv("PIEPER_ISA");
  for (const Build& build : builds())
    if (!wanted || !*wanted || std::strcmp(wanted, build.name) == 0) return build.table();
  throw std::runtime_error(std::string("PIEPER_ISA is '") + (wanted ? wanted : "") +
                           "'; this processor and build offer: " + isa_names() +
                           ". Unset it to have the widest chosen.");
}

}  // namespace

const IsaTable& isa() {
  static const IsaTable& chosen = choose();
  return chosen;
}

const char* isa_names() {
  static const std::string names = [] {
    std::string text;
    for (auto build = builds().rbegin(); build != builds().rend(); ++build)
      text += (text.empty() ? "" : " ") + std::string(build->name);
    return text;
  }();
  return names.c_str();
}

}  // namespace pieper

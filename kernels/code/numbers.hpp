// A family's geometry read from one row of numbers, in the order of its fields: how an arm comes to where there is no Python.
#pragma once

#include "dispatch/geometry.hpp"

namespace pieper {

// Reads numbers one after the other into whatever a field may be; truths and whole numbers are numbers as well.
struct Numbers {
  const double* next;

  double one() { return *next++; }
  void put(double& to) { to = one(); }
  void put(bool& to) { to = one() != 0; }
  void put(int& to) { to = static_cast<int>(one()); }
  void put(Vector& to) { to = {next[0], next[1], next[2]}, next += 3; }
  void put(Choice& to) {
    put(to.count);
    for (int& at : to.at) put(at);
  }
  template <class X, int N> void put(X (&to)[N]) {
    for (X& x : to) put(x);
  }
  // What is referred to is handed over by itself.
  void put(const General*&) {}
};

// Fills a geometry; `general` goes where it refers to one.
template <class Own> void read_numbers(Own& own, const double* numbers, const General* general) {
  Numbers from{numbers};
  Own::fields(own, [&](const char*, auto& field) { from.put(field); });
  if constexpr (requires { own.general; }) own.general = general;
}

}  // namespace pieper

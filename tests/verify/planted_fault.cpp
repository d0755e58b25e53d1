// SPDX-License-Identifier: MIT
//
// `detent verify` alone; planted_fault.sh links it with a faulty copy of the library.

#include "verify.hpp"

int main() { return detent::cli::verify({}) ? 0 : 1; }

// SPDX-License-Identifier: MIT
//
// Start-up code of a classic Arm core (ARMv4T: no Cortex, no division, no unaligned loads) for
// qemu-arm, which emulates such cores only in user mode. Semihosting is the only system call.

#include "semihosting.hpp"

std::intptr_t semihost(std::intptr_t operation, const void* argument) {
  register std::intptr_t r0 __asm__("r0") = operation;
  register const void* r1 __asm__("r1") = argument;
#ifdef __thumb__
  __asm__ volatile("svc 0xab" : "+r"(r0) : "r"(r1) : "memory", "lr");
#else
  __asm__ volatile("svc 0x123456" : "+r"(r0) : "r"(r1) : "memory", "lr");
#endif
  return r0;
}

extern "C" [[noreturn, gnu::used]] void run() { verify_and_leave(); }

// The loader enters in Arm state; bx switches to Thumb if `run` was compiled for it.
__asm__(
    ".arm\n"
    ".global _start\n"
    "_start:\n"
    "  ldr r0, =run\n"
    "  bx r0\n"
    "  .ltorg\n");
